// Reader of a manifest: splits the file into sections, which all cores read in parallel, and joins
// the summaries of the sections.

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <future>
#include <thread>

#include "mjforge/bytes/bytes.h"
#include "mjforge/report/manifest_summary.h"

namespace mjforge::report {
namespace {

using Path = std::filesystem::path;

// Least size of a section, bytes. The size does not depend on the number of cores, because rounding
// errors of means and variances depend on the sections.
constexpr std::uint64_t kSectionBytes = std::uint64_t{8} << 20;

struct SectionSummary {
  ManifestSummary records;
  std::uint32_t lines = 0;
  std::uint64_t bad_lines = 0;
  bool is_unreadable = false;
  // Findings of the reader, in the order of the lines of the section. Line numbers are relative to
  // the start of the section; Joiner converts them to line numbers of the whole file.
  diag::Sources sources;
  diag::Findings findings;
};

SectionSummary SummarizeSection(const Path& manifest, const bytes::FileSection& section,
                                std::size_t shown) {
  using Outcome = manifest::RecordReader::Outcome;
  SectionSummary summary{.records = ManifestSummary(shown), .sources = {}, .findings = {}};
  const bool is_part = manifest.extension() == ".part";
  auto reader = manifest::RecordReader::Open(manifest, summary.sources, summary.findings, section);
  summary.is_unreadable = !reader;
  manifest::Record record;
  for (Outcome outcome = Outcome::kRecord; reader && outcome != Outcome::kEnd;) {
    outcome = reader->Next(record);
    if (outcome == Outcome::kRecord) summary.records.Add(record);
    const bool is_cut_off = is_part && reader->is_truncated();
    if (outcome == Outcome::kBadLine && !is_cut_off) ++summary.bad_lines;
    if (outcome != Outcome::kUnreadable) continue;
    summary.is_unreadable = !is_cut_off;
    break;
  }
  if (reader) summary.lines = reader->number();
  return summary;
}

std::optional<std::vector<bytes::FileSection>> SectionsOf(const Path& manifest,
                                                          diag::Findings& findings) {
  const std::optional<std::vector<std::uint64_t>> cuts = manifest::CutsOf(manifest, findings);
  if (!cuts) return std::nullopt;
  std::vector<bytes::FileSection> sections(1);
  for (const std::uint64_t cut : *cuts) {
    if (cut - sections.back().begin < kSectionBytes) continue;
    sections.back().end = cut;
    sections.push_back({.begin = cut});
  }
  return sections;
}

// Joins the summaries of consecutive sections.
class Joiner {
 public:
  Joiner(const Path& file, std::size_t shown, diag::Sources& sources, diag::Findings& findings)
      : file_(file), batch_(shown), sources_(sources), findings_(findings) {}

  // Appends the next section. Returns false, after adding findings, if the section could not be
  // read, or if the file has too many lines that are not records.
  bool Append(const SectionSummary& section) {
    const std::uint64_t all = section.is_unreadable ? section.findings.size() : section.bad_lines;
    const std::uint64_t room = manifest::RecordReader::kMaxBadLines - findings_count_;
    const std::uint64_t count = std::min<std::uint64_t>({all, section.findings.size(), room});
    for (std::size_t i = 0; i < count; ++i) Add(section, section.findings[i]);
    if (section.is_unreadable && count < all)
      Add(section, section.findings[section.findings.size() - 1]);
    batch_.Append(section.records);
    lines_ += section.lines;
    bad_lines_ += section.bad_lines;
    if (section.is_unreadable) return false;
    if (bad_lines_ <= manifest::RecordReader::kMaxSkippedLines) return true;
    findings_.AddCannotRead(file_.string(), fmt::format("more than {} lines are not records",
                                                        manifest::RecordReader::kMaxSkippedLines));
    return false;
  }

  const ManifestSummary& batch() const { return batch_; }
  std::uint64_t bad_lines() const { return bad_lines_; }

 private:
  // Adds a finding of a section. Replaces its line number by that in the whole file.
  void Add(const SectionSummary& section, const diag::Finding& finding) {
    diag::SourceMark mark = finding.mark;
    if (mark.file > 0) {
      mark.line += lines_;
      mark.file =
          sources_.Add(section.sources.Name(mark.file), section.sources.Text(mark.file), mark.line);
    }
    findings_.Add(finding.code, mark, finding.message, finding.hint);
    ++findings_count_;
  }

  const Path& file_;
  ManifestSummary batch_;
  std::uint32_t lines_ = 0;
  std::uint64_t bad_lines_ = 0;
  std::uint64_t findings_count_ = 0;
  diag::Sources& sources_;
  diag::Findings& findings_;
};

}  // namespace

std::optional<ManifestSummary> Summarize(const Path& manifest, std::size_t shown,
                                         diag::Sources& sources, diag::Findings& findings,
                                         std::uint64_t& bad_lines) {
  const std::optional<std::vector<bytes::FileSection>> sections = SectionsOf(manifest, findings);
  if (!sections) return std::nullopt;
  // Reads one more section than there are cores at a time, because otherwise a core would wait
  // while summaries are joined.
  const std::size_t jobs = std::max(1U, std::thread::hardware_concurrency()) + 1;
  Joiner joiner(manifest, shown, sources, findings);
  std::deque<std::future<SectionSummary>> running;
  for (auto next = sections->begin(); next != sections->end() || !running.empty();) {
    if (next != sections->end() && running.size() < jobs) {
      running.push_back(std::async([&manifest, section = *next++, shown] {
        return SummarizeSection(manifest, section, shown);
      }));
      continue;
    }
    const SectionSummary section = running.front().get();
    running.pop_front();
    if (!joiner.Append(section)) return std::nullopt;
  }
  bad_lines = joiner.bad_lines();
  return joiner.batch();
}

}  // namespace mjforge::report
