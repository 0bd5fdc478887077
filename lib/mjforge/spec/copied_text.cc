// Texts of new specs: copies of others, whose references lead to the same files, and the starter.

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/spec/locate.h"
#include "mjforge/spec/snapshot.h"
#include "mjforge/spec/spec.h"
#include "mjforge/spec/spec_files.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {

extern const std::string_view kStarterYaml;  // content of starter.yaml

namespace {

namespace fs = std::filesystem;

// Keys whose values are names or paths of specs, and keys whose values are paths of other files.
constexpr std::array<std::string_view, 2> kSpecKeys = {"import", "spec"};
constexpr std::array<std::string_view, 3> kFileKeys = {"file", "mjcf", "rows"};
// Keys whose values may be the same word as an object's name.
constexpr std::array<std::string_view, 2> kWordKeys = {"material", "type"};

bool Has(std::span<const std::string_view> keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

// Collects the changes of a text, and makes them.
class TextCopier {
 public:
  TextCopier(const diag::Sources& sources, std::uint32_t source, fs::path from, fs::path to,
             const std::vector<fs::path>& search_path)
      : text_(sources.Text(source)),
        from_(std::move(from)),
        to_(std::move(to)),
        search_path_(search_path) {
    for (std::size_t at = 0; at < text_.size(); ++at) {
      if (at == 0 || text_[at - 1] == '\n') lines_.push_back(at);
    }
  }

  /// Renames the object: its name, and the references to its root body outside of parameters.
  void Rename(const YamlNode& root, const std::string& old_name, const std::string& new_name) {
    for (const YamlNode::Pair& section : root.pairs) {
      if (section.key != "params" && section.key != "functions")
        RenameBelow(section.value, section.key, old_name, new_name);
    }
  }

  /// Changes the references to files below a node.
  void Visit(const YamlNode& node) {
    for (const YamlNode& item : node.items) Visit(item);
    for (const YamlNode::Pair& pair : node.pairs) {
      const bool is_spec = Has(kSpecKeys, pair.key);
      if (is_spec || Has(kFileKeys, pair.key)) {
        VisitReference(pair.value, is_spec);
        for (const YamlNode& item : pair.value.items) VisitReference(item, is_spec);
      }
      Visit(pair.value);
    }
  }

  std::string Take() {
    for (const auto& [at, change] : changes_) text_.replace(at, change.first, change.second);
    constexpr std::string_view kSchemaLine = "# yaml-language-server:";  // has a relative path
    if (text_.starts_with(kSchemaLine)) {
      text_.erase(0, text_.find('\n') + 1);
      if (text_.starts_with("#\n")) text_.erase(0, 2);
    }
    return std::move(text_);
  }

 private:
  // `key` is that of the node, or of the list that contains it.
  void RenameBelow(const YamlNode& node, std::string_view key, const std::string& old_name,
                   const std::string& new_name) {
    const bool is_other = Has(kSpecKeys, key) || Has(kFileKeys, key) || Has(kWordKeys, key);
    if (node.kind == YamlNode::Kind::kScalar && node.text == old_name && !is_other)
      Replace(node, new_name);
    for (const YamlNode& item : node.items) RenameBelow(item, key, old_name, new_name);
    for (const YamlNode::Pair& pair : node.pairs)
      RenameBelow(pair.value, pair.key, old_name, new_name);
  }

  void VisitReference(const YamlNode& node, bool is_spec) {
    if (node.kind != YamlNode::Kind::kScalar) return;
    const auto old_file = is_spec ? Locate(node.text, from_, search_path_) : InFolder(node.text);
    if (!old_file) return;
    const fs::path file = Canonical(*old_file);
    const auto new_file = is_spec ? Locate(node.text, to_, search_path_) : std::nullopt;
    if (new_file && Canonical(*new_file) == file) return;
    Replace(node, is_spec ? ReferenceTo(file) : file.lexically_relative(to_).generic_string());
  }

  std::optional<fs::path> InFolder(const std::string& name) const {
    std::error_code error;
    const fs::path file = from_ / name;
    return !name.empty() && fs::is_regular_file(file, error) ? std::optional(file) : std::nullopt;
  }

  // Returns the name of a file in the search path, or the path from the new folder.
  std::string ReferenceTo(const fs::path& file) const {
    for (const fs::path& shelf : search_path_) {
      fs::path name = file.lexically_relative(Canonical(shelf));
      if (name.empty() || *name.begin() == "..") continue;
      name.replace_extension();
      const auto found = Locate(name.generic_string(), to_, search_path_);
      if (found && Canonical(*found) == file) return name.generic_string();
    }
    return file.lexically_relative(to_).generic_string();
  }

  void Replace(const YamlNode& scalar, const std::string& text) {
    const std::size_t place = lines_[scalar.mark.line - 1] + scalar.mark.column - 1;
    const std::size_t at = text_.find(scalar.text, place);  // behind a quotation mark
    if (at != std::string::npos) changes_[at] = {scalar.text.size(), text};
  }

  std::string text_;
  fs::path from_;
  fs::path to_;
  const std::vector<fs::path>& search_path_;
  std::vector<std::size_t> lines_;  // beginnings
  /// Lengths of old texts, and new texts, by their places, the last first.
  std::map<std::size_t, std::pair<std::size_t, std::string>, std::greater<>> changes_;
};

std::optional<std::string> Copy(std::uint32_t source, const fs::path& from, const std::string& name,
                                const fs::path& to, const std::vector<fs::path>& search_path,
                                diag::Sources& sources, diag::Findings& findings) {
  const std::optional<YamlNode> root = ParseYaml(source, sources, findings);
  if (!root) return std::nullopt;
  TextCopier copier(sources, source, from, Canonical(to.empty() ? "." : to), search_path);
  if (const YamlNode* old_name = root->Find("name")) copier.Rename(*root, old_name->text, name);
  copier.Visit(*root);
  return copier.Take();
}

}  // namespace

std::optional<std::string> StarterText(const std::string& name, diag::Sources& sources,
                                       diag::Findings& findings) {
  const std::uint32_t source = sources.Add("starter.yaml", std::string(kStarterYaml));
  return Copy(source, {}, name, {}, {}, sources, findings);
}

std::optional<std::string> CopiedText(const std::string& reference, const std::string& name,
                                      const fs::path& folder, const LoadOptions& options,
                                      diag::Sources& sources, diag::Findings& findings) {
  Snapshot snapshot;  // keeps the text, because standard input cannot be read again
  LoadOptions load = options;
  load.snapshot = &snapshot;
  const auto spec = LoadSpec(reference, load, sources, findings);
  if (spec == nullptr) return std::nullopt;
  const fs::path file =
      reference == bytes::kStandardInput ? fs::path(reference) : spec->files.front();
  const auto source = ReadSource(file, reference, {}, &snapshot, sources, findings);
  if (!source) return std::nullopt;
  return Copy(*source, file.parent_path(), name, folder, options.search_path, sources, findings);
}

}  // namespace mjforge::spec
