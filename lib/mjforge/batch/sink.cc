// Sinks (outputs of a batch) for a single file and for standard output, and the choice of the sink.

#include "mjforge/batch/sink.h"

#include <fmt/format.h>

namespace mjforge::batch {
namespace {

using Kind = output::Destination::Kind;

class FileSink : public Sink {
 public:
  explicit FileSink(const Request& request) : request_(request) {}

  bool Take(ChunkResult& result, diag::Findings& findings) override {
    if (result.text.empty()) return true;
    const std::filesystem::path& path = request_.destination.path;
    output::ObjectFolder folder(path.parent_path(),
                                {.force = request_.force, .if_changed = request_.if_changed});
    mjcf::MjcfDocument document;
    document.text = result.text;
    output::AssetHashes hashes;
    std::set<std::filesystem::path> files = {path};
    for (const HashedAsset& asset : result.assets) {
      document.assets.push_back({.name = asset.name, .file = asset.source});
      if (asset.source.empty())
        document.assets.back().made = std::make_shared<const std::string>(asset.made);
      hashes.emplace_back(asset.name, asset.sha256);
      files.insert(path.parent_path() / asset.name);
    }
    output::RemoveAbandoned(files);
    return folder.Write(path.filename().string(), document, findings, hashes);
  }

 private:
  const Request& request_;
};

class TextSink : public Sink {
 public:
  explicit TextSink(std::string& text) : text_(text) {}

  bool Take(ChunkResult& result, diag::Findings& findings) override {
    if (!result.assets.empty()) {
      findings.Warn(diag::Code::kOutputCannotWrite, {},
                    fmt::format("the object needs '{}', which standard output cannot carry",
                                result.assets.front().name),
                    "write to a file or a folder to have its assets beside it");
    }
    text_ += result.text;
    return true;
  }

 private:
  std::string& text_;
};

}  // namespace

std::unique_ptr<Sink> MakeSink(const SinkOptions& options, std::string& text) {
  switch (options.request.destination.kind) {
    case Kind::kNowhere:
      return std::make_unique<Sink>();
    case Kind::kFile:
      return std::make_unique<FileSink>(options.request);
    case Kind::kStandardOutput:
      return std::make_unique<TextSink>(text);
    case Kind::kFolder:
      return MakeFolderSink(options);
    case Kind::kArchive:
    case Kind::kArchives:
      return MakeArchiveSink(options);
    case Kind::kFamily:
      return MakeFamilySink(options);
  }
  return nullptr;
}

bool MayReplaceManifest(const std::filesystem::path& file, bool force, diag::Findings& findings) {
  const auto is_ours = [&](std::string_view start) {
    if (start.empty() || start.front() == '\0') return true;  // a power cut can leave zeros
    std::string why_not;
    std::string line;
    std::optional<bytes::LineReader> lines = bytes::LineReader::Open(file, why_not);
    // A file without text contains nothing that could be lost.
    if (!lines || !lines->Next(line, why_not)) return why_not.empty();
    return manifest::ReadRecord(line.substr(0, line.find('\0')), why_not).has_value();
  };
  return output::MayReplace(file, force, 1, is_ours, findings);
}

bool MayReplaceFamily(const std::filesystem::path& file, bool force, diag::Findings& findings) {
  const auto is_ours = [&](std::string_view) {
    return output::IsNpzWith(file, family::kFirstMember);
  };
  return output::MayReplace(file, force, 1, is_ours, findings);
}

}  // namespace mjforge::batch
