// Gallery of `mjforge catalogue --html`: makes its pages in child processes, and its index.
#include "gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "child_process.h"
#include "gallery_page.h"
#include "mjforge/output/output.h"
#include "parallel_children.h"
#include "progress_bar.h"

namespace mjforge::app {
namespace {

constexpr std::string_view kIndex = "index.html";

class Gallery {
 public:
  Gallery(const GalleryOptions& options, std::vector<report::GalleryCard> cards, Console& console)
      : options_(options),
        cards_(std::move(cards)),
        console_(console),
        findings_(cards_.size()),
        progress_(!console.quiet()) {
    for (std::size_t i = 0; i < cards_.size(); ++i) {
      if (cards_[i].problem.empty()) steps_.push_back(i);
    }
    summary_.count = steps_.size();
  }

  ExitStatus Write() {
    output::MadeFolders folders;
    if (!folders.Make(options_.folder, console_.findings) || !MayReplaceAll())
      return console_.Report();
    ExitStatus status = MakePages();
    for (std::optional<diag::Finding>& finding : findings_) {
      if (finding) console_.findings.Add(*std::move(finding));
    }
    console_.findings.Unique();  // reports a missing renderer once, not for each spec
    const std::filesystem::path index = options_.folder / kIndex;
    const bool is_written =
        output::WriteSingleFile(index, report::MakeGalleryIndex(cards_), console_.findings);
    status = Worse(status, console_.Report());
    if (is_written) {
      console_.PrintLine(
          fmt::format("{} in {}{}", Counted(cards_.size(), "spec"), index.string(),
                      Broken() > 0 ? fmt::format(", {} without a page", Broken()) : ""));
    }
    return status;
  }

 private:
  // Checks all files before the first file is written, because drawing takes long.
  bool MayReplaceAll() {
    bool may = report::MayReplace(options_.folder / kIndex, options_.force, console_.findings);
    for (const std::size_t i : steps_) {
      const auto file = options_.folder / report::GalleryPageFile(cards_[i].name);
      may = report::MayReplace(file, options_.force, console_.findings) && may;
    }
    return may;
  }

  ExitStatus MakePages() {
    GalleryPages pages(options_.folder);
    const auto name = [&](std::size_t step) { return cards_[steps_[step]].name; };
    const ExitStatus status =
        RunInChildren({.count = steps_.size(),
                       .time_limit = options_.time_limit,
                       .run = [&](std::size_t step) { return pages.Make(name(step)).Pack(); },
                       .explain =
                           [&](std::size_t step, const std::string& reason) {
                             GalleryResult result;
                             diag::Findings found;
                             AddCrashFinding(name(step), reason, found);
                             result.finding = found[0];
                             result.card.problem = found[0].message;
                             return result.Pack();
                           },
                       .receive =
                           [&](std::size_t step, const std::string& bytes) {
                             Take(steps_[step], GalleryResult::Unpack(bytes));
                           }},
                      options_.jobs);
    progress_.Clear();
    return status;
  }

  void Take(std::size_t i, GalleryResult result) {
    report::GalleryCard& card = cards_[i];
    card.facts = std::move(result.card.facts);
    card.problem = std::move(result.card.problem);
    card.picture = std::move(result.card.picture);
    card.has_page = result.card.has_page;
    findings_[i] = std::move(result.finding);
    // Only warns if the page exists: such a page lacks pictures but is otherwise complete.
    if (findings_[i] && card.has_page) findings_[i]->severity = diag::Severity::kWarning;
    ++(card.has_page ? summary_.ok : summary_.failed);
    progress_.Show(summary_);
  }

  std::size_t Broken() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        cards_, [](const report::GalleryCard& card) { return !card.has_page; }));
  }

  const GalleryOptions& options_;
  std::vector<report::GalleryCard> cards_;
  Console& console_;
  std::vector<std::size_t> steps_;                      // cards whose specs can be loaded
  std::vector<std::optional<diag::Finding>> findings_;  // findings of the cards
  batch::Summary summary_;
  ProgressBar progress_;
};

}  // namespace

ExitStatus WriteGallery(const GalleryOptions& options, std::vector<report::GalleryCard> cards,
                        Console& console) {
  return Gallery(options, std::move(cards), console).Write();
}

}  // namespace mjforge::app
