#include <fmt/format.h>

#include <algorithm>

#include "mjforge/output/output.h"
#include "mjforge/report/cards.h"
#include "mjforge/report/report.h"
#include "mjforge/report/sections.h"

namespace mjforge::report {

extern const std::string_view kPageCss;
extern const std::string_view kPageJs;

namespace {

// A page of ours is known by this, near its start.
constexpr std::string_view kGenerator = R"(<meta name="generator" content="mjforge )";
constexpr std::size_t kHeadBytes = 4096;

// For what is only known when the variants are chosen: a few sentences.
constexpr std::size_t kSpareBytes = 20'000;

// A longer spec is not for reading in a page.
constexpr std::size_t kMaxSpecBytes = 100'000;

// Line by line, for line ends and tabs stay.
std::string CleanText(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    clean += Clean(line, 2000) + '\n';
  }
  return clean;
}

// The first of the findings, as a warning and on the page: without a spec there is still
// what was drawn.
void LoadSpec(const Request& request, Batch& batch, diag::Sources& sources,
              diag::Findings& findings) {
  diag::Findings why_not;
  const auto first_source = sources.size() + 1;
  batch.recipe = forge::LoadRecordedRecipe(*batch.gathered.first, request.spec,
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
  batch.asked = Ask(*batch.recipe, batch.gathered);
  if (sources.size() >= first_source && sources.Text(first_source).size() <= kMaxSpecBytes)
    batch.spec_text = CleanText(sources.Text(first_source));
}

void AddNotices(const Request& request, std::uint64_t bad_lines, Batch& batch,
                diag::Findings& findings) {
  const Gathered& gathered = batch.gathered;
  if (request.manifest.extension() == ".part") {
    batch.notices.emplace_back(
        "The batch is not done: its manifest is still under construction. This page shows what it "
        "has so far.");
  }
  if (bad_lines > 0) {
    batch.notices.push_back(fmt::format("{} of the manifest {}.", Counted(bad_lines, "line"),
                                        bad_lines == 1 ? "is not a record" : "are not records"));
  }
  if (!gathered.other_batch.empty()) {
    const std::string message =
        fmt::format("the manifest has variants of several batches: {}", gathered.other_batch);
    findings.Warn(diag::Code::kBatchDiffers, {}, message);
    batch.notices.push_back("The numbers below mix them: " + message + ".");
  }
  if (gathered.variants == 0)
    batch.notices.emplace_back("The manifest has no records: there is nothing to show.");
}

std::string ShownText(const Cards& cards, const Gathered& gathered) {
  std::string text =
      fmt::format("{} of {} {} shown", Counted(cards.shown()),
                  Counted(gathered.variants, "variant"), gathered.variants == 1 ? "is" : "are");
  std::vector<std::string> groups;
  const std::uint64_t bad = gathered.variants - gathered.statuses.ok;
  if (bad > 0) {
    groups.push_back(fmt::format("{} of the {} that failed or were skipped", Counted(cards.failed),
                                 Counted(bad)));
  }
  if (cards.slow > 0)
    groups.push_back(fmt::format("the {} slowest to come to rest", Counted(cards.slow)));
  if (!groups.empty() || cards.shown() < gathered.variants)
    groups.push_back(fmt::format("{} spread over the {}", Counted(cards.sampled),
                                 groups.empty() ? "batch" : "others"));
  for (std::size_t i = 0; i < groups.size(); ++i)
    text += (i == 0 ? ": " : i + 1 == groups.size() ? ", then " : ", ") + groups[i];
  text += ".";
  if (cards.left_out > 0) {
    text += fmt::format(" The page is full: {} more did not fit into {} MB.",
                        Counted(cards.left_out), kMaxBytes / 1'000'000);
  }
  return text;
}

void AddOptions(Dictionary& body, const Gathered& gathered) {
  for (const auto status : manifest::kStatusesByName) {
    if (gathered.statuses.Of(status) > 0) ShowText(body, "STATUS_OPTION", NameOf(status));
  }
  for (const auto& [code, tally] : gathered.codes) ShowText(body, "CODE_OPTION", Clean(code, 120));
}

// The page with these cards; the same but for them and a few words for any other.
std::string Render(const Request& request, const Batch& batch, const Cards& cards) {
  ctemplate::TemplateDictionary page("page");
  Set(page, "CSS", kPageCss);
  Set(page, "JS", kPageJs);
  AddOverview(page, request, batch);
  if (batch.gathered.variants > 0) {
    Dictionary& body = Section(page, "BODY");
    AddFindings(body, batch.gathered);
    AddParameters(body, batch);
    AddMassAndSize(body, batch.gathered);
    AddPhysics(body, batch.gathered);
    AddOptions(body, batch.gathered);
    if (batch.gathered.HasPhysics()) Section(body, "REST_COLUMN");
    Set(body, "SHOWN", ShownText(cards, batch.gathered));
    Set(body, "CARDS", cards.html);
  }
  return Expand(TemplateName::kPage, page);
}

void AddMissingPictures(const Cards& cards, Batch& batch, diag::Findings& findings) {
  if (cards.without_picture == 0) return;
  const std::string message =
      fmt::format("{} of {} shown {} no picture: the files are gone or cannot be drawn",
                  Counted(cards.without_picture), Counted(cards.shown(), "variant"),
                  cards.without_picture == 1 ? "has" : "have");
  findings.Warn(diag::Code::kReportNoPicture, {}, message,
                "repeat the command that made the batch, with --resume");
  batch.notices.push_back(message + ".");
}

}  // namespace

std::optional<Page> MakePage(const Request& request, const Thumbnailer& thumbnailer,
                             diag::Sources& sources, diag::Findings& findings) {
  std::uint64_t bad_lines = 0;
  std::optional<Gathered> gathered =
      Gather(request.manifest, request.shown, sources, findings, bad_lines);
  if (!gathered) return std::nullopt;
  // Broken lines and nothing else: no manifest.
  if (gathered->variants == 0 && bad_lines > 0) return std::nullopt;
  Batch batch{*std::move(gathered), {}, {}, {}, {}};
  AddNotices(request, bad_lines, batch, findings);
  if (batch.gathered.first) LoadSpec(request, batch, sources, findings);
  const std::size_t bytes = Render(request, batch, {}).size() + kSpareBytes;
  const std::size_t room = bytes < kMaxBytes ? kMaxBytes - bytes : 0;
  const Cards cards = MakeCards(batch.gathered.Choose(), batch, request, thumbnailer, room);
  AddMissingPictures(cards, batch, findings);
  return Page{Render(request, batch, cards), batch.gathered.variants, cards.shown(),
              cards.without_picture};
}

bool MayReplace(const std::filesystem::path& file, bool force, diag::Findings& findings) {
  const auto is_page = [](std::string_view head) {
    return head.substr(0, kHeadBytes).find(kGenerator) != head.npos;
  };
  return output::MayReplace(file, force, kHeadBytes, is_page, findings);
}

}  // namespace mjforge::report
