// Recursive reader of an MJCF file, which replaces each include by the contents of the included
// file.
#include "mjforge/xml/tree_reader.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "mjforge/bytes/bytes.h"
#include "mjforge/xml/places.h"
#include "mjforge/xml/well_formed.h"

namespace mjforge::xml {
namespace {

namespace fs = std::filesystem;
using diag::Code;

/// Maximum nesting of elements. Deeper elements might exhaust the stack of recursive functions.
/// (The XML reader of MuJoCo 2.2 stops at 100.)
constexpr int kMaxDepth = 1000;

/// Finds the places of elements in a text by the offsets of its lines.
class Lines {
 public:
  Lines(std::uint32_t source, std::string_view text) : source_(source) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') starts_.push_back(i + 1);
    }
  }

  /// Returns the place of an element's '<', which is one byte before the offset of the tag's name
  /// that pugixml returns.
  diag::SourceMark MarkOf(const pugi::xml_node& node) const {
    const auto offset =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug() - 1, 0));
    const auto next = std::ranges::upper_bound(starts_, offset);
    return {source_, static_cast<std::uint32_t>(next - starts_.begin()),
            static_cast<std::uint32_t>(offset - *(next - 1) + 1)};
  }

 private:
  std::uint32_t source_;
  std::vector<std::size_t> starts_ = {0};
};

/// Reads a tree of elements. Replaces each <include> by the contents of the included file by the
/// rules of MuJoCo 2.2: a file may be included only once, and its name is relative to the folder of
/// the main file.
class TreeReader {
 public:
  TreeReader(const fs::path& main, diag::Sources& sources, diag::Findings& findings)
      : main_(main), sources_(sources), findings_(findings) {}

  std::optional<XmlElement> Read() {
    std::string why_not;
    std::optional<std::string> text = bytes::Read(main_, bytes::kMaxMjcf, why_not);
    if (!text) {
      AddError(findings_, UnreadableCode(main_), {},
               fmt::format("cannot read '{}': {}", main_.string(), why_not))
          .files = {main_.string()};
      return std::nullopt;
    }
    const std::uint32_t source = sources_.Add(ShownName(main_), *std::move(text));
    if (const auto fault = FindMjcfFault(sources_.Text(source))) {
      AddError(findings_, Code::kMujocoNotMjcf, MarkAt(sources_, source, fault->offset),
               fmt::format("'{}' cannot be attached: {}", main_.string(), fault->message),
               fault->hint);
      return std::nullopt;
    }
    pugi::xml_document document;
    Parse(source, document);
    open_.push_back(main_);
    read_[CanonicalName(main_)] = {};
    XmlElement root;
    if (!Convert(document.document_element(), Lines(source, sources_.Text(source)), 1, root)) {
      return std::nullopt;
    }
    return root;
  }

 private:
  void Parse(std::uint32_t source, pugi::xml_document& document) const {
    const std::string& text = sources_.Text(source);
    document.load_buffer(text.data(), text.size());
  }

  bool Convert(const pugi::xml_node& node, const Lines& lines, int depth, XmlElement& out) {
    out.tag = node.name();
    out.mark = lines.MarkOf(node);
    if (depth > kMaxDepth) {
      AddError(findings_, Code::kMujocoNotMjcf, out.mark,
               fmt::format("'{}' nests elements more than {} deep", main_.string(), kMaxDepth));
      return false;
    }
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      out.attributes.emplace_back(attribute.name(), attribute.value());
    }
    return ConvertChildren(node, lines, depth, out);
  }

  bool ConvertChildren(const pugi::xml_node& node, const Lines& lines, int depth, XmlElement& out) {
    bool good = true;
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      if (IsIncludeTag(child.name())) {
        good = Include(child, lines.MarkOf(child), depth, out) && good;
      } else {
        good = Convert(child, lines, depth + 1, out.children.emplace_back()) && good;
      }
    }
    return good;
  }

  /// Reports an invalid include, and returns false. `note` is an additional note, if it has a mark.
  bool ReportInclude(diag::SourceMark place, const std::string& what, std::string hint = {},
                     const diag::Note& note = {}) {
    diag::Finding& finding =
        AddError(findings_, Code::kAttachBadInclude, place,
                 fmt::format("'{}' {}", open_.back().string(), what), std::move(hint));
    if (note.mark) finding.notes.push_back(note);
    return false;
  }

  bool Include(const pugi::xml_node& node, diag::SourceMark place, int depth, XmlElement& parent) {
    const std::string name = node.attribute("file").value();
    if (name.empty()) return ReportInclude(place, "has an include without a file");
    if (!node.first_child().empty()) {
      return ReportInclude(place,
                           fmt::format("has an include of '{}' that contains elements", name));
    }
    const fs::path file = main_.parent_path() / name;
    if (!IsNew(file, name, place)) return false;
    std::string why_not;
    std::optional<std::string> text = bytes::Read(file, bytes::kMaxMjcf, why_not);
    if (!text && UnreadableCode(file) == Code::kYamlCannotRead) {
      AddError(findings_, Code::kYamlCannotRead, place,
               fmt::format("cannot read '{}': {}", file.string(), why_not));
      return false;
    }
    if (!text) {
      return ReportInclude(
          place, fmt::format("includes '{}', which cannot be read: {}", name, why_not),
          open_.size() > 1
              ? fmt::format("files are searched for in the folder of '{}'", main_.string())
              : "");
    }
    read_[CanonicalName(file)] = place;
    const std::uint32_t source = sources_.Add(file.string(), *std::move(text));
    if (const auto fault = FindXmlFault(sources_.Text(source))) {
      return ReportInclude(place, fmt::format("includes '{}', which is {}", name, fault->message),
                           {}, {MarkAt(sources_, source, fault->offset), "broken here"});
    }
    pugi::xml_document document;
    Parse(source, document);
    if (document.document_element().first_child().empty()) {
      return ReportInclude(place, fmt::format("includes '{}', which contains no elements", name));
    }
    open_.push_back(file);
    const Lines lines(source, sources_.Text(source));
    const bool good = ConvertChildren(document.document_element(), lines, depth, parent);
    open_.pop_back();
    return good;
  }

  bool IsNew(const fs::path& file, const std::string& name, diag::SourceMark place) {
    const std::string key = CanonicalName(file);
    for (const fs::path& open : open_) {
      if (CanonicalName(open) != key) continue;
      return ReportInclude(place,
                           fmt::format("includes '{}', which is already open: a cycle", name));
    }
    const auto found = read_.find(key);
    if (found == read_.end()) return true;
    return ReportInclude(place, fmt::format("includes '{}' a second time", name),
                         "MuJoCo includes each file only once; give the copy another name",
                         {found->second, "first here"});
  }

  fs::path main_;
  diag::Sources& sources_;
  diag::Findings& findings_;
  std::vector<fs::path> open_;
  // Place of the include of each file that was read, by the file's canonical name; an empty mark
  // for the main file.
  std::map<std::string, diag::SourceMark> read_;
};

}  // namespace

std::string CanonicalName(const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(file, error);
  return error ? file.string() : whole.string();
}

std::optional<XmlElement> ReadXml(const std::filesystem::path& file, diag::Sources& sources,
                                  diag::Findings& findings) {
  return TreeReader(file, sources, findings).Read();
}

}  // namespace mjforge::xml
