#include <algorithm>
#include <filesystem>
#include <fstream>

#include "mjforge/batch/sink.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

// Workers write the files; the manifest is written here.
class FolderSink : public Sink {
 public:
  explicit FolderSink(const SinkOptions& options)
      : options_(options),
        request_(options.request),
        folder_(request_.destination.Folder()),
        file_(request_.destination.Manifest(request_.shard)) {}

  std::optional<Kept> Open(diag::Findings& findings) override {
    if (!folders_.Make(folder_, findings)) return std::nullopt;
    if (!MayReplaceManifest(file_, request_.force, findings)) return std::nullopt;
    std::error_code ignored;
    replaces_ = std::filesystem::exists(file_, ignored) || output::PartFile::Exists(file_);
    part_ = output::PartFile::Open(file_, findings);
    if (!part_) return std::nullopt;
    if (request_.resume || part_->size() > 0) RemoveHalfWritten();
    std::optional<Kept> kept = request_.resume ? Continue(findings) : Kept();
    if (!kept && part_->size() == 0) part_->Drop();  // made just now
    if (!kept || !part_->Truncate(kept->bytes, findings)) return std::nullopt;
    return kept;
  }

  output::Overwrite overwrite() const override {
    return {.force = request_.force,
            .assets = replaces_ || !request_.shard.IsWhole(),
            .if_changed = request_.if_changed};
  }

  bool Take(Result& result, diag::Findings& findings) override {
    return part_->Append(result.lines, findings);
  }

  bool Finish(diag::Findings& findings) override {
    return part_->Commit(request_.if_changed || request_.resume, findings);
  }

  void Drop() override { part_->Drop(); }

 private:
  // Nobody else makes this range. Assets may be another shard's.
  void RemoveHalfWritten() const {
    const auto is_ours = [range = options_.range](std::uint64_t index) {
      return index >= range.first && index - range.first < range.count;
    };
    output::RemoveHalfWritten(folder_, is_ours, request_.shard.IsWhole());
  }

  // What is on disk is trusted by its hash, so that a file that was lost or
  // changed since is made again.
  bool IsThere(const manifest::Record& record) const {
    if (record.status != Status::kOk) return true;
    std::string why_not;
    const auto text = bytes::Read(folder_ / record.file, bytes::kMaxMjcf, why_not);
    return text && bytes::Sha256Of(*text) == record.sha256;
  }

  std::optional<Kept> Continue(diag::Findings& findings) {
    const auto is_there = [this](const manifest::Record& record) { return IsThere(record); };
    if (part_->size() > 0) return ReadKept(part_->temporary(), options_, is_there, findings);
    // A finished batch: its manifest is checked, and gone on with where it ends.
    const std::optional<Kept> kept = ReadKept(file_, options_, is_there, findings);
    return kept && Copy(kept->bytes, findings) ? kept : std::nullopt;
  }

  bool Copy(std::uint64_t bytes, diag::Findings& findings) {
    std::ifstream manifest(file_, std::ios::binary);
    std::string buffer(1 << 20, '\0');
    while (bytes > 0) {
      manifest.read(buffer.data(),
                    static_cast<std::streamsize>(std::min<std::uint64_t>(bytes, buffer.size())));
      const auto count = static_cast<std::uint64_t>(manifest.gcount());
      if (count == 0 || !part_->Append(std::string_view(buffer).substr(0, count), findings))
        return false;
      bytes -= count;
    }
    return true;
  }

  SinkOptions options_;
  const Request& request_;
  std::filesystem::path folder_;
  std::filesystem::path file_;
  output::MadeFolders folders_;  // goes after the part file
  std::unique_ptr<output::PartFile> part_;
  bool replaces_ = false;  // an older batch, whose assets may differ
};

}  // namespace

std::unique_ptr<Sink> MakeFolderSink(const SinkOptions& options) {
  return std::make_unique<FolderSink>(options);
}

}  // namespace mjforge::batch
