#include "mjforge/mjcf/element_writer.h"

#include <catch2/catch.hpp>
#include <pugixml.hpp>

namespace mjforge::mjcf {
namespace {

TEST_CASE("elements nest by two spaces and end with a line feed") {
  MjcfDocument document;
  ElementWriter writer(document);
  writer.OpenElement("a");
  writer.BeginContent();
  writer.OpenElement("b");
  writer.WriteNumber("x", 0.5);
  writer.CloseEmpty();
  writer.EndElement("a");
  writer.Finish();
  CHECK(document.text == "<a>\n  <b x=\"0.5\"/>\n</a>\n");
}

TEST_CASE("a text with XML's own characters reads back as it was") {
  const std::string value = "a<b>&\"c'\t\n\rd\xc3\xbc";
  MjcfDocument document;
  ElementWriter writer(document);
  writer.OpenElement("a");
  writer.WriteText("name", value);
  writer.CloseEmpty();
  writer.Finish();
  CHECK(document.text == "<a name=\"a&lt;b&gt;&amp;&quot;c'&#9;&#10;&#13;d\xc3\xbc\"/>\n");
  pugi::xml_document parsed;
  REQUIRE(parsed.load_buffer(document.text.data(), document.text.size()));
  CHECK(parsed.child("a").attribute("name").value() == value);
}

TEST_CASE("numbers stand one space apart with at most ten digits") {
  MjcfDocument document;
  ElementWriter writer(document);
  const double values[] = {1.0 / 3, -0.0, 1e-8, 250};
  writer.OpenElement("a");
  writer.WriteNumbers("v", values);
  writer.CloseEmpty();
  writer.Finish();
  CHECK(document.text == "<a v=\"0.3333333333 0 1e-08 250\"/>\n");
}

TEST_CASE("a pose leaves out an identity quaternion and rounding noise") {
  MjcfDocument document;
  ElementWriter writer(document);
  writer.OpenElement("a");
  writer.WritePose({{0, 1e-17, 2}, {1, 0, -3e-17, 0}});
  writer.CloseEmpty();
  writer.OpenElement("b");
  writer.WritePose({{0, 0, 0}, {0.6, 0.8, 0, 0}});
  writer.CloseEmpty();
  writer.Finish();
  CHECK(document.text == "<a pos=\"0 0 2\"/>\n<b pos=\"0 0 0\" quat=\"0.6 0.8 0 0\"/>\n");
}

TEST_CASE("only lines with a place in the spec have an origin") {
  MjcfDocument document;
  ElementWriter writer(document);
  writer.OpenElement("a");
  writer.BeginContent();
  writer.OpenElement("b", {1, 7, 3});
  writer.CloseEmpty();
  writer.EndElement("a");
  CHECK(document.Origin(1) == diag::SourceMark{});
  CHECK(document.Origin(2) == diag::SourceMark{1, 7, 3});
  CHECK(document.Origin(3) == diag::SourceMark{});
  CHECK(document.Origin(4) == diag::SourceMark{});
}

}  // namespace
}  // namespace mjforge::mjcf
