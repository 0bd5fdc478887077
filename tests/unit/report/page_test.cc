#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "harness/temporary_folder.h"
#include "mjforge/report/report.h"
#include "report_records.h"

namespace mjforge::report {
namespace {

struct PageTest {
  std::optional<Page> Make(
      const std::string& text, std::size_t shown = 200,
      const Thumbnailer& thumbnailer = [](const auto&) { return Picture(100); }) {
    findings.clear();
    return MakePage({folder.Write("manifest.jsonl", text), "", shown}, thumbnailer, sources,
                    findings);
  }
  bool Has(const std::optional<Page>& page, const std::string& words) const {
    return page && page->html.find(words) != std::string::npos;
  }

  harness::TemporaryFolder folder;
  diag::Sources sources;
  diag::Findings findings;
};

TEST_CASE_METHOD(PageTest, "the same input gives the same page") {
  const auto page = Make(ManifestOf(50, 7));
  REQUIRE(page);
  CHECK(page->variants == 50);
  CHECK(page->shown == 50);
  CHECK(Make(ManifestOf(50, 7))->html == page->html);
}

TEST_CASE_METHOD(PageTest, "a page says that its spec is gone and shows what was drawn") {
  const auto page = Make(ManifestOf(50));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "cannot find the spec 'mug.yaml'");
  CHECK(findings[0].severity == diag::Severity::kWarning);
  CHECK(Has(page, "The expected values are unknown"));
  CHECK(Has(page, "Histogram of 50 values from 0.1 to 0.19"));
  CHECK_FALSE(Has(page, "class=\"asked\""));
}

TEST_CASE_METHOD(PageTest, "an empty batch has a page that says so") {
  const auto page = Make("");
  CHECK(Has(page, "The manifest has no records: there is nothing to show."));
  CHECK(Has(page, "0 variants"));
  CHECK(findings.empty());
}

TEST_CASE_METHOD(PageTest, "a file without any record has no page") {
  CHECK_FALSE(Make("one: two\nthree\n"));
  CHECK(findings.size() == 2);
  CHECK_FALSE(MakePage({folder / "none.jsonl", "", 1}, {}, sources, findings));
}

TEST_CASE_METHOD(PageTest, "missing pictures are a warning, and stand on the page") {
  const auto page = Make(ManifestOf(10), 200, [](const manifest::Record& record) {
    return record.index < 4 ? std::optional(Picture(100)) : std::nullopt;
  });
  REQUIRE(findings.size() == 2);
  CHECK(findings[1].code == diag::Code::kReportNoPicture);
  CHECK(findings[1].message ==
        "6 of 10 variants shown have no picture: the files are gone or cannot be drawn");
  CHECK(page->without_picture == 6);
  CHECK(Has(page, "6 of 10 variants shown have no picture"));
}

TEST_CASE_METHOD(PageTest, "no page is larger than it may be") {
  const auto page = Make(ManifestOf(3000), 3000, [](const auto&) { return Picture(20'000); });
  REQUIRE(page);
  CHECK(page->html.size() <= kMaxBytes);
  CHECK(page->html.size() > kMaxBytes * 9 / 10);
  CHECK(page->shown < 3000);
  CHECK(Has(page, "The page is full: "));
}

TEST_CASE_METHOD(PageTest, "a record of enormous texts and many parameters does no harm") {
  const auto enormous = static_cast<std::size_t>(harness::Effort(20'000));
  manifest::Record record = RecordOf(0);
  record.params.clear();
  for (int i = 0; i < 2000; ++i)
    record.params.emplace_back("p" + std::to_string(i), std::string(enormous, 'x'));
  record.spec = std::string(100'000, 's');
  std::string text;
  manifest::AppendRecord(text, record);
  record.index = 1;
  for (auto& [name, value] : record.params) value = std::string(enormous, 'y');
  manifest::AppendRecord(text, record);
  const auto page = Make(text);
  REQUIRE(page);
  CHECK(page->html.size() < 500'000);
  CHECK(Has(page, "The first 100 of 2,000 parameters."));
  CHECK(Has(page, "and 1960 in the manifest"));
}

TEST_CASE_METHOD(PageTest, "a page says what was tried, and how often it came out well") {
  std::string text;
  for (std::uint64_t i = 0; i < 4; ++i) {
    manifest::Record record = RecordOf(i);
    record.physics.emplace();
    record.physics->simready = {.ground_drop = i == 0 ? "fail" : "pass"};
    for (const bool held : {i > 1, i == 3})
      record.physics->grasps.push_back({.site = "rim", .body = "mug", .held = held});
    manifest::AppendRecord(text, record);
  }
  const auto page = Make(text);
  const auto row = [](const std::string& name, const std::string& words, const std::string& passed,
                      const std::string& failed) {
    return "<th scope=\"row\"><code>" + name + "</code><span class=\"muted\">" + words +
           "</span></th>\n<td class=\"number passed\">" + passed +
           "</td>\n<td class=\"number failed\">" + failed + "</td>";
  };
  CHECK(Has(page, row("ground_drop", "SimReady benchmark", "3", "1")));
  CHECK(Has(page, row("rim", "Jaws lift and hold it; 3 of 8 ways do.", "2", "2")));
  CHECK_FALSE(Has(page, "slope_drop"));
  CHECK_FALSE(Has(Make(ManifestOf(4)), "What was tried"));
}

TEST_CASE_METHOD(PageTest, "a page may replace a page and nothing else") {
  const auto page = folder.Write("page.html", Make(ManifestOf(3))->html);
  const auto other = folder.Write("other.html", "<!doctype html><title>mine</title>");
  findings.clear();
  CHECK(MayReplace(page, false, findings));
  CHECK(MayReplace(folder / "new.html", false, findings));
  CHECK(MayReplace(other, true, findings));
  CHECK(findings.empty());
  CHECK_FALSE(MayReplace(other, false, findings));
  CHECK(findings[0].message == "'" + other.string() + "' exists and was not made by mjforge");
  CHECK_FALSE(MayReplace(folder.path(), false, findings));
}

}  // namespace
}  // namespace mjforge::report
