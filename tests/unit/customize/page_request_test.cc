#include "mjforge/customize/page_request.h"

#include <catch2/catch.hpp>

namespace mjforge::customize {
namespace {

Request Read(std::string_view json) {
  std::string why_not;
  const auto request = ReadRequest(json, why_not);
  INFO(why_not);
  REQUIRE(request.has_value());
  return *request;
}

std::string WhyNot(std::string_view json) {
  std::string why_not;
  CHECK_FALSE(ReadRequest(json, why_not).has_value());
  return why_not;
}

TEST_CASE("a request has the whole state of the page") {
  const Request request = Read(R"({"action": "draw", "seed": "18446744073709551615", "index": "7",
    "quick": true, "pose": "zero", "nine": true, "azimuth": 90, "elevation": -20, "zoom": 2,
    "layer": "joints", "width": 320, "joints": {"lid": 0.5}})");
  CHECK(request.action == "draw");
  CHECK(request.seed == 18446744073709551615U);
  CHECK(request.index == 7);
  CHECK(request.pose == BasePose::kZero);
  CHECK(request.nine);
  CHECK(request.picture.quick);
  CHECK(request.picture.view.azimuth == 90);
  CHECK(request.picture.view.elevation == -20);
  CHECK(request.picture.view.zoom == 2);
  CHECK(request.picture.layer == picture::Layer::kJoints);
  CHECK(request.picture.width == 320);
  CHECK(request.picture.height == 480);
  CHECK(request.joints == std::vector<std::pair<std::string, double>>{{"lid", 0.5}});
}

TEST_CASE("values become YAML, except texts") {
  const Request request = Read(R"({"settings": [
    {"name": "a", "value": 0.1}, {"name": "b", "value": "no"}, {"name": "c", "value": [1, 2.5]},
    {"name": "d", "value": false}, {"name": "e", "value": {"yaml": "1cm .. 2cm"}},
    {"name": "f", "value": [{"yaml": "1cm"}, {"yaml": "0,5"}, 2]}]})");
  std::vector<std::string> texts;
  for (const spec::Setting& setting : request.settings) {
    CHECK(setting.origin == kSettingOrigin);
    texts.push_back(setting.name + "=" + setting.text);
  }
  CHECK(texts == std::vector<std::string>{"a=0.1", "b=no", "c=[1, 2.5]", "d=false", "e=1cm .. 2cm",
                                          "f=['1cm', '0,5', 2]"});
  CHECK(request.values == std::vector<std::size_t>{1});
}

TEST_CASE("a wrong request says which member is wrong") {
  CHECK(WhyNot("") == "the request is not a JSON object");
  CHECK(WhyNot("[1]") == "the request is not a JSON object");
  CHECK(WhyNot(R"({"action": 3})") == "'action' is not a text");
  CHECK(WhyNot(R"({"seed": 3})") == "'seed' is not a text of digits");
  CHECK(WhyNot(R"({"seed": "-3"})") == "'seed' is not a whole number up to 2^64 - 1");
  CHECK(WhyNot(R"({"pose": "open"})") == "'pose' is not view, start or zero");
  CHECK(WhyNot(R"({"width": 100000})") == "'width' is not a number from 16 to 2048");
  CHECK(WhyNot(R"({"elevation": 91})") == "'elevation' is not a number from -90 to 90");
  CHECK(WhyNot(R"({"zoom": 0})") == "'zoom' is not a number from 0.001 to 1000");
  CHECK(WhyNot(R"({"layer": "x"})") == "'layer' is not the name of a layer");
  CHECK(WhyNot(R"({"quick": 1})") == "'quick' is not true or false");
  CHECK(WhyNot(R"({"settings": [{"name": "a"}]})") ==
        "'settings' is not a list of objects with `name` and `value`");
  CHECK(WhyNot(R"({"settings": [{"name": "a", "value": null}]})") ==
        "'settings' is not a list of values");
  CHECK(WhyNot(R"({"joints": {"a": "b"}})") == "'joints' is not an object of numbers");
}

TEST_CASE("a request that is nested too deep is no JSON object") {
  CHECK(WhyNot(std::string(100'000, '[')) == "the request is not a JSON object");
}

}  // namespace
}  // namespace mjforge::customize
