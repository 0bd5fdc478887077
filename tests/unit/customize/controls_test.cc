#include "mjforge/customize/controls.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "mjforge/expr/expr.h"

namespace mjforge::customize {
namespace {

using Json = nlohmann::json;

// Returns the control of each parameter of a spec with these `params:`, by name.
std::map<std::string, Json> ControlsOf(const std::string& params) {
  diag::Sources sources;
  diag::Findings findings;
  const std::string text = "mjforge: 1\nname: thing\nparams:\n" + params +
                           "parts: [{name: ball, type: sphere, size: 1}]\n";
  const auto spec = spec::LoadSpecText("thing.yaml", text, ".", {}, sources, findings);
  for (const diag::Finding& finding : findings) INFO(finding.message);
  REQUIRE(spec != nullptr);
  diag::Json json(expr::AppendExactNumber);
  WriteControls(json, *spec);
  std::map<std::string, Json> controls;
  for (const Json& control : Json::parse(json.Take())) controls[control["name"]] = control;
  return controls;
}

TEST_CASE("a control has the range, the unit and the documentation of its parameter") {
  const Json length =
      ControlsOf("  length: {value: 10cm .. 25cm, unit: m, doc: Of the handle.}\n")["length"];
  CHECK(length["kind"] == "number");
  CHECK(length["low"] == Json{0.1});
  CHECK(length["high"] == Json{0.25});
  CHECK(length["unit"] == "m");
  CHECK(length["doc"] == "Of the handle.");
  CHECK(length["spec"] == "10cm .. 25cm");
  CHECK(length["random"] == true);
  CHECK(length["whole"] == false);
  CHECK(length["choices"].is_null());
}

TEST_CASE("the form of a value decides which control it has") {
  auto controls = ControlsOf(
      "  count: 3\n"
      "  drawn: {integer: [2, 5]}\n"
      "  double: 2 * count\n"
      "  shape: {choice: [box, cylinder]}\n"
      "  pair: {choice: [[1, 2], [3, 4]]}\n"
      "  mixed: {choice: [1 .. 2, 5]}\n"
      "  painted: {bernoulli: 0.3}\n"
      "  word: hello\n"
      "  size: [1, 2 .. 3, 4]\n"
      "  color: [0.5, 0.2 .. 0.9, 0, 1]\n"
      "  glaze: {choice: [[0.9, 0.8, 0.7, 1], [0.1, 0.2, 0.3, 1]]}\n"
      "  tint: {hsv: [0.1, 0.2, 0.3]}\n"
      "  rows: {each: 1 .. 2, count: 5}\n"
      "  thin: {normal: [3, 1]}\n");
  const std::map<std::string, std::string> kinds = {
      {"count", "number"}, {"drawn", "number"}, {"double", "number"},  {"shape", "choice"},
      {"pair", "choice"},  {"mixed", "number"}, {"painted", "switch"}, {"word", "text"},
      {"size", "vector"},  {"color", "color"},  {"glaze", "color"},    {"tint", "color"},
      {"rows", "list"},    {"thin", "number"}};
  for (const auto& [name, kind] : kinds) {
    INFO(name);
    CHECK(controls[name]["kind"] == kind);
  }
  CHECK(controls["count"]["whole"] == true);
  CHECK(controls["count"]["random"] == false);
  CHECK(controls["drawn"]["whole"] == true);
  CHECK(controls["double"]["low"].is_null());
  CHECK(controls["shape"]["choices"] == Json({"box", "cylinder"}));
  CHECK(controls["pair"]["choices"] == Json({{1, 2}, {3, 4}}));
  CHECK(controls["glaze"]["choices"].size() == 2);
  CHECK(controls["mixed"]["low"] == Json{1});
  CHECK(controls["mixed"]["high"] == Json{5});
  CHECK(controls["size"]["low"] == Json({1, 2, 4}));
  CHECK(controls["size"]["high"] == Json({1, 3, 4}));
  CHECK(controls["thin"]["low"] == Json{nullptr});
}

TEST_CASE("a parameter with a section is in the group of that name, and in no other") {
  auto controls = ControlsOf(
      "  leg_length: {value: 1 .. 2, section: Height}\n"
      "  leg_radius: 1\n"
      "  top: {value: 3, section: Height}\n");
  CHECK(controls["leg_length"]["group"] == "Height");
  CHECK(controls["top"]["group"] == "Height");
  CHECK(controls["leg_radius"]["group"] == "");
}

TEST_CASE("parameters whose names begin with the same word are a group") {
  auto controls = ControlsOf("  handle_length: 1\n  handle_radius: 2\n  head_size: 3\n  gap: 1\n");
  CHECK(controls["handle_length"]["group"] == "handle");
  CHECK(controls["handle_radius"]["group"] == "handle");
  CHECK(controls["head_size"]["group"] == "");
  CHECK(controls["gap"]["group"] == "");
}

TEST_CASE("the columns of a record follow its key") {
  auto controls = ControlsOf(
      "  thread:\n"
      "    choice:\n"
      "      - {name: M3, pitch: 0.5mm}\n"
      "      - {name: M4, pitch: 0.7mm}\n");
  CHECK(controls["thread.name"]["kind"] == "choice");
  CHECK(controls["thread.pitch"]["kind"] == "fixed");
  CHECK(controls["thread.pitch"]["group"] == "thread");
}

}  // namespace
}  // namespace mjforge::customize
