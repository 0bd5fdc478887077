// The page of the bundled specs and its pictures are of the specs as they are.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "docs/page.h"
#include "harness/command.h"
#include "harness/quick_settings.h"
#include "harness/source_folder.h"
#include "harness/temporary_folder.h"

namespace mjforge::docs {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kPictures = kRoot / "docs/pictures";
const std::string kHero = "scenes/worktop";
constexpr const char* kRemedy = "`./dev pictures` makes them again";

// What a picture is of.
struct Source {
  std::string spec;
  std::string sha256;

  friend bool operator==(const Source&, const Source&) = default;
};
using Sources = std::map<std::string, Source>;  // by the picture's name

json Ask(std::vector<std::string> arguments) {
  const harness::CommandResult result =
      harness::Command{.program = harness::MjforgeProgram(), .arguments = arguments}.Run();
  INFO(result.err);
  REQUIRE(result.status == 0);
  return json::parse(result.out);
}

json Inspect(const std::string& spec) {
  std::vector<std::string> arguments = {"inspect", spec, "--json"};
  for (std::string& option : harness::QuickOptions(spec)) arguments.push_back(std::move(option));
  return Ask(std::move(arguments));
}

std::string HashOf(const std::string& spec) {
  return Inspect(spec).at("spec_sha256").get<std::string>();
}

std::vector<std::string> BundledSpecs() {
  std::vector<std::string> names;
  for (const json& item : Ask({"catalogue", "--json"})) names.push_back(item.at("name"));
  return names;
}

// Recipes, whose specs stand on the page.
void AddCookbook(Sources& wanted) {
  const fs::path page = kRoot / "docs/cookbook.md";
  const harness::TemporaryFolder folder;
  for (const Step& step : ReadSteps(page)) {
    if (step.kind == Step::Kind::kFile) folder.Write(step.name, step.text);
  }
  for (const std::string& link : ReadLinks(page)) {
    if (!link.starts_with("pictures/")) continue;
    const std::string picture = fs::path(link).filename().string();
    const std::string spec = fs::path(link).stem().string() + ".yaml";
    wanted[picture] = {spec, HashOf((folder / spec).string())};
  }
}

// Scenes and reference objects have the names of other objects, so their pictures have the
// folder's name, too.
std::string PictureOf(const fs::path& spec) {
  const std::string folder = spec.parent_path().string();
  const std::string prefix = folder == "scenes" || folder == "robosuite" ? folder + "_" : "";
  return prefix + spec.filename().string() + ".webp";
}

// Returns the specs in the order of the page: by kind, primitives last.
std::vector<std::string> InPageOrder(std::vector<std::string> specs) {
  const auto key = [](const std::string& spec) {
    const std::string kind = fs::path(spec).parent_path().string();
    const int rank = kind == "robosuite" ? 1 : kind == "shapes" ? 2 : kind == "primitives" ? 3 : 0;
    return std::tuple(rank, spec);
  };
  std::ranges::sort(specs, {}, key);
  return specs;
}

// The pictures that there should be.
Sources Wanted() {
  Sources wanted = {
      {"hero.webp", {kHero, HashOf(kHero)}},
      {"ten.webp", {kHero, HashOf(kHero)}},
      {"materials.webp", {"samples.yaml", HashOf((kPictures / "samples.yaml").string())}}};
  for (const std::string& spec : BundledSpecs()) {
    wanted[PictureOf(spec)] = {spec, HashOf(spec)};
  }
  AddCookbook(wanted);
  return wanted;
}

// Those that there are, as the command that made them says.
Sources Made() {
  Sources made;
  const json hashes = json::parse(harness::ReadFile(kPictures / "catalogue.json"));
  for (const auto& [picture, source] : hashes.items()) {
    made[picture] = {source.at("spec"), source.at("sha256")};
  }
  return made;
}

// What is amiss, a line each.
std::vector<std::string> Stale(const Sources& made, const Sources& wanted) {
  std::vector<std::string> lines;
  for (const auto& [picture, source] : wanted) {
    const auto found = made.find(picture);
    if (found == made.end()) {
      lines.push_back(source.spec + " has no picture");
    } else if (found->second != source) {
      lines.push_back(source.spec + " has changed since " + picture + " was made");
    }
  }
  for (const auto& [picture, source] : made) {
    if (!wanted.contains(picture)) lines.push_back(picture + " is of no spec: " + source.spec);
  }
  return lines;
}

std::set<std::string> PictureFiles(const fs::path& folder = kPictures) {
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path file = entry.path();
    if (file.extension() == ".png" || file.extension() == ".webp")
      files.insert(file.filename().string());
  }
  return files;
}

// The page's chapters of the second level.
std::vector<std::string> Chapters(const fs::path& page) {
  static const std::regex kChapter("(?:^|\n)## ([^\n]+)");
  const std::string text = harness::ReadFile(page);
  std::vector<std::string> chapters;
  for (std::sregex_iterator chapter(text.begin(), text.end(), kChapter), end; chapter != end;
       ++chapter) {
    chapters.push_back((*chapter)[1]);
  }
  return chapters;
}

}  // namespace

TEST_CASE("a picture is stale when its spec has changed, is new or is gone") {
  const Sources wanted = {{"a.png", {"a", "1"}}, {"b.png", {"b", "2"}}};
  CHECK(Stale(wanted, wanted).empty());
  CHECK(Stale({{"a.png", {"a", "0"}}, {"c.png", {"c", "3"}}}, wanted) ==
        std::vector<std::string>{"a has changed since a.png was made", "b has no picture",
                                 "c.png is of no spec: c"});
}

TEST_CASE("the pictures are of the specs as they are") {
  const Sources wanted = Wanted();
  CHECK(wanted.size() > 20);
  for (const std::string& line : Stale(Made(), wanted)) FAIL_CHECK(line << "; " << kRemedy);

  std::set<std::string> names;
  for (const auto& [picture, source] : wanted) names.insert(picture);
  INFO(kRemedy);
  CHECK(PictureFiles() == names);

  std::set<std::string> specs;
  for (const std::string& spec : BundledSpecs()) specs.insert(PictureOf(spec));
  CHECK(PictureFiles(kPictures / "wall") == specs);
  CHECK(PictureFiles(kPictures / "large") == specs);
  for (const std::string& name : PictureFiles(kPictures / "moved")) {
    INFO(name);
    CHECK(specs.contains(name.substr(0, name.rfind('_')) + ".webp"));
  }
}

TEST_CASE("every bundled spec has its chapter and its picture on the page, and no other") {
  INFO(kRemedy);
  const fs::path page = kRoot / "docs/catalogue.md";
  const std::vector<std::string> specs = InPageOrder(BundledSpecs());
  std::vector<std::string> chapters = specs;
  chapters.insert(chapters.begin(), {"All at a glance", "About the chapters"});
  chapters.emplace_back("Materials");
  CHECK(Chapters(page) == chapters);
  const std::string text = harness::ReadFile(page);
  const std::string readme = harness::ReadFile(kRoot / "README.md");
  CHECK(text.find("](pictures/materials.webp)") != text.npos);
  for (const std::string& spec : specs) {
    const std::string picture = PictureOf(spec);
    INFO(spec);
    for (const char* folder : {"wall/", "large/", ""})
      CHECK(text.find("<img src=\"pictures/" + (folder + picture) + "\"") != text.npos);
    CHECK(readme.find("<img src=\"docs/pictures/wall/" + picture + "\"") != readme.npos);
    const json inspected = Inspect(spec);
    CHECK(text.find(inspected.at("description").get<std::string>()) != text.npos);
    for (const json& parameter : inspected.at("parameters")) {
      CHECK(text.find("| `" + parameter.at("name").get<std::string>() + "` |") != text.npos);
    }
  }
}

TEST_CASE("the front page opens with a picture and ten variants of it") {
  const std::string text = harness::ReadFile(kRoot / "README.md");
  for (const char* picture : {"](docs/pictures/hero.webp)", "src=\"docs/pictures/ten.webp\""})
    CHECK(text.find(picture) < text.find("\n## "));
}

TEST_CASE("every picture says in words what it shows") {
  std::vector<fs::path> pages = {kRoot / "README.md"};
  for (const auto& entry : fs::directory_iterator(kRoot / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  static const std::regex kImage(
      R"re(!\[([^\]]*)\]\(([^)\s]+)\)|<img src="pictures/(?:large|moved)/[^>]*alt="([^"]*)")re");
  int pictures = 0;
  for (const fs::path& page : pages) {
    const std::string text = harness::ReadFile(page);
    for (std::sregex_iterator image(text.begin(), text.end(), kImage), end; image != end; ++image) {
      INFO(page.filename().string() << ": " << (*image)[0].str());
      ++pictures;
      CHECK((*image)[1].length() + (*image)[3].length() >= 20);
    }
  }
  CHECK(pictures > 20);
}

// A clone should stay quick, and a page on a phone.
TEST_CASE("the pictures are small") {
  std::uintmax_t total = 0;
  for (const char* folder : {"", "wall", "large", "moved"}) {
    for (const std::string& name : PictureFiles(kPictures / folder)) {
      INFO(folder << " " << name);
      const std::uintmax_t size = fs::file_size(kPictures / folder / name);
      CHECK(size > (name.ends_with(".webp") ? 500 : 10'000));
      CHECK(size < 240'000);
      total += size;
    }
  }
  CHECK(total < 13'000'000);
}

TEST_CASE("the page of the bundled specs says what each of them requires") {
  const std::string page = harness::ReadFile(kRoot / "docs/catalogue.md");
  constexpr std::string_view kStart = "\nrequire:\n";
  int count = 0;
  for (const std::string& name : BundledSpecs()) {
    const std::string text = harness::ReadFile(kRoot / "specs" / (name + ".yaml"));
    CHECK(text.find("\nrequire: ") == std::string::npos);  // the page has a line for each
    const std::size_t at = text.find(kStart);
    if (at == std::string::npos) continue;
    std::istringstream lines(text.substr(at + kStart.size()));
    for (std::string line; std::getline(lines, line) && line.starts_with("  "); ++count) {
      INFO(name << ": " << line);
      CHECK(page.find("\n" + line.substr(2) + "\n") != std::string::npos);
    }
  }
  CHECK(count > 30);
}

}  // namespace mjforge::docs
