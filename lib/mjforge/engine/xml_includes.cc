#include <algorithm>
#include <cstdint>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "mjforge/bytes/bytes.h"
#include "mjforge/engine/xml_file.h"
#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {
namespace {

namespace fs = std::filesystem;
using diag::Code;

/// Elements nested deeper than this are refused; MuJoCo 2.2's XML reader stops at 100.
constexpr int kMostDepth = 1000;

/// Where the lines of a text start, for marks.
class Lines {
 public:
  Lines(std::uint32_t source, std::string_view text) : source_(source) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') starts_.push_back(i + 1);
    }
  }

  /// Of an element: its '<'. pugixml's offset is that of the name.
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

/// Puts what `<include>` names in its place, as MuJoCo 2.2 does: every file once,
/// relative to the folder of the first.
class TreeReader {
 public:
  TreeReader(const fs::path& main, diag::Sources& sources, diag::Findings& findings)
      : main_(main), sources_(sources), findings_(findings) {}

  std::optional<XmlElement> Read() {
    std::string why_not;
    std::optional<std::string> text = bytes::Read(main_, bytes::kMaxMjcf, why_not);
    if (!text) {
      AddError(findings_, engine::CodeOfUnread(main_), {},
               fmt::format("cannot read '{}': {}", main_.string(), why_not));
      return std::nullopt;
    }
    const std::uint32_t source = sources_.Add(ShownName(main_), *std::move(text));
    if (const auto fault = engine::WhyNotMjcf(sources_.Text(source))) {
      AddError(findings_, Code::kMujocoNotMjcf, engine::MarkAt(sources_, source, fault->offset),
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
    if (depth > kMostDepth) {
      AddError(findings_, Code::kMujocoNotMjcf, out.mark,
               fmt::format("'{}' nests elements more than {} deep", main_.string(), kMostDepth));
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
      if (diag::LowerCase(child.name()) == "include") {  // MuJoCo does not mind the case
        good = Include(child, lines.MarkOf(child), depth, out) && good;
      } else {
        good = Convert(child, lines, depth + 1, out.children.emplace_back()) && good;
      }
    }
    return good;
  }

  /// `note` is a further place.
  bool Bad(diag::SourceMark place, const std::string& what, std::string hint = {},
           const diag::Note& note = {}) {
    diag::Finding& finding =
        AddError(findings_, Code::kAttachBadInclude, place,
                 fmt::format("'{}' {}", open_.back().string(), what), std::move(hint));
    if (note.mark) finding.notes.push_back(note);
    return false;
  }

  bool Include(const pugi::xml_node& node, diag::SourceMark place, int depth, XmlElement& parent) {
    const std::string name = node.attribute("file").value();
    if (name.empty()) return Bad(place, "has an include without a file");
    if (!node.first_child().empty()) {
      return Bad(place, fmt::format("has an include of '{}' that contains elements", name));
    }
    const fs::path file = main_.parent_path() / name;
    if (!IsNew(file, name, place)) return false;
    std::string why_not;
    std::optional<std::string> text = bytes::Read(file, bytes::kMaxMjcf, why_not);
    if (!text && engine::CodeOfUnread(file) == Code::kYamlCannotRead) {
      AddError(findings_, Code::kYamlCannotRead, place,
               fmt::format("cannot read '{}': {}", file.string(), why_not));
      return false;
    }
    if (!text) {
      return Bad(place, fmt::format("includes '{}', which cannot be read: {}", name, why_not),
                 open_.size() > 1
                     ? fmt::format("files are searched for in the folder of '{}'", main_.string())
                     : "");
    }
    read_[CanonicalName(file)] = place;
    const std::uint32_t source = sources_.Add(file.string(), *std::move(text));
    if (const auto fault = engine::WhyNotXml(sources_.Text(source))) {
      return Bad(place, fmt::format("includes '{}', which is {}", name, fault->message), {},
                 {engine::MarkAt(sources_, source, fault->offset), "broken here"});
    }
    pugi::xml_document document;
    Parse(source, document);
    if (document.document_element().first_child().empty()) {
      return Bad(place, fmt::format("includes '{}', which contains no elements", name));
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
      return Bad(place, fmt::format("includes '{}', which is already open: a cycle", name));
    }
    const auto found = read_.find(key);
    if (found == read_.end()) return true;
    return Bad(place, fmt::format("includes '{}' a second time", name),
               "MuJoCo includes each file only once; give the copy another name",
               {found->second, "first here"});
  }

  fs::path main_;
  diag::Sources& sources_;
  diag::Findings& findings_;
  std::vector<fs::path> open_;
  std::map<std::string, diag::SourceMark> read_;  // and where it was included
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

}  // namespace mjforge::engine
