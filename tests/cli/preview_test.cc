// Tests of `mjforge preview`: pictures, contact sheets, animations.

#include <catch2/catch.hpp>
#include <set>

#include "crate.h"
#include "harness/png.h"

namespace mjforge {
namespace {

using harness::DecodePng;

constexpr const char* kChest =
    "<mujoco><worldbody><body name='chest'><geom size='0.1 0.2 0.1' type='box' name='side'/>"
    "<body name='lid' pos='-0.1 0 0.1'>"
    "<joint name='chest_lid_hinge' axis='0 -1 0' range='0 100' limited='true'/>"
    "<geom size='0.1 0.2 0.01' pos='0.1 0 0.01' type='box' rgba='0.2 0.3 0.8 1'/>"
    "</body></body></worldbody></mujoco>";

class PreviewTest : public CrateTest {
 protected:
  PreviewTest() { folder().Write("chest.xml", kChest); }

  // Returns the picture of a run that must succeed without messages.
  std::string Draw(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "preview");
    arguments.insert(arguments.end(), {"-o", "-"});
    const auto result = Run(arguments);
    INFO(result.err);
    REQUIRE(result.status == 0);
    REQUIRE(result.err.empty());
    return result.out;
  }
};

TEST_CASE_METHOD(PreviewTest, "preview draws one object and says what it is") {
  const auto result = Run({"preview", "crate.yaml", "--seed", "7"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  CHECK(result.out.empty());
  const std::string bytes = folder().Read("crate.png");
  const harness::Png png = DecodePng(bytes);
  CHECK(png.width == 640);
  CHECK(png.height == 640);
  CHECK(png.Edges(12) > 300);
  CHECK(harness::PngText(bytes, "Software").starts_with("mjforge "));
  const std::string text = harness::PngText(bytes, "mjforge");
  CHECK(text.starts_with("spec=crate.yaml sha256="));
  CHECK(text.ends_with(" seed=7 index=0"));
}

TEST_CASE_METHOD(UnluckyCrateTest, "a finding that many variants of a preview have is shown once") {
  const auto result = Run({"preview", "crate.yaml", "-n", "12", "--size", "60"});
  CHECK(result.status == 1);
  CHECK(result.err ==
        "crate.yaml:4:50: error: size 3 of part 'body' is -0.0373559; it must be greater than 0 "
        "(seed 0, index 0) [model/bad-value]\n"
        "parts: [{name: body, type: box, size: [0.1, 0.1, height]}]\n"
        "                                                 ^\n"
        "  hint: it is the value of 'height'\n"
        "mjforge: note: 8 variants have this finding; this is the first\n");
}

TEST_CASE_METHOD(PreviewTest, "a contact sheet has a picture and a caption for each variant") {
  const harness::Png four = DecodePng(Draw({"crate.yaml", "-n", "4", "--size", "100"}));
  CHECK(four.width == 2 * 112 + 12);
  CHECK(four.height > 2 * 60 + 12);
  const harness::Png six = DecodePng(Draw({"crate.yaml", "-n", "6", "--size", "100x60"}));
  CHECK(six.width == 3 * 112 + 12);
  // Each of the four tiles has an object, and so edges.
  for (int tile = 0; tile < 4; ++tile) {
    int dark = 0;
    const int left = 12 + tile % 2 * 112;
    const int half = (four.height - 12) / 2;
    const int top = 12 + tile / 2 * half;
    for (int y = top; y < top + half; ++y) {
      for (int x = left; x < left + 100; ++x) dark += four.At(x, y)[0] < 160 ? 1 : 0;
    }
    CHECK(dark > 1000);
  }
}

TEST_CASE_METHOD(PreviewTest, "several files make a contact sheet, each with its name below") {
  folder().Write("box.xml", kChest);
  const harness::Png sheet =
      DecodePng(Draw({"chest.xml", "box.xml", "--joint", "lid_hinge=0.5", "--size", "100"}));
  CHECK(sheet.width > 200);
  CHECK(sheet.Edges(12) > DecodePng(Draw({"chest.xml", "--size", "100"})).Edges(12));
  CHECK(Run({"preview", "chest.xml", "crate.yaml"}).err ==
        "mjforge: error: 'crate.yaml' is not a FILE.xml: only files can be several\n"
        "  hint: see 'mjforge preview --help'\n");
  CHECK(Run({"preview", "chest.xml", "box.xml", "-n", "3"}).status == 2);
}

TEST_CASE_METHOD(PreviewTest, "a sheet moves the joints that its objects have") {
  folder().Write("plain.xml",
                 "<mujoco><worldbody><body><geom size='1'/></body></worldbody></mujoco>");
  const auto mixed = Run({"preview", "plain.xml", "chest.xml", "--joint", "hinge=0.5", "-o", "-"});
  CHECK(mixed.status == 0);
  CHECK(mixed.err ==
        "mjforge: warning: there is no joint 'hinge' [picture/unknown-joint]\n"
        "  hint: the object has no hinge or slide\n");
  CHECK(mixed.out != Run({"preview", "plain.xml", "chest.xml", "-o", "-"}).out);
  CHECK(Run({"preview", "plain.xml", "chest.xml", "--joint", "hinge=3", "-o", "-"}).status == 1);
}

TEST_CASE_METHOD(PreviewTest, "a picture of a sheet is the variant's own picture") {
  const std::string third = Draw({"crate.yaml", "--first", "2", "--size", "100"});
  CHECK(third == Draw({"crate.yaml", "--first", "2", "--size", "100"}));
  CHECK(third != Draw({"crate.yaml", "--first", "1", "--size", "100"}));
  CHECK(third != Draw({"crate.yaml", "--first", "2", "--size", "100", "--seed", "1"}));
  const std::vector<std::string> sheet = {"crate.yaml", "-n", "3", "--size", "64"};
  CHECK(Draw(sheet) == Draw(sheet));
}

TEST_CASE_METHOD(PreviewTest, "a spec's view is the picture's, unless an option says otherwise") {
  const std::string door =
      "mjforge: 1\nname: cup\nparts: [{name: s, type: box, size: [0.1, 0.2, 0.1]}]\n"
      "bodies:\n  - name: lid\n    parts: [{name: l, type: box, size: [0.1, 0.2, 0.01]}]\n"
      "    pos: [0, 0, 0.2]\n    joints: [{name: turn, axis: [0, 0, 1], range: [0, 90deg]}]\n";
  folder().Write("plain.yaml", door);
  folder().Write("view.yaml",
                 door + "view: {azimuth: 30deg, elevation: -60deg, pose: {turn: 45deg}}\n");
  const auto pixels = [&](const std::vector<std::string>& arguments) {
    return DecodePng(Draw(arguments)).rgba;
  };
  const auto viewed = pixels({"view.yaml", "--size", "64"});
  const std::vector<std::string> same = {"plain.yaml",  "--size", "64",      "--azimuth", "30",
                                         "--elevation", "-60",    "--joint", "turn=45deg"};
  CHECK(viewed == pixels(same));
  CHECK(viewed != pixels({"plain.yaml", "--size", "64"}));
  CHECK(pixels({"view.yaml", "--size", "64", "--azimuth", "123", "--elevation", "-20", "--joint",
                "turn=0"}) ==
        pixels({"plain.yaml", "--size", "64", "--azimuth", "123", "--elevation", "-20"}));
  folder().Write("wrong.yaml", door + "view: {pose: {trun: 45deg}}\n");
  const auto wrong = Run({"preview", "wrong.yaml", "-o", "wrong.png"});
  CHECK(wrong.status == 0);
  CHECK(wrong.err ==
        "wrong.yaml:9:15: warning: view: the object has no joint 'trun' (seed 0, index 0) "
        "[model/unknown-reference]\n"
        "view: {pose: {trun: 45deg}}\n"
        "              ^\n"
        "  hint: did you mean 'turn'?\n");
  folder().Write("far.yaml", door + "view: {pose: {turn: 2}}\n");
  CHECK(Run({"preview", "far.yaml", "-o", "far.png"})
            .err.starts_with("far.yaml:9:15: warning: the view's pose: joint 'cup_turn' does not "
                             "reach 2 rad: its range is 0 to 1.5708 [picture/bad-joint-value]\n"));
}

TEST_CASE_METHOD(PreviewTest, "size, background and layer are as they are asked for") {
  const harness::Png wide = DecodePng(Draw({"chest.xml", "--size", "200x100"}));
  CHECK(wide.width == 200);
  CHECK(wide.height == 100);
  const harness::Png blue =
      DecodePng(Draw({"chest.xml", "--size", "64", "--background", "#1020f0"}));
  CHECK(blue.At(0, 0) == std::array<int, 4>{16, 32, 240, 255});
  const harness::Png clear =
      DecodePng(Draw({"chest.xml", "--size", "64", "--background", "transparent"}));
  CHECK(clear.At(0, 0)[3] == 0);
  CHECK(clear.Seen() > 1000);
  std::set<std::string> layers;
  for (const char* layer : {"visual", "collision", "bounds", "inertia", "joints", "regions"})
    layers.insert(Draw({"chest.xml", "--size", "200", "--layer", layer}));
  CHECK(layers.size() == 6);
}

TEST_CASE_METHOD(PreviewTest, "the camera stands where --azimuth, --elevation, --distance say") {
  const std::vector<std::string> small = {"chest.xml", "--size", "64", "--background",
                                          "transparent"};
  const auto seen = [&](std::vector<std::string> camera) {
    camera.insert(camera.begin(), small.begin(), small.end());
    return DecodePng(Draw(camera));
  };
  CHECK(seen({"--azimuth", "90"}).Seen() != seen({"--azimuth", "180"}).Seen());
  // Seen from above, the box is a rectangle twice as long as wide.
  const harness::Png above = seen({"--azimuth", "90", "--elevation", "-90"});
  CHECK(above.At(32, 8)[3] > 200);
  CHECK(above.At(8, 32)[3] < 100);
  CHECK(seen({"--distance", "4"}).Seen() < seen({"--distance", "2"}).Seen());
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--elevation", "91"},
                                                {"--distance", "0"},
                                                {"--azimuth", "north"}}) {
    const auto result = Run({"preview", "chest.xml", wrong[0], wrong[1]});
    CHECK(result.status == 2);
    CHECK(result.err.starts_with("mjforge: error: " + wrong[0] + ": '" + wrong[1] + "' is not a"));
  }
}

TEST_CASE_METHOD(PreviewTest,
                 "the names of joints stand below the picture, which they do not cover") {
  const auto seen_in = [](const harness::Png& png, int top, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = 0; x < png.width; ++x) count += png.At(x, y)[3] > 100 ? 1 : 0;
    }
    return count;
  };
  const harness::Png joints = DecodePng(
      Draw({"chest.xml", "--size", "300", "--layer", "joints", "--background", "transparent"}));
  CHECK(joints.height == 300);
  CHECK(seen_in(joints, 280, 300) > 300);  // a line of text
  CHECK(seen_in(joints, 272, 280) < 300);  // the margin above the text
  const harness::Png bounds = DecodePng(
      Draw({"chest.xml", "--size", "300", "--layer", "visual", "--background", "transparent"}));
  CHECK(seen_in(bounds, 290, 300) == 0);
}

TEST_CASE_METHOD(PreviewTest, "a joint moves by --joint, in any unit, with or without its prefix") {
  const std::string closed = Draw({"chest.xml", "--size", "100"});
  const std::string open = Draw({"chest.xml", "--size", "100", "--joint", "lid_hinge=90deg"});
  CHECK(open != closed);
  CHECK(open == Draw({"chest.xml", "--size", "100", "--joint", "chest_lid_hinge=pi/2"}));
}

TEST_CASE_METHOD(PreviewTest, "a joint that does not exist or reach there is a finding") {
  const auto unknown = Run({"preview", "chest.xml", "--joint", "hnge=1"});
  CHECK(unknown.status == 1);
  CHECK(unknown.err ==
        "mjforge: error: there is no joint 'hnge' [picture/unknown-joint]\n"
        "  hint: did you mean 'hinge'?\n");
  const auto outside = Run({"preview", "chest.xml", "--joint", "hinge=3"});
  CHECK(outside.status == 1);
  CHECK(outside.err ==
        "mjforge: error: joint 'chest_lid_hinge' does not reach 3 rad: its range is 0 to 1.74533 "
        "[picture/bad-joint-value]\n");
  const auto length = Run({"preview", "chest.xml", "--joint", "hinge=1m"});
  CHECK(length.status == 1);
  CHECK(length.err ==
        "mjforge: error: joint 'chest_lid_hinge' is in rad, but its position is given in m "
        "[picture/bad-joint-value]\n");
  CHECK(folder().Files() == std::vector<std::string>{"chest.xml", "crate.yaml"});
}

TEST_CASE_METHOD(PreviewTest, "the joints are animated by --sweep in a GIF") {
  const std::string gif = Draw({"chest.xml", "--size", "48", "--sweep"});
  CHECK(gif.starts_with("GIF89a"));
  CHECK(gif.find("Software: mjforge ") != std::string::npos);
  int frames = 0;
  const std::string_view control = "\x21\xf9\x04";  // of one frame
  for (std::size_t at = 0; (at = gif.find(control, at)) != gif.npos; ++at) ++frames;
  CHECK(frames == 25);  // there and back, twelve each, and the end
  CHECK(gif == Draw({"chest.xml", "--size", "48", "--sweep", "--joint", "hinge"}));
  for (int i = 0; i < 2; ++i)
    REQUIRE(Run({"preview", "chest.xml", "--size", "48", "--sweep"}).status == 0);
  CHECK(folder().Read("chest.gif") == gif);
  const std::string doors =
      "mjforge: 1\nname: cup\nparts: [{name: s, type: box, size: [0.1, 0.2, 0.1]}]\n"
      "bodies:\n  - name: \"lid_${i}\"\n    for: {i: 2}\n"
      "    parts: [{name: \"l_${i}\", type: box, size: [0.1, 0.2, 0.01]}]\n    pos: [0, 0, 0.2 + "
      "0.1 * i]\n"
      "    joints: [{name: \"turn_${i}\", axis: [0, 0, 1], range: [0, 90deg]}]\n";
  const auto motion = [&](const std::string& view) {
    folder().Write("doors.yaml", doors + view);
    const std::string film = Draw({"doors.yaml", "--size", "48", "--sweep", "--joint", "turn_0"});
    return film.substr(film.find(control));
  };
  CHECK(motion("") == motion("view: {pose: {turn_1: 45deg}}\n"));  // others are at their start
  const auto stiff = Run({"preview", "crate.yaml", "--sweep"});
  CHECK(stiff.status == 1);
  CHECK(stiff.err ==
        "mjforge: error: no joint has a range to move through "
        "[picture/bad-joint-value]\n");
}

TEST_CASE_METHOD(PreviewTest, "a bad spec prints its errors and gives no picture") {
  folder().Write("bad.yaml", "mjforge: 1\nname: bad\nparts: [{name: a, type: bx, size: [1]}]\n");
  const auto result = Run({"preview", "bad.yaml"});
  CHECK(result.status == 1);
  CHECK(result.err.starts_with("bad.yaml:3:"));
  CHECK(Run({"preview", "none.xml"}).status != 0);
  CHECK(folder().Files() == std::vector<std::string>{"bad.yaml", "chest.xml", "crate.yaml"});
}

TEST_CASE_METHOD(PreviewTest, "what MuJoCo refuses is said at its place in the spec") {
  folder().Write("tiny.yaml",
                 "mjforge: 1\nname: tiny\nparts:\n"
                 "  - {name: a, type: box, size: [1e-6, 1e-6, 1e-6], mass: 1}\n");
  const auto result = Run({"preview", "tiny.yaml"});
  CHECK(result.status == 1);
  CHECK(result.err.starts_with("tiny.yaml:4:5: error: MuJoCo refused"));
}

TEST_CASE_METHOD(UnluckyCrateTest, "a sheet shows the variants that can be made") {
  const auto result = Run({"preview", "crate.yaml", "-n", "8", "--size", "64"});
  CHECK(result.status == 1);
  CHECK_FALSE(result.err.empty());
  CHECK(DecodePng(folder().Read("crate.png")).width < 4 * 76);
}

TEST_CASE_METHOD(PreviewTest, "a file that is no picture of ours is not overwritten") {
  REQUIRE(Run({"preview", "chest.xml", "--size", "32", "-o", "a.png"}).status == 0);
  CHECK(Run({"preview", "crate.yaml", "--size", "32", "-o", "a.png"}).status == 0);
  folder().Write("a.png", "\x89PNG\r\n a photograph");
  const auto refused = Run({"preview", "chest.xml", "-o", "a.png"});
  CHECK(refused.status == 3);
  CHECK(refused.err ==
        "mjforge: error: 'a.png' exists and was not made by mjforge [output/exists]\n"
        "  hint: choose another place, or overwrite it with --force\n");
  CHECK(folder().Read("a.png") == "\x89PNG\r\n a photograph");
  CHECK(Run({"preview", "chest.xml", "--size", "32", "-o", "a.png", "--force"}).status == 0);
  CHECK(DecodePng(folder().Read("a.png")).width == 32);
}

TEST_CASE_METHOD(PreviewTest, "a place that cannot be written leaves nothing") {
  const auto result = Run({"preview", "chest.xml", "--size", "32", "-o", "none/a.png"});
  CHECK(result.status == 3);
  CHECK(result.err.find("[output/cannot-write]") != std::string::npos);
  CHECK(folder().Files() == std::vector<std::string>{"chest.xml", "crate.yaml"});
}

TEST_CASE_METHOD(PreviewTest, "options of preview that contradict each other are wrong usage") {
  const auto error = [&](const std::vector<std::string>& arguments) {
    const auto result = Run(arguments);
    CHECK(result.status == 2);
    return result.err.substr(0, result.err.find('\n'));
  };
  for (const std::string option : {"-n", "--first", "--seed"}) {
    CHECK(error({"preview", "chest.xml", option, "7"}) ==
          "mjforge: error: 'chest.xml' is shown as it is: --seed, --place-seed, -n, --first, "
          "--set, --root, --start and --params take a spec");
  }
  CHECK(error({"preview", "crate.yaml", "-n", "401"}) ==
        "mjforge: error: -n 401: a sheet holds at most 400 variants");
  CHECK(error({"preview", "crate.yaml", "--size", "9x9"}) ==
        "mjforge: error: --size: '9x9' is not of the form WxH, each 16 to 4096");
  CHECK(error({"preview", "crate.yaml", "--joint", "hinge"}) ==
        "mjforge: error: --joint: 'hinge' is not of the form NAME=VALUE");
  for (const std::string file : {"a.gif", "a.jpg"}) {
    CHECK(error({"preview", "crate.yaml", "-o", file}) ==
          "mjforge: error: -o " + file + ": a picture is a .png, and with --sweep a .gif");
  }
  for (const std::string file : {"a.png", "a.apng", "a.webp"}) {
    CHECK(error({"preview", "chest.xml", "--sweep", "-o", file}) ==
          "mjforge: error: -o " + file + ": a picture is a .png, and with --sweep a .gif");
  }
  CHECK(error({"preview", "crate.yaml", "-n", "100", "--size", "4096"}) ==
        "mjforge: error: --size 4096: 100 pictures of that size are too large for one sheet");
  CHECK(error({"preview", "chest.xml", "--sweep", "--size", "801"}) ==
        "mjforge: error: --size 801: with --sweep at most 800 pixels a side");
  CHECK(error({"preview", "crate.yaml", "-n", "2", "--sweep"}) ==
        "mjforge: error: --sweep takes one object, not a sheet");
  CHECK(error({"preview", "crate.yaml", "--layer", "jonts"}).find("did you mean 'joints'?") !=
        std::string::npos);
}

TEST_CASE_METHOD(PreviewTest, "without a renderer there is a finding and no picture") {
  const auto result = Run({"preview", "chest.xml"}, {}, {{"MUJOCO_GL", "off"}});
  CHECK(result.status == 1);
  CHECK(result.err ==
        "mjforge: error: cannot draw: MUJOCO_GL=off turns drawing off [picture/no-renderer]\n"
        "  hint: install libegl1 with a driver (libgl1-mesa-dri), or libosmesa6\n");
  CHECK(folder().Files() == std::vector<std::string>{"chest.xml", "crate.yaml"});
}

TEST_CASE_METHOD(PreviewTest, "EGL and OSMesa both draw") {
  for (const char* name : {"egl", "osmesa"}) {
    INFO(name);
    const auto result =
        Run({"preview", "chest.xml", "--size", "64", "--background", "transparent", "-o", "-"}, {},
            {{"MUJOCO_GL", name}, {"ASAN_OPTIONS", "detect_leaks=0"}});  // Mesa leaks with EGL
    CHECK(result.status == 0);
    CHECK(DecodePng(result.out).Seen() > 1000);
  }
}

TEST_CASE_METHOD(PreviewTest, "a display that is not there does not matter") {
  const std::string usual = Draw({"chest.xml", "--size", "64"});
  const auto result = Run({"preview", "chest.xml", "--size", "64", "-o", "-"}, {},
                          {{"DISPLAY", ":77"}, {"WAYLAND_DISPLAY", "none"}});
  CHECK(result.status == 0);
  CHECK(result.out == usual);
}

TEST_CASE_METHOD(PreviewTest, "meshes and textures come from their files") {
  folder().Write("parts/roof.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                 "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  folder().Write("roof.yaml",
                 "mjforge: 1\nname: roof\n"
                 "parts: [{name: a, type: mesh, file: parts/roof.obj, density: 100}]\n");
  const harness::Png png =
      DecodePng(Draw({"roof.yaml", "--size", "100", "--background", "transparent"}));
  CHECK(png.Seen() > 1000);
}

}  // namespace
}  // namespace mjforge
