// The sink of a family: collects rows of variants, and at the end writes columns of numbers.

#include "mjforge/batch/archive_sink.h"
#include "mjforge/batch/family_facts.h"
#include "mjforge/batch/family_rows.h"

namespace mjforge::batch {
namespace {

class FamilySink : public ArchiveSink {
 public:
  using ArchiveSink::ArchiveSink;

  std::optional<ResumedVariants> Open(diag::Findings& findings) override {
    if (is_whole() && !MayReplaceFamily(destination_.path, request_.force, findings))
      return std::nullopt;
    return ArchiveSink::Open(findings);
  }

 protected:
  std::filesystem::path FileOf(std::uint64_t) const override {
    return destination_.Rows(request_.shard);
  }

  bool IsOwn(const std::filesystem::path& file) const override {
    diag::Findings ignored;
    return family::ReadHeader(file, ignored).has_value();
  }

  // The file begins with the header of its first chunk that has variants.
  std::optional<std::string> Before(const ChunkResult& result, diag::Findings& findings) override {
    if (result.text.empty()) return std::string();
    if (header_.empty()) {
      const auto header = family::ReadHeader(file().temporary(), findings);
      if (!header) return std::nullopt;
      header_ = *header;
    }
    if (header_.empty()) return header_ = result.text;
    const std::string difference = family::DifferenceOf(result.text, header_);
    if (difference.empty()) return std::string();
    ReportOtherStructure(result.chunk.first, options_.range.first, difference, findings);
    return std::nullopt;
  }

  bool AppendAsset(const std::string& name, std::string_view bytes,
                   diag::Findings& findings) override {
    return file().Append(family::AssetBlock(name, bytes), findings);
  }

  bool CloseFile(const Checkpoint& next, diag::Findings& findings) override {
    const std::filesystem::path rows = FileOf(0);
    if (!is_whole()) return Seal(file(), rows.filename().string(), next, findings);
    const std::unique_ptr<output::PartFile> npz =
        output::PartFile::Open(destination_.path, findings);
    if (!npz || !npz->Truncate(0, findings)) return false;
    const std::filesystem::path made[] = {file().temporary()};
    if (!family::WriteNpz(made, FactsOf(options_.batch, options_.all), *npz, findings) ||
        findings.HasErrors()) {
      npz->Drop();
      return false;
    }
    if (!Seal(*npz, destination_.path.filename().string(), next, findings)) return false;
    file().Drop();
    return true;
  }

 private:
  bool is_whole() const { return request_.shard.IsWhole(); }

  std::string header_;
};

}  // namespace

std::unique_ptr<Sink> MakeFamilySink(const SinkOptions& options) {
  return std::make_unique<FamilySink>(options);
}

}  // namespace mjforge::batch
