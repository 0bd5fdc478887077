// What an earlier run left: manifest, journal, seal and archive, whole or under construction. A
// batch is resumed from it, gone on with, verified and merged.

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "fuzz/input.h"
#include "mjforge/batch/batch.h"
#include "mjforge/batch/schedule.h"
#include "mjforge/batch/sink.h"

namespace mjforge::fuzz {
namespace {

using Sections = std::map<std::string, std::string, std::less<>>;

// Options are digits, so that an input can be read.
std::uint64_t Digit(Input& input) { return (input.Byte() - '0') & 0xFF; }

// "%%% NAME" begins a file.
Sections ReadSections(Input& input) {
  constexpr std::string_view kBegin = "%%% ";
  Sections sections;
  std::string* section = nullptr;
  const bool ends_line = input.Rest().ends_with('\n');
  while (!input.IsEmpty()) {
    const std::string_view line = input.Line();
    if (line.starts_with(kBegin)) {
      section = &sections[std::string(line.substr(kBegin.size()))];
    } else if (section != nullptr) {
      *section += line;
      if (!input.IsEmpty() || ends_line) *section += '\n';
    }
  }
  return sections;
}

// "@part:120@" stands for the checksum of the first 120 bytes of that section, "@part:@" for that
// of all; "@own@" as WithSealChecksum has it.
std::string WithChecksums(std::string_view text, const Sections& sections) {
  std::string out;
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find('@'), text.size());
    out += text.substr(0, begin);
    text.remove_prefix(begin);
    const std::size_t end = text.find('@', 1);
    if (end == text.npos) break;
    const std::string_view token = text.substr(1, end - 1);
    const std::size_t colon = std::min(token.find(':'), token.size());
    const auto section = sections.find(token.substr(0, colon));
    if (section == sections.end()) {
      out += text.front();
      text.remove_prefix(1);
      continue;
    }
    std::size_t size = section->second.size();
    std::from_chars(token.data() + std::min(colon + 1, token.size()), token.data() + token.size(),
                    size);
    out += bytes::ChecksumOf(std::string_view(section->second).substr(0, size));
    text.remove_prefix(end + 1);
  }
  return out += text;
}

std::string WithSealOfJournal(std::string_view line) {
  const std::size_t begin = std::min(line.find('{'), line.size());
  return std::string(line.substr(0, begin)) + WithSealChecksum(std::string(line.substr(begin)));
}

// Each line with its own checksum at its end, the first one with that of its seal, too.
std::string WithLineChecksums(std::string_view text) {
  constexpr std::size_t kDigits = 16;
  std::string out;
  while (!text.empty()) {
    const std::size_t size = std::min(text.find('\n'), text.size());
    const std::string line = WithSealOfJournal(text.substr(0, size));
    out += line;
    out += ' ';
    out += bytes::ChecksumOf(line).substr(0, kDigits);
    if (size < text.size()) out += '\n';
    text.remove_prefix(std::min(size + 1, text.size()));
  }
  return out;
}

batch::Request ReadRequest(Input& input) {
  constexpr std::array<std::string_view, 4> kOutputs = {"out", "out/x.tar", "out/x.tar.zst",
                                                        "out/x_%d.tar"};
  batch::Request request;
  const std::string_view output = kOutputs[Digit(input) % kOutputs.size()];
  const std::uint64_t flags = Digit(input);
  request.resume = (flags & 1) != 0;
  request.verify = (flags & 2) != 0;
  request.force = (flags & 4) != 0;
  request.if_changed = (flags & 8) != 0;
  request.count = std::max<std::uint64_t>(Digit(input), 1);
  const std::uint64_t per_archive = std::max<std::uint64_t>(Digit(input), 1);
  request.shard.count = std::max<std::uint64_t>(Digit(input), 1);
  request.shard.index = Digit(input) % request.shard.count;
  request.first = Digit(input);
  request.variant.name = "x";  // as seeds.py calls them
  request.durability = output::Durability::kNone;
  std::string why_not;
  const auto destination = output::ParseDestination(
      (Folder() / output).string(), output.ends_with("d.tar") ? per_archive : 0, why_not);
  Must(destination.has_value(), "no destination: " + why_not);
  request.destination = *destination;
  return request;
}

void PutFiles(const Sections& sections, const batch::Request& request) {
  const std::filesystem::path manifest = request.destination.Manifest(request.shard);
  const std::filesystem::path archive =
      request.destination.PacksVariants() ? request.destination.Archive(0) : Folder() / "out/x.tar";
  const std::map<std::string_view, std::filesystem::path> files = {
      {"manifest", manifest},
      {"part", output::PartFile::TemporaryNameOf(manifest)},
      {"journal", output::PartFile::TemporaryNameOf(manifest.string() + ".journal")},
      {"seal", manifest::SealPathOf(manifest)},
      {"archive", archive},
      {"archivepart", output::PartFile::TemporaryNameOf(archive)},
      {"object", Folder() / "out/x_000000.xml"}};
  for (const auto& [name, text] : sections) {
    const auto file = files.find(name);
    if (file == files.end()) continue;
    std::string bytes = text;
    if (name == "journal") bytes = WithLineChecksums(WithChecksums(text, sections));
    if (name == "seal") bytes = WithSealChecksum(WithChecksums(text, sections));
    Put(file->second.lexically_relative(Folder()).string(), bytes);
  }
}

// The first record there is: what resumes is the batch that it is of.
manifest::Record RecordOf(const Sections& sections) {
  for (const auto& [name, text] : sections) {
    std::string why_not;
    const auto record =
        manifest::ReadRecord(std::string_view(text).substr(0, text.find('\n')), why_not);
    if (record) return *record;
  }
  return {};
}

// As batch::Run, without workers.
void Resume(const batch::Request& request, manifest::Record record, diag::Findings& findings) {
  const batch::IndexRange all = {request.first, request.count};
  const batch::IndexRange range = batch::RangeOfShard(request.shard, all, request.destination);
  std::string text;
  const manifest::Record batch = record;
  const auto sink = batch::MakeSink({request, all, range, batch}, text);
  const std::optional<batch::ResumedVariants> resumed = sink->Open(findings);
  Must(resumed || findings.HasErrors(), "a batch is not begun, without a reason");
  if (!resumed) return;
  Must(resumed->done() <= range.count, "more is resumed than there is");
  const batch::IndexRange todo = {range.first + resumed->done(), range.count - resumed->done()};
  batch::Schedule schedule(all, todo, request.destination, 1);
  bool goes_on = true;
  for (auto chunk = schedule.Next(); chunk && goes_on; chunk = schedule.Next()) {
    batch::ChunkResult result;
    std::string lines;
    result.chunk = *chunk;
    result.done = chunk->count;
    result.statuses.assign(chunk->count, record.status);
    for (record.index = chunk->first; record.index < chunk->end(); ++record.index)
      manifest::AppendRecord(lines, record);
    result.lines = lines;
    goes_on = sink->Take(result, findings);
  }
  const bool is_done = goes_on && sink->Finish(findings);
  Must(is_done || findings.HasErrors(), "a batch is not finished, without a reason");
}

}  // namespace

void Run(Input input) {
  ClearFolder();
  const batch::Request request = ReadRequest(input);
  input.Line();
  const Sections sections = ReadSections(input);
  PutFiles(sections, request);
  diag::Sources sources;
  diag::Findings findings;
  batch::Verify(Folder() / "out", sources, findings);
  Resume(request, RecordOf(sections), findings);
  batch::Verify(Folder() / "out", sources, findings);
  batch::Merge(request.destination, request.verify, sources, findings);
  Word(findings, sources);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
