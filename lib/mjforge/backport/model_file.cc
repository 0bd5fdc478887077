// Reads MJCF files, backports them, applies the rules of later releases, and loads the result.
#include "mjforge/backport/model_file.h"

#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/backport/backport.h"
#include "mjforge/bytes/bytes.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {
namespace {

using diag::Code;

std::filesystem::path FolderOf(const std::filesystem::path& file) {
  return file == bytes::kStandardInput ? std::filesystem::path(".") : file.parent_path();
}

struct BackportedTree {
  xml::XmlElement root;
  RuleDifferences differences;  // for ModelFile::differences
};

/// Returns the backported tree of a file; nullopt if the file needs no change, or after an error.
std::optional<BackportedTree> BackportFile(const std::filesystem::path& file,
                                           diag::Sources& sources, diag::Findings& findings) {
  diag::Findings of_includes;  // ignored, because MuJoCo reports problems of includes itself
  std::optional<xml::XmlElement> root = xml::ReadXml(file, sources, of_includes);
  if (!root) return std::nullopt;
  const bool is_later = BackportMjcf(*root, mjVERSION_HEADER, Use::kWholeModel, sources, findings);
  if (findings.HasErrors()) return std::nullopt;
  const RuleDifferences differences = ApplyLaterRules(*root, [&](const std::string& text) {
    return engine::Engine().LoadTextIn(FolderOf(file), text);
  });
  if (!is_later && !differences) return std::nullopt;
  return BackportedTree{*std::move(root), is_later ? RuleDifferences{} : differences};
}

}  // namespace

std::optional<ModelFile> ReadModelFile(const std::filesystem::path& file, diag::Sources& sources,
                                       diag::Findings& findings) {
  const std::string name = xml::ShownName(file);
  std::string why_not;
  std::optional<std::string> text = bytes::Read(file, bytes::kMaxMjcf, why_not);
  if (!text) {
    findings.Add(Code::kYamlCannotRead, {}, fmt::format("cannot read '{}': {}", name, why_not),
                 bytes::PipeHint(file));
    return std::nullopt;
  }
  if (const std::string_view kind = bytes::KindOf(*text); !kind.empty()) {
    findings.Add(Code::kMujocoNotMjcf, {}, fmt::format("'{}' is {}, not MJCF", name, kind));
    return std::nullopt;
  }
  const std::uint32_t source = sources.Add(name, *std::move(text));
  bool has_includes = false;
  const std::optional<xml::XmlFault> fault =
      xml::FindMjcfFault(sources.Text(source), &has_includes);
  if (fault) {
    findings.Add(Code::kMujocoNotMjcf, xml::MarkAt(sources, source, fault->offset), fault->message,
                 fault->hint);
    return std::nullopt;
  }
  diag::Findings found;
  ModelFile read{source, has_includes, {}, {}};
  if (const auto tree = BackportFile(file, sources, found)) {
    read.backported = xml::FlattenInPlace(tree->root);
    read.differences = tree->differences;
  }
  const bool good = !found.HasErrors();
  findings.Append(std::move(found));
  if (!good) return std::nullopt;
  return read;
}

std::optional<std::string> BackportedText(const std::filesystem::path& file) {
  diag::Sources sources;
  diag::Findings findings;
  std::optional<BackportedTree> tree = BackportFile(file, sources, findings);
  if (!tree) return std::nullopt;
  xml::ResolveFiles(tree->root, FolderOf(file), findings);
  return xml::Flatten(tree->root).text;
}

engine::Loaded LoadFile(engine::Engine& engine, const std::filesystem::path& file) {
  diag::Sources sources;
  diag::Findings findings;
  if (const auto read = ReadModelFile(file, sources, findings))
    return LoadFile(engine, file, *read);
  engine::Loaded failed;
  if (const diag::Finding* const error = findings.FirstError()) failed.error = error->message;
  return failed;
}

engine::Loaded LoadFile(engine::Engine& engine, const std::filesystem::path& file,
                        const ModelFile& read) {
  return read.backported ? engine.LoadTextIn(FolderOf(file), *read.backported)
                         : engine.LoadFile(file);
}

}  // namespace mjforge::backport
