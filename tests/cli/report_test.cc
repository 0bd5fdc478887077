// Tests of `mjforge report`.

#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

bool Has(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

class ReportTest : public CrateTest {
 protected:
  ReportTest() { REQUIRE(Generate({"-n", "12", "-o", "out/"}).status == 0); }

  harness::CommandResult Generate(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"generate", "crate.yaml", "-q", "-s", "7"};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }
};

TEST_CASE_METHOD(ReportTest, "a report is a page beside the manifest, the same each time") {
  const auto result = Run({"report", "out/"});
  CHECK(result.status == 0);
  CHECK(Has(result.err, "12 of 12 variants shown, "));
  CHECK(Has(result.err, " in out/report.html\n"));
  CHECK(result.out.empty());
  const std::string page = folder().Read("out/report.html");
  CHECK(page.starts_with("<!doctype html>\n"));
  CHECK(Has(page, "<code>0.1 .. 0.2</code>"));
  CHECK(Has(page, "Half the height."));
  CHECK(Has(page, ">mjforge: 1\nname: crate\n"));
  CHECK(Has(page, "class=\"asked\""));
  CHECK(Has(page, "<code>mjforge replay out/manifest.jsonl:11</code>"));
  CHECK(Has(page, "src=\"data:image/webp;base64,"));
  CHECK(Has(page, "alt=\"Variant 11: height 0.1"));
  CHECK(Run({"report", "out", "-q"}).status == 0);  // replaces the report
  CHECK(folder().Read("out/report.html") == page);
  CHECK(Run({"report", "out/manifest.jsonl", "-o", "-"}).out == page);
}

TEST_CASE_METHOD(ReportTest, "a report shows as many variants as it is told") {
  CHECK(Has(Run({"report", "out/", "--thumbnails", "3"}).err, "3 of 12 variants shown"));
  CHECK(Has(Run({"report", "out/", "--thumbnails", "0"}).err, "0 of 12 variants shown"));
  CHECK(Run({"report", "out/", "--thumbnails", "many"}).status == 2);
  CHECK(Run({"report", "out/", "--thumbnails", "10001"}).err ==
        "mjforge: error: --thumbnails: at most 10000\n"
        "  hint: see 'mjforge report --help'\n");
}

TEST_CASE_METHOD(ReportTest, "a foreign file stays, unless it is forced away") {
  folder().Write("mine.html", "<p>mine</p>");
  const auto refused = Run({"report", "out/", "-o", "mine.html"});
  CHECK(refused.status == 3);
  CHECK(refused.err ==
        "mjforge: error: 'mine.html' exists and was not made by mjforge [output/exists]\n"
        "  hint: choose another place, or overwrite it with --force\n");
  CHECK(folder().Read("mine.html") == "<p>mine</p>");
  CHECK(Run({"report", "out/", "-o", "mine.html", "--force", "-q"}).status == 0);
  CHECK(Has(folder().Read("mine.html"), "mjforge replay"));
  const std::string manifest = folder().Read("out/manifest.jsonl");
  CHECK(Run({"report", "out/manifest.jsonl", "-o", "out/manifest.jsonl", "--force"}).status == 2);
  CHECK(Run({"report", "out/", "-o", "none/page.html"}).status == 3);
  CHECK(folder().Read("out/manifest.jsonl") == manifest);
}

TEST_CASE_METHOD(ReportTest, "no page takes the place of its manifest, however that is named") {
  const std::string manifest = folder().Read("out/manifest.jsonl");
  for (const char* what : {"out", "out/manifest.jsonl"}) {
    const auto refused = Run({"report", what, "-o", "out/../out/manifest.jsonl", "--force"});
    CHECK(refused.status == 2);
    CHECK(Has(refused.err, "-o names the manifest itself"));
    CHECK(folder().Read("out/manifest.jsonl") == manifest);
  }
}

TEST_CASE_METHOD(ReportTest, "a report without the files has no pictures and a warning") {
  for (const std::string& file : folder().Files()) {
    if (file.ends_with("0.xml")) std::filesystem::remove(folder() / file);
  }
  const auto result = Run({"report", "out/", "-q"});
  CHECK(result.status == 0);
  CHECK(result.err ==
        "mjforge: warning: 2 of 12 variants shown have no picture: the files are gone or cannot "
        "be drawn [report/no-picture]\n"
        "  hint: repeat the command that made the batch, with --resume\n");
  CHECK(Has(folder().Read("out/report.html"), "2 of 12 variants shown have no picture"));
}

TEST_CASE_METHOD(ReportTest, "a report whose spec has changed shows what was drawn") {
  folder().Write("crate.yaml", std::string(kText) + "# more\n");
  const auto result = Run({"report", "out/", "-q"});
  CHECK(result.status == 0);
  CHECK(Has(result.err, "warning: spec 'crate.yaml' has changed since"));
  const std::string page = folder().Read("out/report.html");
  CHECK(Has(page, "The expected values are unknown"));
  CHECK_FALSE(Has(page, "class=\"asked\""));
  folder().Write("old.yaml", kText);
  CHECK(Run({"report", "out/", "-q", "--spec", "old.yaml"}).err.empty());
  const std::string found = folder().Read("out/report.html");
  CHECK(Has(found, "class=\"asked\""));
  CHECK(Has(found, "<code>mjforge replay out/manifest.jsonl:11 --spec old.yaml</code>"));
}

TEST_CASE_METHOD(ReportTest, "a broken line is an error, and the page is made of the others") {
  folder().Write("out/manifest.jsonl", folder().Read("out/manifest.jsonl") + "{\n");
  const auto result = Run({"report", "out/"});
  CHECK(result.status == 1);
  CHECK(
      result.err.starts_with("out/manifest.jsonl:13:1: error: this line is not a record: it is "
                             "not a JSON object [output/bad-manifest]\n{\n^\n12 of 12 variants"));
  CHECK(Has(folder().Read("out/report.html"), "1 line of the manifest is not a record."));
}

TEST_CASE_METHOD(ReportTest, "an unfinished batch has a report of what is done") {
  folder().Write("part/.manifest.jsonl.part", folder().Read("out/manifest.jsonl").substr(0, 2000));
  const auto result = Run({"report", "part/.manifest.jsonl.part", "--spec", "crate.yaml"});
  CHECK(result.status == 0);
  CHECK(Has(result.err, " in part/report.html\n"));
  CHECK(Has(folder().Read("part/report.html"), "The batch is not done"));
  CHECK(Run({"report", "part"}).err ==
        "mjforge: error: 'part' is not the folder of a batch: it has no manifest.jsonl "
        "[output/bad-manifest]\n"
        "  hint: did you mean 'part/.manifest.jsonl.part'?\n");
}

TEST_CASE_METHOD(ReportTest, "archives and shards have reports") {
  REQUIRE(Generate({"-n", "6", "-o", "x.tar.zst"}).status == 0);
  CHECK(Has(Run({"report", "x.tar.zst"}).err, " in x.report.html\n"));
  CHECK(Has(folder().Read("x.report.html"), "src=\"data:image/webp;base64,"));
  REQUIRE(Generate({"-n", "6", "-o", "y_%02d.tar", "--per-archive", "2"}).status == 0);
  CHECK(Run({"report", "y_%02d.tar"}).err.starts_with("6 of 6 variants shown"));
  folder().Write(
      "crate.yaml",
      std::string(kText) + "# more\n");  // the changed spec makes it read members of the archive
  CHECK_FALSE(Has(Run({"report", "y_%02d.tar"}).err, "no picture"));
  REQUIRE(Generate({"-n", "6", "-o", "part/", "--shard", "1/3"}).status == 0);
  CHECK(Has(Run({"report", "part/manifest-00001-of-00003.jsonl"}).err, "2 of 2 variants shown, "));
  CHECK(Has(folder().Read("part/report-00001-of-00003.html"), "<dd>2 to 3</dd>"));
}

TEST_CASE_METHOD(ReportTest, "what is no batch is a finding") {
  CHECK(Run({"report", "none"}).err ==
        "mjforge: error: cannot read 'none': No such file or directory [yaml/cannot-read]\n");
  CHECK(Run({"report", "none"}).status == 3);
  CHECK(Run({"report", "none.jsonl"}).status == 3);
  const auto file = Run({"report", "crate.yaml"});
  CHECK(file.status == 1);
  CHECK(Has(file.err, "'crate.yaml' is not a manifest [output/bad-manifest]\n"));
  CHECK(Has(Run({"report", "."}).err, "did you mean './out/manifest.jsonl'?"));
  folder().Write("empty/manifest.jsonl", "");
  CHECK(Run({"report", "empty"}).status == 0);
  CHECK(Has(folder().Read("empty/report.html"), "The manifest has no records"));
}

TEST_CASE_METHOD(UnluckyCrateTest, "failed variants come first, with pictures of what they are") {
  REQUIRE(Run({"generate", "crate.yaml", "-q", "-n", "20", "-o", "out/"}).status == 1);
  CHECK(Run({"report", "out/", "-q"}).status == 0);
  const std::string page = folder().Read("out/report.html");
  CHECK(Has(page, "<code>model/bad-value</code>"));
  const std::size_t first = page.find("data-status=");
  REQUIRE(first != std::string::npos);
  CHECK(page.substr(first, 20) == "data-status=\"failed\"");
}

}  // namespace
}  // namespace mjforge
