// Sink that writes a family: collects rows of variants, and at the end writes columns of numbers.

#include "mjforge/batch/archive_sink.h"
#include "mjforge/batch/family_files.h"

namespace mjforge::batch {
namespace {

class FamilySink : public ArchiveSink {
 public:
  using ArchiveSink::ArchiveSink;

  std::optional<ResumedVariants> Open(diag::Findings& findings) override {
    const bool may_write = !is_whole() || destination_.IsSplit() ||
                           MayReplaceFamily(destination_.path, request_.force, findings);
    return may_write ? ArchiveSink::Open(findings) : std::nullopt;
  }

 protected:
  std::filesystem::path FileOf(std::uint64_t) const override {
    return destination_.Rows(request_.shard);
  }

  bool IsOwn(const std::filesystem::path& file) const override { return family::IsRows(file); }

  // Returns 1 if all families are intact, otherwise 0: they are closed together, like one archive.
  std::uint64_t CountClosed(std::uint64_t intact, std::uint64_t files) const override {
    return intact == files && files > 0 ? 1 : 0;
  }

  bool AppendAsset(const std::string& name, std::string_view bytes,
                   diag::Findings& findings) override {
    return file()->Append(family::AssetBlock(name, bytes), findings);
  }

  bool CloseFile(const Checkpoint& next, diag::Findings& findings) override {
    if (!is_whole()) return Seal({&file(), 1}, next, findings);
    const std::filesystem::path made[] = {file()->temporary()};
    const auto families =
        WriteFamilies(destination_, made, options_.batch, options_.all, request_.force, findings);
    if (families.empty() || !Seal(families, next, findings)) return false;
    file()->Drop();
    return true;
  }

 private:
  bool is_whole() const { return request_.shard.IsWhole(); }
};

}  // namespace

std::unique_ptr<Sink> MakeFamilySink(const SinkOptions& options) {
  return std::make_unique<FamilySink>(options);
}

}  // namespace mjforge::batch
