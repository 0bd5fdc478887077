// Texts of new specs: copies of a spec that refer to the same files, and the starter spec.

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <string_view>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
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
constexpr std::string_view kSpecKeys = "import spec";
constexpr std::string_view kFileKeys = "file mjcf rows";

// Collects replacements for the file references in the text of a spec, and applies them.
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

  /// Collects replacements for the references to files in a node and its inner nodes.
  void Visit(const YamlNode& node) {
    for (const YamlNode& item : node.items) Visit(item);
    for (const YamlNode::Pair& pair : node.pairs) {
      const bool is_spec = expr::HasWord(kSpecKeys, pair.key);
      if (is_spec || expr::HasWord(kFileKeys, pair.key)) {
        VisitReference(pair.value, is_spec);
        for (const YamlNode& item : pair.value.items) VisitReference(item, is_spec);
      }
      Visit(pair.value);
    }
  }

  std::string Take() {
    for (const auto& [at, change] : changes_) text_.replace(at, change.first, change.second);
    // Start of the line that names the JSON Schema for editors. The line is removed, because it
    // contains a relative path.
    constexpr std::string_view kSchemaLine = "# yaml-language-server:";
    if (text_.starts_with(kSchemaLine)) {
      text_.erase(0, text_.find('\n') + 1);
      if (text_.starts_with("#\n")) text_.erase(0, 2);
    }
    return std::move(text_);
  }

 private:
  void VisitReference(const YamlNode& node, bool is_spec) {
    if (node.kind != YamlNode::Kind::kScalar) return;
    const auto old_file = is_spec ? Locate(node.text, from_, search_path_) : FileBeside(node.text);
    if (!old_file) return;
    const fs::path file = Canonical(*old_file);
    const auto new_file = is_spec ? Locate(node.text, to_, search_path_) : std::nullopt;
    if (new_file && Canonical(*new_file) == file) return;
    Replace(node, is_spec ? ReferenceTo(file) : file.lexically_relative(to_).generic_string());
  }

  std::optional<fs::path> FileBeside(const std::string& name) const {
    std::error_code error;
    const fs::path file = from_ / name;
    return !name.empty() && fs::is_regular_file(file, error) ? std::optional(file) : std::nullopt;
  }

  // Returns the reference to a spec for the copy: the name in the search path if `file` has one,
  // otherwise the path relative to the new folder.
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

  // Records the replacement of a quoted or plain scalar. Leaves scalars in other YAML styles
  // unchanged.
  void Replace(const YamlNode& scalar, const std::string& text) {
    std::size_t at = lines_[scalar.mark.line - 1] + scalar.mark.column - 1;
    while (at < text_.size() && (text_[at] == '&' || text_[at] == '!'))  // skips anchors and tags
      at = text_.find_first_not_of(' ', text_.find(' ', at));
    if (at >= text_.size()) return;
    const std::size_t size = text_[at] == '\'' || text_[at] == '"' ? QuotedSize(at)
                             : text_.compare(at, scalar.text.size(), scalar.text) == 0
                                 ? scalar.text.size()
                                 : 0;
    if (size > 0) changes_[at] = {size, Written(text)};
  }

  // Returns the size in bytes of the quoted scalar that begins at `begin`, with its quotes; 0 if
  // the closing quote is missing.
  std::size_t QuotedSize(std::size_t begin) const {
    const char quote = text_[begin];
    for (std::size_t at = begin + 1; at < text_.size(); ++at) {
      if (quote == '"' && text_[at] == '\\') {
        ++at;
      } else if (text_[at] == quote) {
        if (quote == '"' || at + 1 == text_.size() || text_[at + 1] != quote) return at + 1 - begin;
        ++at;
      }
    }
    return 0;
  }

  // Returns the text as a YAML scalar, with quotes if necessary.
  static std::string Written(const std::string& text) {
    const auto is_plain = [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '.' || c == '/' || c == '-';
    };
    return std::ranges::all_of(text, is_plain) ? text : SingleQuoted(text);
  }

  std::string text_;
  fs::path from_;
  fs::path to_;
  const std::vector<fs::path>& search_path_;
  std::vector<std::size_t> lines_;  // byte offset of each line
  /// Replacements by byte offset: the length of the old text, and the new text. The map begins with
  /// the last offset, because a replacement does not move the text before it.
  std::map<std::size_t, std::pair<std::size_t, std::string>, std::greater<>> changes_;
};

}  // namespace

std::string StarterText() { return std::string(kStarterYaml); }

std::optional<std::string> CopiedText(const std::string& reference, const fs::path& folder,
                                      const LoadOptions& options, diag::Sources& sources,
                                      diag::Findings& findings) {
  Snapshot snapshot;  // keeps the text, because standard input cannot be read again
  LoadOptions load = options;
  load.snapshot = &snapshot;
  const auto spec = LoadSpec(reference, load, sources, findings);
  if (spec == nullptr) return std::nullopt;
  const fs::path file =
      reference == bytes::kStandardInput ? fs::path(reference) : spec->files.front();
  const auto source = ReadSource(file, reference, {}, &snapshot, sources, findings);
  if (!source) return std::nullopt;
  const std::optional<YamlNode> root = ParseYaml(*source, sources, findings);
  if (!root) return std::nullopt;
  TextCopier copier(sources, *source, file.parent_path(), Canonical(folder.empty() ? "." : folder),
                    options.search_path);
  copier.Visit(*root);
  return copier.Take();
}

}  // namespace mjforge::spec
