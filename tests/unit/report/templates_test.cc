#include "mjforge/report/templates.h"

#include <catch2/catch.hpp>

#include "mjforge/report/charts.h"

namespace mjforge::report {
namespace {

constexpr const char* kHostile = "</script><img src=x onerror=alert(1)>\"'&";
constexpr const char* kEscaped =
    "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;&quot;&#39;&amp;";

using namespace std::string_literals;

TEST_CASE("base64 is that of RFC 4648") {
  CHECK(Base64("").empty());
  CHECK(Base64("f") == "Zg==");
  CHECK(Base64("fo") == "Zm8=");
  CHECK(Base64("foo") == "Zm9v");
  CHECK(Base64("foobar") == "Zm9vYmFy");
  CHECK(Base64("\xff\xfe\xfd"s) == "//79");
  CHECK(Base64("\0\0"s) == "AAA=");
}

TEST_CASE("a text in a template is escaped, between tags and in an attribute") {
  ctemplate::TemplateDictionary row("row");
  Set(row, "STATUS", kHostile);
  Set(row, "REPLAY", kHostile);
  const std::string html = Expand(TemplateName::kRow, row);
  CHECK(html.find(std::string("data-status=\"") + kEscaped + "\"") != html.npos);
  CHECK(html.find(std::string("<code>") + kEscaped + "</code>") != html.npos);
  CHECK(html.find("<img src=x") == html.npos);
  CHECK(html.find("</script>") == html.npos);
}

TEST_CASE("a text in a chart is escaped") {
  ctemplate::TemplateDictionary page("page");
  BarChart chart{"id", kHostile, {{kHostile, {1, 0}}, {"b", {2, 1}}}, {}};
  Dictionary& parameters = Section(Section(page, "BODY"), "PARAMETERS");
  Dictionary& list = Include(parameters, "PANELS", TemplateName::kPanels);
  AddBars(Section(list, "PARAMETER"), chart);
  const std::string html = Expand(TemplateName::kPage, page);
  CHECK(html.find(std::string("<title id=\"id-title\">") + kEscaped) != html.npos);
  CHECK(html.find("<img src=x") == html.npos);
}

TEST_CASE("clean text has no control characters and a length") {
  CHECK(Clean("a\nb\x1b[0m\xff") == "a\\nb\\x1b[0m\\xff");
  CHECK(Clean("abcdef", 4) == "abcd...");
  CHECK(Clean("abcd", 4) == "abcd");
  CHECK(Clean("\xc3\xa4\xc3\xa4\xc3\xa4", 3) == "\xc3\xa4...");
}

TEST_CASE("numbers are counted with their nouns") {
  CHECK(CountText(0) == "0");
  CHECK(CountText(999) == "999");
  CHECK(CountText(1000) == "1,000");
  CHECK(CountText(1234567) == "1,234,567");
  CHECK(CountText(1, "variant") == "1 variant");
  CHECK(CountText(2000, "variant") == "2,000 variants");
}

TEST_CASE("a share is none or all only if it is") {
  CHECK(ShareText(0, 10) == "0 %");
  CHECK(ShareText(10, 10) == "100 %");
  CHECK(ShareText(1, 8) == "12.5 %");
  CHECK(ShareText(1, 100'000) == "0.1 %");
  CHECK(ShareText(99'999, 100'000) == "99.9 %");
  CHECK(ShareText(0, 0) == "0 %");
}

}  // namespace
}  // namespace mjforge::report
