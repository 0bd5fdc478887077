#include "mjforge/xml/elements_json.h"

#include <catch2/catch.hpp>
#include <string>

using mjforge::xml::ElementsJson;

TEST_CASE("Elements become lists of tag, attributes and children") {
  CHECK(ElementsJson(
            "<!-- x --><mujoco model=\"a&amp;&quot;b\"><worldbody><geom/></worldbody></mujoco>") ==
        R"(["mujoco",{"model":"a&\"b"},[["worldbody",{},[["geom",{},[]]]]]])");
}

TEST_CASE("Words that are numbers in JSON stay as they are written") {
  CHECK(ElementsJson("<a b=\"1\" c=\"-0.50 1e-06\n0\" d=\"2E+3\"/>") ==
        R"(["a",{"b":1,"c":[-0.50,1e-06,0],"d":2E+3},[]])");
}

TEST_CASE("Values with another word are texts") {
  CHECK(ElementsJson(R"(<a b="01" c="1 .5" d="2d" e="" f="nan" g="1." h="1e" i="-"/>)") ==
        R"(["a",{"b":"01","c":"1 .5","d":"2d","e":"","f":"nan","g":"1.","h":"1e","i":"-"},[]])");
}

TEST_CASE("A text that is not XML, or is nested too deep, has no elements") {
  CHECK(ElementsJson("<a><b></a>") == std::nullopt);
  CHECK(ElementsJson("") == std::nullopt);
  std::string deep;
  for (int i = 0; i < 100; ++i) deep = "<a>" + deep + "</a>";
  CHECK(ElementsJson(deep) != std::nullopt);
  CHECK(ElementsJson("<a>" + deep + "</a>") == std::nullopt);
}
