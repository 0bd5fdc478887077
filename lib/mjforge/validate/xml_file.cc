#include "mjforge/validate/xml_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace mjforge::validate {
namespace {

using diag::Code;

diag::SourceMark MarkAt(const diag::Sources& sources, std::uint32_t source, std::ptrdiff_t offset) {
  const std::string_view text = sources.Text(source);
  const std::string_view before = text.substr(
      0, std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0))));
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {source, static_cast<std::uint32_t>(1 + std::ranges::count(before, '\n')),
          static_cast<std::uint32_t>(1 + before.size() - line_start)};
}

std::optional<std::string> ReadText(const std::filesystem::path& file, diag::Findings& findings) {
  std::error_code error;
  std::optional<std::string> text;
  if (std::filesystem::is_directory(file, error)) {
    findings.Add(Code::kYamlCannotRead, {},
                 fmt::format("cannot read '{}': it is a folder", file.string()));
    return text;
  }
  std::ifstream stream(file, std::ios::binary);
  if (stream)
    text.emplace(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  if (!stream || stream.bad()) {
    const bool exists = std::filesystem::exists(file, error);
    findings.Add(
        Code::kYamlCannotRead, {},
        fmt::format("cannot read '{}': {}", file.string(),
                    exists ? "permission denied or a read error" : "No such file or directory"));
    return std::nullopt;
  }
  return text;
}

bool CheckRoot(const pugi::xml_document& document, std::uint32_t source,
               const diag::Sources& sources, diag::Findings& findings) {
  const pugi::xml_node root = document.document_element();
  const std::string_view name = root.name();
  if (name == "mujoco") return true;
  const diag::SourceMark mark = MarkAt(sources, source, root.offset_debug());
  if (name == "robot") {
    findings.Add(Code::kMujocoNotMjcf, mark,
                 "the root element is <robot>, not <mujoco>: this is a URDF file",
                 "convert it to MJCF first: load it in MuJoCo and save it with mj_saveLastXML");
  } else {
    findings.Add(Code::kMujocoNotMjcf, mark,
                 fmt::format("the root element is <{}>, not <mujoco>", name),
                 "an MJCF file has the root element <mujoco>");
  }
  return false;
}

}  // namespace

std::optional<XmlFile> ReadXmlFile(const std::filesystem::path& file, diag::Sources& sources,
                                   diag::Findings& findings) {
  std::optional<std::string> text = ReadText(file, findings);
  if (!text) return std::nullopt;
  const std::uint32_t source = sources.Add(file.string(), *std::move(text));
  const std::string& stored = sources.Text(source);
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(stored.data(), stored.size());
  if (!result) {
    std::string reason = result.description();
    if (!reason.empty() && reason[0] >= 'A' && reason[0] <= 'Z') {
      reason[0] = static_cast<char>(reason[0] - 'A' + 'a');
    }
    // A text without any element is wrong from its start on.
    const std::ptrdiff_t offset =
        result.status == pugi::status_no_document_element ? 0 : result.offset;
    findings.Add(Code::kMujocoNotMjcf, MarkAt(sources, source, offset),
                 fmt::format("not an XML file: {}", reason));
    return std::nullopt;
  }
  if (!CheckRoot(document, source, sources, findings)) return std::nullopt;
  const bool has_includes = !document.select_node("//include").node().empty();
  return XmlFile{source, has_includes};
}

diag::SourceMark MarkOfLine(const diag::Sources& sources, std::uint32_t source, int line) {
  diag::SourceMark mark{source, static_cast<std::uint32_t>(std::max(line, 1)), 1};
  const std::size_t start = sources.Line(mark).find_first_not_of(" \t");
  if (start != std::string_view::npos) mark.column = static_cast<std::uint32_t>(start + 1);
  return mark;
}

}  // namespace mjforge::validate
