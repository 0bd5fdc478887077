// Manifests: reading records back, finding their specs, and the page about a batch.

#include "mjforge/manifest/manifest.h"
#include "fuzz/input.h"
#include "mjforge/forge/forge.h"
#include "mjforge/report/report.h"

namespace mjforge::fuzz {
namespace {

void CheckRecord(const manifest::Record& record) {
  std::string line;
  manifest::AppendRecord(line, record);
  std::string why_not;
  const auto read = manifest::ReadRecord(line, why_not);
  Must(read.has_value(), "a record cannot be read back: " + why_not);
  std::string again;
  manifest::AppendRecord(again, *read);
  Must(again == line, "a record was read back as another one:\n" + line + again);
  Must(manifest::DifferenceOfBatch(record, *read).empty(), "a record is not of its own batch");
}

void ReadRecords(const std::filesystem::path& file, diag::Sources& sources,
                 diag::Findings& findings) {
  using Outcome = manifest::RecordReader::Outcome;
  auto reader = manifest::RecordReader::Open(file, sources, findings);
  Must(reader.has_value(), "the manifest cannot be opened");
  manifest::Record record;
  bool is_first = true;
  // Only a compressed manifest can be unreadable.
  for (Outcome outcome = reader->Next(record);
       outcome != Outcome::kEnd && outcome != Outcome::kUnreadable;
       outcome = reader->Next(record)) {
    if (outcome != Outcome::kRecord) continue;
    CheckRecord(record);
    if (is_first) {
      forge::RecordedOptions(record, "the record", findings);
      forge::LoadRecordedRecipe(record, "", Folder(), sources, findings);
    }
    is_first = false;
  }
}

}  // namespace

void Run(Input input) {
  diag::Sources sources;
  diag::Findings findings;
  const bool as_page = input.Bit();
  const std::filesystem::path file = Put("manifest.jsonl", input.Rest());
  if (as_page) {
    const auto without_picture = [](const manifest::Record&) { return std::nullopt; };
    report::MakePage({.manifest = file, .spec = "", .shown = 5}, without_picture, sources,
                     findings);
  } else {
    ReadRecords(file, sources, findings);
  }
  Word(findings, sources);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
