// The page of a report: assembles its sections and the table of variants within the limit of size.

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/output/output.h"
#include "mjforge/report/page_sections.h"
#include "mjforge/report/report.h"
#include "mjforge/report/variant_rows.h"

namespace mjforge::report {

extern const std::string_view kPageJs;

namespace {

// HTML by which MayReplace() recognizes pages of mjforge, within the first kHeadBytes of a file.
constexpr std::string_view kGenerator = R"(<meta name="generator" content="mjforge )";
constexpr std::size_t kHeadBytes = 4096;

// Bytes of the page that are reserved for sentences whose length depends on the shown variants.
constexpr std::size_t kSpareBytes = 20'000;

// Loads the spec that the manifest names. If this fails, adds the first finding as a warning and as
// a notice, because the page can still show the drawn values.
void LoadSpec(const Request& request, Batch& batch, diag::Sources& sources,
              diag::Findings& findings) {
  diag::Findings why_not;
  const auto first_source = sources.size() + 1;
  batch.recipe = forge::LoadRecordedRecipe(*batch.summary.first, request.spec,
                                           request.manifest.parent_path(), sources, why_not);
  if (!batch.recipe) {
    const diag::Finding& first = why_not[0];
    const std::string message =
        first.mark ? fmt::format("the spec can no longer be read: {}", first.message)
                   : first.message;
    findings.Warn(first.code, {}, message, first.hint);
    batch.notices.push_back(fmt::format(
        "The expected values are unknown: {}. Only what was drawn is shown below.", message));
    return;
  }
  batch.expected = DrawExpected(*batch.recipe, batch.summary);
  if (sources.size() >= first_source) batch.spec_text = CleanSpec(sources.Text(first_source));
}

void AddNotices(const Request& request, std::uint64_t bad_lines, Batch& batch,
                diag::Findings& findings) {
  const ManifestSummary& summary = batch.summary;
  if (request.manifest.extension() == ".part") {
    batch.notices.emplace_back(
        "The batch is not done: its manifest is still under construction. This page shows what it "
        "has so far.");
  }
  if (bad_lines > 0) {
    batch.notices.push_back(fmt::format("{} of the manifest {}.", CountText(bad_lines, "line"),
                                        bad_lines == 1 ? "is not a record" : "are not records"));
  }
  if (!summary.other_batch.empty()) {
    const std::string message =
        fmt::format("the manifest has variants of several batches: {}", summary.other_batch);
    findings.Warn(diag::Code::kBatchDiffers, {}, message);
    batch.notices.push_back("The numbers below mix them: " + message + ".");
  }
  if (summary.variants == 0)
    batch.notices.emplace_back("The manifest has no records: there is nothing to show.");
}

std::string ShownText(const VariantRows& rows, const ManifestSummary& summary) {
  std::string text =
      fmt::format("{} of {} {} shown", CountText(rows.shown()),
                  CountText(summary.variants, "variant"), summary.variants == 1 ? "is" : "are");
  std::vector<std::string> groups;
  const std::uint64_t bad = summary.variants - summary.statuses.ok;
  if (bad > 0) {
    groups.push_back(fmt::format("{} of the {} that failed or were skipped", CountText(rows.failed),
                                 CountText(bad)));
  }
  if (rows.slow > 0)
    groups.push_back(fmt::format("the {} slowest to come to rest", CountText(rows.slow)));
  if (!groups.empty() || rows.shown() < summary.variants)
    groups.push_back(fmt::format("{} spread over the {}", CountText(rows.sampled),
                                 groups.empty() ? "batch" : "others"));
  for (std::size_t i = 0; i < groups.size(); ++i)
    text += (i == 0 ? ": " : i + 1 == groups.size() ? ", then " : ", ") + groups[i];
  text += ".";
  if (rows.left_out > 0) {
    text += fmt::format(" The page is full: {} more did not fit into {} MB.",
                        CountText(rows.left_out), kMaxBytes / 1'000'000);
  }
  return text;
}

void AddOptions(Dictionary& body, const ManifestSummary& summary) {
  for (const auto status : manifest::kStatusesByName) {
    if (summary.statuses.Of(status) > 0) ShowText(body, "STATUS_OPTION", NameOf(status));
  }
  for (const auto& [code, tally] : summary.codes) ShowText(body, "CODE_OPTION", Clean(code, 120));
}

// Returns the HTML of the page with these rows. The size of the page without the rows is nearly
// constant; MakePage() relies on this.
std::string Render(const Request& request, const Batch& batch, const VariantRows& rows) {
  ctemplate::TemplateDictionary page("page");
  Set(page, "CSS", kPageCss);
  Set(page, "JS", kPageJs);
  AddOverview(page, request, batch);
  if (batch.summary.variants > 0) {
    Dictionary& body = Section(page, "BODY");
    AddFindings(body, batch.summary);
    AddParameters(body, batch);
    AddMassAndSize(body, batch.summary);
    AddPhysics(body, batch.summary);
    AddOptions(body, batch.summary);
    if (batch.summary.HasPhysics()) Section(body, "REST_COLUMN");
    Set(body, "SHOWN", ShownText(rows, batch.summary));
    Set(body, "ROWS", rows.html);
  }
  return Expand(TemplateName::kPage, page);
}

void AddMissingPictures(const VariantRows& rows, Batch& batch, diag::Findings& findings) {
  if (rows.without_picture == 0) return;
  const std::string message =
      fmt::format("{} of {} shown {} no picture: the files are gone or cannot be drawn",
                  CountText(rows.without_picture), CountText(rows.shown(), "variant"),
                  rows.without_picture == 1 ? "has" : "have");
  findings.Warn(diag::Code::kReportNoPicture, {}, message,
                "repeat the command that made the batch, with --resume");
  batch.notices.push_back(message + ".");
}

}  // namespace

std::optional<Page> MakePage(const Request& request, const Thumbnailer& thumbnailer,
                             diag::Sources& sources, diag::Findings& findings) {
  std::uint64_t bad_lines = 0;
  std::optional<ManifestSummary> summary =
      Summarize(request.manifest, request.shown, sources, findings, bad_lines);
  if (!summary) return std::nullopt;
  // A file in which no line is a record is not a manifest.
  if (summary->variants == 0 && bad_lines > 0) return std::nullopt;
  Batch batch{*std::move(summary), {}, {}, {}, {}};
  AddNotices(request, bad_lines, batch, findings);
  if (batch.summary.first) LoadSpec(request, batch, sources, findings);
  const std::size_t bytes = Render(request, batch, {}).size() + kSpareBytes;
  const std::size_t room = bytes < kMaxBytes ? kMaxBytes - bytes : 0;
  const VariantRows rows =
      MakeVariantRows(batch.summary.Choose(), batch, request, thumbnailer, room);
  AddMissingPictures(rows, batch, findings);
  return Page{Render(request, batch, rows), batch.summary.variants, rows.shown(),
              rows.without_picture};
}

bool MayReplace(const std::filesystem::path& file, bool force, diag::Findings& findings) {
  const auto is_page = [](std::string_view head) {
    return head.substr(0, kHeadBytes).find(kGenerator) != head.npos;
  };
  return output::MayReplace(file, force, kHeadBytes, is_page, findings);
}

}  // namespace mjforge::report
