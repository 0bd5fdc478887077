#include "mjforge/engine/xml_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "mjforge/bytes/bytes.h"
#include "mjforge/engine/adapt.h"
#include "mjforge/engine/engine.h"
#include "mjforge/engine/weigh_meshes.h"

namespace mjforge::engine {
namespace {

using diag::Code;

std::optional<XmlFault> FaultOf(const pugi::xml_parse_result& result) {
  if (result) return std::nullopt;
  std::string reason = result.description();
  if (!reason.empty()) reason.replace(0, 1, diag::LowerCase(reason.substr(0, 1)));
  // A text without any element is wrong from its start on.
  const bool empty = result.status == pugi::status_no_document_element;
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
  return XmlFault{empty ? 0 : offset, fmt::format("not an XML file: {}", reason), {}};
}

std::filesystem::path FolderOf(const std::filesystem::path& file) {
  return file == bytes::kStandardInput ? std::filesystem::path(".") : file.parent_path();
}

/// What this MuJoCo reads in place of the file, if that is something else.
std::optional<XmlElement> AdaptFile(const std::filesystem::path& file, diag::Sources& sources,
                                    diag::Findings& findings) {
  diag::Findings of_includes;  // MuJoCo says them, too
  std::optional<XmlElement> root = ReadXml(file, sources, of_includes);
  if (!root) return std::nullopt;
  if (!AdaptMjcf(*root, mjVERSION_HEADER, Use::kWholeModel, sources, findings)) return std::nullopt;
  if (findings.HasErrors()) return std::nullopt;
  const std::filesystem::path folder = FolderOf(file);
  Engine engine;
  WeighMeshes(*root, [&](const std::string& text) { return engine.LoadTextIn(folder, text); });
  return root;
}

}  // namespace

std::optional<XmlFault> WhyNotXml(std::string_view text) {
  pugi::xml_document document;
  return FaultOf(document.load_buffer(text.data(), text.size()));
}

std::optional<XmlFault> WhyNotMjcf(std::string_view text, bool* has_includes) {
  pugi::xml_document document;
  auto fault = FaultOf(document.load_buffer(text.data(), text.size()));
  if (fault) return fault;
  if (has_includes != nullptr) *has_includes = !document.select_node("//include").node().empty();
  const pugi::xml_node root = document.document_element();
  const std::string_view name = root.name();
  if (name == "mujoco") return std::nullopt;
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(root.offset_debug(), 0));
  if (name == "robot") {
    return XmlFault{offset, "the root element is <robot>, not <mujoco>: this is a URDF file",
                    "convert it to MJCF first: load it in MuJoCo and save it with mj_saveLastXML"};
  }
  return XmlFault{offset, fmt::format("the root element is <{}>, not <mujoco>", name),
                  "an MJCF file has the root element <mujoco>"};
}

diag::Code CodeOfUnread(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error) || error ? Code::kYamlCannotRead
                                                       : Code::kModelFileNotFound;
}

std::optional<XmlFile> ReadXmlFile(const std::filesystem::path& file, diag::Sources& sources,
                                   diag::Findings& findings) {
  const std::string name = ShownName(file);
  std::string why_not;
  std::optional<std::string> text = bytes::Read(file, bytes::kMaxMjcf, why_not);
  if (!text) {
    findings.Add(Code::kYamlCannotRead, {}, fmt::format("cannot read '{}': {}", name, why_not));
    return std::nullopt;
  }
  if (const std::string_view kind = bytes::KindOf(*text); !kind.empty()) {
    findings.Add(Code::kMujocoNotMjcf, {}, fmt::format("'{}' is {}, not MJCF", name, kind));
    return std::nullopt;
  }
  const std::uint32_t source = sources.Add(name, *std::move(text));
  bool has_includes = false;
  const std::optional<XmlFault> fault = WhyNotMjcf(sources.Text(source), &has_includes);
  if (fault) {
    findings.Add(Code::kMujocoNotMjcf, MarkAt(sources, source, fault->offset), fault->message,
                 fault->hint);
    return std::nullopt;
  }
  diag::Findings found;
  XmlFile xml{source, has_includes, {}};
  if (const auto root = AdaptFile(file, sources, found)) xml.adapted = FlattenInPlace(*root);
  const bool good = !found.HasErrors();
  findings.Append(std::move(found));
  if (!good) return std::nullopt;
  return xml;
}

std::optional<std::string> AdaptedText(const std::filesystem::path& file) {
  diag::Sources sources;
  diag::Findings findings;
  std::optional<XmlElement> root = AdaptFile(file, sources, findings);
  if (!root) return std::nullopt;
  ResolveFiles(*root, FolderOf(file), findings);
  return Flatten(*root).text;
}

std::string ShownName(const std::filesystem::path& file) {
  return file == bytes::kStandardInput ? "<stdin>" : file.string();
}

std::string EscapeXml(std::string_view text) {
  std::string escaped;
  for (const char& c : text) {
    escaped += c == '&'   ? "&amp;"
               : c == '<' ? "&lt;"
               : c == '"' ? "&quot;"
                          : std::string_view(&c, 1);
  }
  return escaped;
}

diag::SourceMark MarkAt(const diag::Sources& sources, std::uint32_t source, std::size_t offset) {
  const std::string_view text = sources.Text(source);
  const std::string_view before = text.substr(0, std::min(text.size(), offset));
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {source, static_cast<std::uint32_t>(1 + std::ranges::count(before, '\n')),
          static_cast<std::uint32_t>(1 + before.size() - line_start)};
}

diag::SourceMark MarkOfLine(const diag::Sources& sources, std::uint32_t source, int line) {
  diag::SourceMark mark{source, static_cast<std::uint32_t>(std::max(line, 1)), 1};
  const std::size_t start = sources.Line(mark).find_first_not_of(" \t");
  if (start != std::string_view::npos) mark.column = static_cast<std::uint32_t>(start + 1);
  return mark;
}

}  // namespace mjforge::engine
