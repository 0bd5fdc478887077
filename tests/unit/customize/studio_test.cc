#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "harness/temporary_folder.h"
#include "mjforge/customize/customize.h"
#include "mjforge/output/output.h"

namespace mjforge::customize {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kLamp =
    "mjforge: 1\n"
    "name: lamp\n"
    "params: {height: 20cm .. 40cm, color: {choice: [red, blue]}}\n"
    "bodies:\n"
    "  - {name: base, parts: [{name: plate, type: box, size: [5cm, 5cm, 1cm]}]}\n"
    "  - name: arm\n"
    "    parent: base\n"
    "    parts: [{name: rod, type: capsule, size: [1cm, height / 2], pos: [0, 0, height / 2 + "
    "3cm]}]\n"
    "    joints: [{name: hinge, axis: [0, 1, 0], range: [0, 90deg]}]\n"
    "checks: {silence: {spec/unused: of no use}}\n";

Start StartOf(const std::filesystem::path& file) {
  Start start;
  start.reference = file.string();
  return start;
}

class StudioTest {
 protected:
  StudioTest() : file_(folder_.Write("lamp.yaml", kLamp)), studio_(StartOf(file_)) {}

  Json Ask(Json request) {
    last_ = studio_.Answer(request.dump());
    return Json::parse(last_.json);
  }

  harness::TemporaryFolder folder_;
  std::filesystem::path file_;
  Studio studio_;
  Reply last_;
};

TEST_CASE_METHOD(StudioTest,
                 "the page begins with the controls, the layers and the files of the spec") {
  const Json answer = Ask({{"action", "open"}});
  CHECK(answer["name"] == "lamp");
  CHECK(answer["controls"].size() == 2);
  CHECK(answer["layers"].size() == 6);
  CHECK(answer["settings"].empty());
  CHECK(answer["findings"].empty());
  CHECK(last_.files == std::vector<std::filesystem::path>{file_});
}

TEST_CASE_METHOD(StudioTest, "settings of the command line are those that the page begins with") {
  Start start = StartOf(file_);
  start.load.settings = {{"height", "25cm"}};
  start.seed = 7;
  start.index = 3;
  Studio studio(start);
  const Json answer = Json::parse(studio.Answer(R"({"action": "open"})").json);
  CHECK(answer["settings"] == Json({{{"name", "height"}, {"text", "25cm"}}}));
  CHECK(answer["seed"] == "7");
  CHECK(answer["index"] == "3");
  CHECK(answer["controls"][0]["high"] == Json{0.4});  // as in the spec
}

TEST_CASE_METHOD(StudioTest, "a drawn variant has values, facts, joints and a WebP picture") {
  const Json answer =
      Ask({{"action", "draw"}, {"settings", {{{"name", "height"}, {"value", 0.3}}}}});
  CHECK(answer["values"]["height"] == 0.3);
  CHECK(answer["facts"]["bodies"] == 3);  // with the root
  CHECK(answer["facts"]["size"][2].get<double>() == Approx(0.35));
  CHECK(answer["joints"].size() == 1);
  CHECK(answer["joints"][0]["name"] == "lamp_hinge");
  CHECK(answer["findings"].empty());
  CHECK(last_.picture.starts_with("RIFF"));
  CHECK(last_.picture.substr(8, 4) == "WEBP");
}

TEST_CASE_METHOD(StudioTest, "parameters, view, joints and layers change the picture") {
  const Json plain = {{"action", "draw"}, {"quick", true}};
  std::set<std::string> pictures;
  const auto draw = [&](const char* key, const Json& value) {
    Json request = plain;
    if (key[0] != '\0') request[key] = value;
    Ask(request);
    pictures.insert(last_.picture);
  };
  draw("", {});
  draw("settings", {{{"name", "height"}, {"value", 0.21}}});
  draw("azimuth", 10);
  draw("zoom", 2);
  draw("joints", {{"lamp_hinge", 0.7}});
  draw("layer", "collision");
  draw("index", "4");
  draw("quick", false);
  draw("nine", true);
  CHECK(pictures.size() == 9);
  draw("", {});  // nothing of the other requests stays
  CHECK(pictures.size() == 9);
}

TEST_CASE_METHOD(StudioTest, "a joint stops at the end of its range") {
  Ask({{"action", "draw"}, {"quick", true}, {"joints", {{"lamp_hinge", 1.5707963}}}});
  const std::string end = last_.picture;
  Ask({{"action", "draw"}, {"quick", true}, {"joints", {{"lamp_hinge", 9}}}});
  CHECK(last_.picture == end);
}

TEST_CASE_METHOD(StudioTest,
                 "a wrong setting is a finding at its control, and there is no picture") {
  const Json answer =
      Ask({{"action", "draw"}, {"settings", {{{"name", "color"}, {"value", "green"}}}}});
  CHECK(last_.picture.empty());
  REQUIRE(answer["findings"].size() == 1);
  CHECK(answer["findings"][0]["finding"]["file"] == "control");
  CHECK(answer["findings"][0]["finding"]["message"] == "'green' is not one of red, blue");
  CHECK(answer["findings"][0]["text"] == "color: green");
}

TEST_CASE_METHOD(StudioTest, "a new revision reads the files again") {
  Ask({{"action", "draw"}});
  folder_.Write("lamp.yaml", "mjforge: 1\nname: lamp\nparts: [\n");
  CHECK(Ask({{"action", "draw"}})["findings"].empty());  // the texts of the same revision
  const Json broken = Ask({{"action", "draw"}, {"revision", "1"}});
  REQUIRE(broken["findings"].size() == 1);
  CHECK(broken["findings"][0]["finding"]["code"] == "yaml/syntax");
  CHECK(last_.files.size() == 1);  // which is still watched
  const Json open = Ask({{"action", "open"}, {"revision", "1"}});
  CHECK(open["controls"].is_null());
  CHECK(open["findings"].size() == 1);
  folder_.Write("lamp.yaml", kLamp);
  CHECK(Ask({{"action", "draw"}, {"revision", "2"}})["findings"].empty());
}

TEST_CASE_METHOD(StudioTest, "another value of one parameter is random, and of its range") {
  std::set<double> values;
  for (const char* seed : {"1", "2", "3"}) {
    const double value = Ask({{"action", "redraw"},
                              {"name", "height"},
                              {"seed", seed},
                              {"settings", {{{"name", "height"}, {"value", 0.3}}}}})["value"];
    CHECK(value >= 0.2);
    CHECK(value <= 0.4);
    values.insert(value);
  }
  CHECK(values.size() == 3);
}

TEST_CASE_METHOD(StudioTest, "a variant is exported as command, YAML, MJCF and PNG") {
  const Json settings = {{{"name", "height"}, {"value", 0.3}}};
  const auto text = [&](const char* name) {
    return Ask({{"action", "export"},
                {"name", name},
                {"settings", settings},
                {"seed", "7"}})["text"]
        .get<std::string>();
  };
  CHECK(text("command") == "mjforge generate " + file_.string() + " --seed 7 --set height=0.3");
  CHECK(text("params") == "height: 0.3\n");
  CHECK(text("seed") == "--seed 7 --index 0");
  CHECK(text("mjcf").find("<mujoco model=\"lamp\">") != std::string::npos);
  text("png");
  CHECK(last_.picture.starts_with("\x89PNG"));
  CHECK(Ask({{"action", "export"}, {"name", "obj"}})["error"] == "there is no export 'obj'");
}

TEST_CASE("the seed of the places holds for all variants of the page") {
  const harness::TemporaryFolder folder;
  const auto file = folder.Write("scene.yaml",
                                 "mjforge: 1\nname: scene\njoints: none\nparts: [{name: top, type: "
                                 "box, size: [50cm, 50cm, 2cm]}]\n"
                                 "regions: [{name: top, size: [50cm, 50cm], pos: [0, 0, 2cm]}]\n"
                                 "bodies: [{name: a, place: {at: top}, parts: [{name: a, type: "
                                 "box, size: [2cm, 2cm, 2cm]}]}]\n");
  const auto text = [&](std::optional<std::uint64_t> place_seed, const char* name) {
    Start start = StartOf(file);
    start.place_seed = place_seed;
    const std::string reply =
        Studio(start).Answer(Json{{"action", "export"}, {"name", name}}.dump()).json;
    return Json::parse(reply)["text"].get<std::string>();
  };
  CHECK(text(4, "command") == "mjforge generate " + file.string() + " --place-seed 4");
  CHECK(text(4, "seed") == "--seed 0 --index 0 --place-seed 4");
  CHECK(text(4, "mjcf").find(" place-seed=4") != std::string::npos);
  CHECK(text(0, "mjcf").find("<body") != std::string::npos);
  CHECK(text({}, "mjcf").find("place-seed") == std::string::npos);
}

TEST_CASE_METHOD(StudioTest, "only the spec's own files are shown") {
  CHECK(Ask({{"action", "source"}, {"name", file_.string()}})["text"] == std::string(kLamp));
  CHECK(Ask({{"action", "source"}, {"name", "/etc/passwd"}})["error"] ==
        "the spec was not read from '/etc/passwd'");
}

TEST_CASE_METHOD(StudioTest, "a place of the picture leads to the part and its line") {
  const Json part = Ask({{"action", "pick"}, {"x", 0.5}, {"y", 0.3}});
  CHECK(part["part"] == "lamp_rod");
  CHECK(part["line"] == 8);
  CHECK(part["file"] == file_.string());
  CHECK(part["mass"] > 0);
  CHECK(Ask({{"action", "pick"}, {"x", 0.5}, {"y", 0.9}})["part"] == "lamp_plate");
  CHECK(Ask({{"action", "pick"}, {"x", 0.01}, {"y", 0.01}}).empty());
}

TEST_CASE_METHOD(StudioTest, "a preset that was saved can be loaded") {
  const Json saved = Ask(
      {{"action", "save"}, {"name", "tall"}, {"settings", {{{"name", "height"}, {"value", 0.4}}}}});
  CHECK(saved["presets"] == Json{"tall"});
  CHECK(Ask({{"action", "open"}})["presets"] == Json{"tall"});
  CHECK(Ask({{"action", "preset"}, {"name", "tall"}})["settings"] ==
        Json({{{"name", "height"}, {"text", "0.4"}}}));
  CHECK(Ask({{"action", "save"}, {"name", "a/b"}})["error"] ==
        "'a/b' is no name for a file: use letters, digits, _ and -");
  CHECK(Ask({{"action", "preset"}, {"name", "none"}})["findings"].size() == 1);
}

TEST_CASE_METHOD(StudioTest, "physical checks run only if they are asked for") {
  folder_.Write("lamp.yaml",
                "mjforge: 1\nname: lamp\nparts: [{name: rod, type: capsule, size: [1cm, 20cm]}]\n"
                "checks: {stable: true}\n");
  CHECK(Ask({{"action", "draw"}})["findings"].empty());
  const Json checked = Ask({{"action", "check"}});
  REQUIRE(checked["findings"].size() == 1);
  CHECK(checked["findings"][0]["finding"]["code"] == "physics/topples");
}

// Returns the number of frames of an animated WebP picture.
int FramesOf(const std::string& picture) {
  int frames = 0;
  for (auto at = picture.find("ANMF"); at != picture.npos; at = picture.find("ANMF", at + 1))
    ++frames;
  return frames;
}

TEST_CASE_METHOD(StudioTest, "films show the simulated drop, and the drive of a joint") {
  const Json drop = Ask({{"action", "film"}, {"width", 64}, {"height", 48}});
  CHECK(drop["text"].get<std::string>().starts_with("Drop, "));
  CHECK(last_.picture.starts_with("RIFF"));
  CHECK(FramesOf(last_.picture) > 8);
  const std::string first = last_.picture;
  const Json drive =
      Ask({{"action", "film"}, {"name", "lamp_hinge"}, {"width", 64}, {"height", 48}});
  CHECK(drive["text"].get<std::string>().starts_with("Drive of lamp_hinge, "));
  CHECK(FramesOf(last_.picture) == 24);
  CHECK(last_.picture != first);
  CHECK(Ask({{"action", "film"}, {"name", "none"}})["error"] ==
        "joint 'none' has no range through which it can be driven");
}

TEST_CASE_METHOD(StudioTest,
                 "joints are at the start pose, at zero, or where the request has them") {
  folder_.Write("lamp.yaml", std::string(kLamp) + "pose: [{joint: hinge, value: 40deg}]\n");
  const auto draw = [&](const Json& more) {
    Json request = {{"action", "draw"}, {"quick", true}};
    for (const auto& [key, value] : more.items()) request[key] = value;
    const Json answer = Ask(request);
    REQUIRE(answer["joints"].size() == 1);
    return std::pair(answer["joints"][0]["value"].get<double>(), last_.picture);
  };
  const auto start = draw({});
  const auto zero = draw({{"pose", "zero"}});
  CHECK(start.first == Approx(0.698132));
  CHECK(zero.first == 0);
  CHECK(zero.second != start.second);
  CHECK(draw({{"joints", {{"lamp_hinge", 0}}}}).second == zero.second);
  CHECK(draw({}).second == start.second);  // nothing of the other requests stays
}

TEST_CASE_METHOD(StudioTest, "the page begins with the view of the spec") {
  const auto value = [&](const char* pose) {
    return Ask({{"action", "draw"}, {"quick", true}, {"pose", pose}})["joints"][0]["value"]
        .get<double>();
  };
  CHECK(Ask({{"action", "open"}})["view"].dump() == R"({"pose":{}})");
  folder_.Write("lamp.yaml", std::string(kLamp) +
                                 "pose: {hinge: 40deg}\n"
                                 "view: {azimuth: 10deg, elevation: -90deg, pose: {hinge: 1}}\n");
  const Json open = Ask({{"action", "open"}, {"revision", "1"}});
  CHECK(open["view"]["azimuth"].get<double>() == Approx(10));
  CHECK(open["view"]["elevation"].get<double>() == Approx(-90));
  CHECK(open["view"]["pose"].dump() == R"({"hinge":1})");
  CHECK(Ask({{"action", "draw"}, {"revision", "1"}})["joints"][0]["value"] == 1);
  CHECK(value("view") == 1);
  CHECK(value("start") == Approx(0.698132));
  CHECK(value("zero") == 0);
}

TEST_CASE_METHOD(StudioTest, "a text that is a name of the expression language stays a text") {
  folder_.Write("lamp.yaml",
                "mjforge: 1\nname: lamp\nparams: {label: lamp, height: 20cm}\n"
                "parts: [{name: rod, if: label != 'x', type: capsule, size: [1cm, height]}]\n");
  for (const char* word : {"pi", "max", "index", "height", "label", "free"}) {
    const Json settings = {{{"name", "label"}, {"value", word}}};
    const Json answer = Ask({{"action", "draw"}, {"settings", settings}});
    INFO(answer["findings"].dump());
    CHECK(answer["values"]["label"] == word);
    const Json params = Ask({{"action", "export"}, {"name", "params"}, {"settings", settings}});
    const bool is_name = word != std::string("free");
    CHECK(params["text"] ==
          std::string("label: ") + (is_name ? "${'" : "") + word + (is_name ? "'}\n" : "\n"));
  }
}

TEST_CASE_METHOD(StudioTest, "every text of a text field stays this text") {
  folder_.Write("lamp.yaml",
                "mjforge: 1\nname: lamp\nparams: {label: lamp, a: 1, kind: {choice: [red b, M3]}}\n"
                "parts: [{name: rod, if: label != 'x' and kind != 'x', type: sphere, size: a}]\n");
  for (const char* text :
       {"12",     "a + b", "it's", "x: y",        "[1, 2]",  "",     "#",     "~",
        "null",   "true",  " a ",  "hello world", "hello a", "${a}", "'} ${", "\"",
        "1 .. 2", ".inf",  "-",    "{a: b}",      "a #b",    "\\n",  "größe"}) {
    const Json settings = {{{"name", "label"}, {"value", text}},
                           {{"name", "kind"}, {"value", "red b"}}};
    const Json answer = Ask({{"action", "draw"}, {"settings", settings}});
    INFO(text << answer["findings"].dump());
    CHECK(answer["values"]["label"] == text);
    CHECK(answer["values"]["kind"] == "red b");
    Ask({{"action", "save"}, {"name", "mine"}, {"settings", settings}});
    const Json preset = Ask({{"action", "preset"}, {"name", "mine"}});
    const Json loaded = {{{"name", "label"}, {"value", {{"yaml", preset["settings"][0]["text"]}}}}};
    CHECK(Ask({{"action", "draw"}, {"settings", loaded}})["values"]["label"] == text);
  }
}

TEST_CASE_METHOD(StudioTest, "missing files are watched, and so are those of the object") {
  folder_.Write("lamp.yaml",
                "mjforge: 1\nname: lamp\nimport: [size.yaml]\n"
                "parts: [{name: rod, type: mesh, file: rod.obj, scale: a}]\n");
  const auto watches = [&](const char* name) {
    return std::ranges::find(last_.files, folder_.path() / name) != last_.files.end();
  };
  CHECK_FALSE(Ask({{"action", "draw"}})["findings"].empty());
  CHECK(watches("size.yaml"));
  folder_.Write("size.yaml", "mjforge: 1\nparams: {a: 1}\n");
  CHECK(Ask({{"action", "draw"}, {"revision", "1"}})["findings"].size() == 1);
  CHECK(watches("rod.obj"));
  const std::string tetrahedron =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  folder_.Write("rod.obj", tetrahedron);
  CHECK(Ask({{"action", "draw"}, {"revision", "2"}})["findings"].empty());
  CHECK(watches("rod.obj"));
  CHECK(watches("size.yaml"));
  const std::string small = last_.picture;
  folder_.Write("rod.obj", "v 0 0 -3\n" + tetrahedron.substr(8));
  Ask({{"action", "draw"}, {"revision", "3"}});
  CHECK(last_.picture != small);
  const Json exported = Ask({{"action", "export"}, {"name", "mjcf"}, {"revision", "3"}});
  INFO(exported.dump());
  REQUIRE(exported["text"] == "");
  const std::filesystem::path archive = folder_.Write("lamp.tar", last_.picture);
  diag::Findings findings;
  const auto member = [&](const char* name) {
    return output::ReadMember(archive, name, findings).value_or("");
  };
  CHECK(member("lamp/lamp.xml").find("file=\"assets/rod.obj\"") != std::string::npos);
  CHECK(member("lamp/assets/rod.obj").starts_with("v 0 0 -3"));
}

TEST_CASE_METHOD(StudioTest, "of nine variants, those that fail have their index and the reason") {
  folder_.Write(
      "lamp.yaml",
      "mjforge: 1\nname: lamp\nparts: [{name: rod, type: sphere, size: 3cm - index * 1cm}]\n");
  const Json answer = Ask({{"action", "draw"}, {"nine", true}, {"index", "1"}});
  REQUIRE(answer["cells"].size() == 9);
  CHECK(answer["cells"][1] == "");
  CHECK(answer["cells"][2] == "index 3 failed: size of part 'rod' is 0; it must be greater than 0");
  CHECK(Ask({{"action", "draw"}})["cells"].empty());
}

TEST_CASE_METHOD(StudioTest, "a request that is wrong has an error as its answer") {
  CHECK(Ask({{"action", "dance"}})["error"] == "there is no action 'dance'");
  CHECK(Json::parse(studio_.Answer("x").json)["error"] == "the request is not a JSON object");
}

}  // namespace
}  // namespace mjforge::customize
