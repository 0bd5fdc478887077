// Tests of `mjforge catalogue --html`.

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/command.h"

namespace mjforge {
namespace {

bool Has(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

// Fixture with specs in the search path that the word "galleried" finds.
class GalleryTest : public harness::ProgramTest {
 protected:
  GalleryTest() {
    folder().Write(
        "p/things/chest.yaml",
        "mjforge: 1\nname: chest\ndescription: Galleried chest.\n"
        "params: {width: {value: 0.2 .. 0.4, unit: m, doc: Of <the> base.}, twice: 2 * width}\n"
        "bodies:\n"
        "  - {name: base, parts: [{name: block, type: box, size: [0.1, width / 2, 0.1]}],\n"
        "     sites: [{name: grasp, pos: [0, 0, 0.1]}]}\n"
        "  - {name: lid, parent: base, pos: [0, 0, 0.1 + twice / 20],\n"
        "     parts: [{name: board, type: box, size: [0.1, width / 2, 0.01]}],\n"
        "     joints: [{name: hinge, type: hinge, axis: [0, -1, 0], pos: [-0.1, 0, 0],\n"
        "       range: [0, 110deg]}]}\n"
        "mjcf: {actuator: [{motor: {name: opener, joint: hinge}}]}\n");
    folder().Write("p/galleried_ball.yaml",
                   "mjforge: 1\nname: ball\nparts: [{name: b, type: sphere, size: 0.1}]\n");
  }

  harness::CommandResult Make(const std::string& place, std::vector<std::string> more = {},
                              std::map<std::string, std::string> environment = {}) const {
    more.insert(more.begin(), {"catalogue", "galleried", "--html", place});
    environment["MJFORGE_PATH"] = (folder() / "p").string();
    return Run(std::move(more), {}, std::move(environment));
  }
};

TEST_CASE_METHOD(GalleryTest, "a gallery is an index and a page per spec") {
  const auto result = Make("g");
  CHECK(result.status == 0);
  CHECK(result.out.empty());
  CHECK(result.err == "2 specs in g/index.html\n");
  const std::string index = folder().Read("g/index.html");
  CHECK(Has(index, "<a href=\"specs/things/chest.html\">chest</a>"));
  CHECK(Has(index, "<a href=\"specs/galleried_ball.html\">galleried_ball</a>"));
  CHECK(index.find("<h2 id=\"kind-1-title\">Things</h2>") <
        index.find("<h2 id=\"kind-2-title\">Others</h2>"));
  CHECK(Has(index, " kg, 2"));
  CHECK(Has(index, " cm, 1 joint</p>"));
  CHECK(Has(index, "alt=\"A variant of things/chest\" width=\"256\" height=\"256\""));

  const std::string page = folder().Read("g/specs/things/chest.html");
  CHECK(page.starts_with("<!doctype html>\n"));
  CHECK(Has(page, "<a href=\"../../index.html\">mjforge catalogue</a>"));
  CHECK(Has(page, "<code>mjforge generate things/chest -n 100 --seed 7 -o chest/</code>"));
  CHECK(Has(page, "alt=\"things/chest with hinge at 110 deg\""));
  CHECK(Has(page, "<dt>hinge</dt><dd>hinge, 0 to 110 deg</dd>"));
  CHECK(Has(page, "<dt>opener</dt><dd>motor</dd>"));
  CHECK(Has(page, "<dt>grasp</dt><dd>on base</dd>"));
  CHECK(Has(page, "<dt>robosuite</dt><dd>yes"));
  CHECK(Has(page, "<code>0.2 .. 0.4</code>"));
  CHECK(Has(page, "Of &lt;the&gt; base."));
  CHECK(Has(page, "Histogram of 20,000 values from 0.2 to 0.4"));
  CHECK(Has(page, "1 fixed or computed from others"));
  CHECK(Has(page, ">mjforge: 1\nname: chest\n"));
  CHECK(Has(folder().Read("g/specs/galleried_ball.html"), "<h1>galleried_ball</h1>"));
}

TEST_CASE_METHOD(GalleryTest, "the film of a joint begins with all others at their start") {
  folder().Write("p/galleried_pair.yaml",
                 "mjforge: 1\nname: pair\nparts: [{name: b, type: box, size: [0.1, 0.1, 0.01]}]\n"
                 "bodies:\n"
                 "  - {name: left, parts: [{name: l, type: sphere, size: 0.03}],\n"
                 "     pos: [0, 0, 0.05], joints: [{name: a, type: slide, axis: [0, 0, 1], "
                 "range: [0, 0.1]}]}\n"
                 "  - {name: right, parts: [{name: r, type: sphere, size: 0.03}],\n"
                 "     pos: [0, 0, 0.05], joints: [{name: b, type: slide, axis: [0, 0, 1], "
                 "range: [0, 0.1]}]}\n");
  REQUIRE(Make("g").status == 0);
  const std::string page = folder().Read("g/specs/galleried_pair.html");
  const auto first_frame = [&](const std::string& joint) {
    const std::size_t film = page.find("<section class=\"film\" aria-label=\"" + joint + "\"");
    REQUIRE(film != page.npos);
    const std::size_t begin = page.find("src=\"", film);
    return page.substr(begin, page.find("\" alt", begin) - begin);
  };
  CHECK(first_frame("a") == first_frame("b"));
}

TEST_CASE_METHOD(GalleryTest, "a gallery has the same bytes each time, with any number of jobs") {
  CHECK(Make("a", {"-q", "-j", "1"}).status == 0);
  CHECK(Make("b", {"-q", "-j", "3"}).status == 0);
  CHECK(Make("b", {"-q"}).status == 0);  // replaces the pages
  for (const char* file : {"index.html", "specs/things/chest.html", "specs/galleried_ball.html"}) {
    INFO(file);
    CHECK(folder().Read(std::string("a/") + file) == folder().Read(std::string("b/") + file));
  }
}

TEST_CASE_METHOD(GalleryTest,
                 "a broken spec has a finding and a card, and the others their pages") {
  folder().Write("p/galleried_typo.yaml",
                 "mjforge: 1\nname: typo\nparst: []\nparts: [{name: b, type: sphere, size: 1}]\n");
  folder().Write("p/galleried_zero.yaml",
                 "mjforge: 1\nname: zero\nparts: [{name: b, type: sphere, size: index - index}]\n");
  const auto result = Make("g");
  CHECK(result.status == 1);
  CHECK(Has(result.err, "galleried_typo.yaml:3:1: error: unknown key 'parst'"));
  CHECK(Has(result.err, "error: 'galleried_zero': "));
  CHECK(Has(result.err, "4 specs in g/index.html, 2 without a page\n"));
  const std::string index = folder().Read("g/index.html");
  CHECK(Has(index, "line 3: unknown key &#39;parst&#39;"));
  CHECK(Has(index, "<h3>galleried_typo</h3>"));
  CHECK(Has(index, "<h3>galleried_zero</h3>"));
  CHECK(Has(index, "specs/things/chest.html"));
  CHECK(std::filesystem::exists(folder() / "g/specs/things/chest.html"));
  CHECK_FALSE(std::filesystem::exists(folder() / "g/specs/galleried_typo.html"));
  CHECK_FALSE(std::filesystem::exists(folder() / "g/specs/galleried_zero.html"));
}

TEST_CASE_METHOD(GalleryTest, "a spec that takes too long loses only its own page") {
  folder().Write(
      "p/galleried_slow.yaml",
      "mjforge: 1\nname: slow\nparts:\n  - {for: {i: 39000}, name: \"b${i}\", type: box,\n"
      "     size: [1mm, 1mm, 1mm], pos: [i * 3mm, 0, 0]}\n");
  const auto result = Make("g", {"--time-limit", "1", "-j", "1"});
  CHECK(result.status == 1);
  CHECK(Has(result.err, "error: 'galleried_slow' took more than 1 s of CPU time"));
  CHECK(Has(folder().Read("g/index.html"), "&#39;galleried_slow&#39; took more than"));
  CHECK(std::filesystem::exists(folder() / "g/specs/galleried_ball.html"));
  CHECK(std::filesystem::exists(folder() / "g/specs/things/chest.html"));
}

TEST_CASE_METHOD(GalleryTest, "a foreign file in a gallery stays, unless it is forced away") {
  for (const std::string file : {"g/index.html", "h/specs/things/chest.html"}) {
    folder().Write(file, "<p>mine</p>");
    const std::string place = file.substr(0, 1);
    const auto refused = Make(place);
    CHECK(refused.status == 3);
    CHECK(refused.err == "mjforge: error: '" + file +
                             "' exists and was not made by mjforge [output/exists]\n"
                             "  hint: choose another place, or overwrite it with --force\n");
    CHECK(folder().Read(file) == "<p>mine</p>");
    CHECK_FALSE(std::filesystem::exists(folder() / place / "specs/galleried_ball.html"));
    CHECK(Make(place, {"--force", "-q"}).status == 0);
    CHECK(Has(folder().Read(file), "mjforge catalogue"));
  }
  folder().Write("file", "");
  CHECK(Make("file").status == 3);
  CHECK(Make("g", {"--json"}).status == 2);
  CHECK(Make("g", {"-j", "0"}).status == 2);
  CHECK(Make("").status == 2);
  for (const char* option : {"--force", "--jobs=2", "--time-limit=3"})
    CHECK(Run({"catalogue", option}).status == 2);
  const auto nothing = Run({"catalogue", "xyzzy", "--html", "none"});
  CHECK(nothing.status == 1);
  CHECK(Has(nothing.err, "no spec has 'xyzzy'"));
  CHECK_FALSE(std::filesystem::exists(folder() / "none"));
}

TEST_CASE_METHOD(GalleryTest, "without a renderer the pages have no pictures, with one warning") {
  const auto result = Make("g", {"-q"}, {{"MUJOCO_GL", "disable"}});
  CHECK(result.status == 0);
  CHECK(Has(result.err, "warning: cannot draw: MUJOCO_GL=disable turns drawing off"));
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 2);
  CHECK(Has(folder().Read("g/index.html"), "no picture"));
  CHECK(Has(folder().Read("g/specs/things/chest.html"), "Histogram of 20,000 values"));
}

TEST_CASE_METHOD(GalleryTest, "names with blanks and marks are quoted in links and commands") {
  folder().Write("p/odd & kind/galleried it's.yaml",
                 "mjforge: 1\nname: odd\ndescription: <script>\n"
                 "parts: [{name: b, type: sphere, size: 0.1}]\n");
  CHECK(Make("g", {"-q"}).status == 0);
  const std::string index = folder().Read("g/index.html");
  CHECK(Has(index, "href=\"specs/odd%20%26%20kind/galleried%20it%27s.html\""));
  CHECK_FALSE(Has(index, "<script>\n"));
  const std::string page = folder().Read("g/specs/odd & kind/galleried it's.html");
  CHECK(Has(page, "mjforge customize &#39;odd &amp; kind/galleried it&#39;\\&#39;&#39;s&#39;"));
}

}  // namespace
}  // namespace mjforge
