// Checks, by parsing with pugixml, that a text is well-formed XML and MJCF.
#include "mjforge/xml/well_formed.h"

#include <algorithm>
#include <new>
#include <system_error>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "mjforge/bytes/bytes.h"

namespace mjforge::xml {
namespace {

using diag::Code;

std::optional<XmlFault> FaultOf(const pugi::xml_parse_result& result) {
  if (result) return std::nullopt;
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  std::string reason = result.description();
  if (!reason.empty()) reason.replace(0, 1, diag::LowerCase(reason.substr(0, 1)));
  // A text without elements has its fault at the start.
  const bool empty = result.status == pugi::status_no_document_element;
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
  return XmlFault{empty ? 0 : offset, fmt::format("not an XML file: {}", reason), {}};
}

}  // namespace

std::optional<XmlFault> FindXmlFault(std::string_view text) {
  pugi::xml_document document;
  return FaultOf(document.load_buffer(text.data(), text.size()));
}

std::optional<XmlFault> FindMjcfFault(std::string_view text, bool* has_includes) {
  pugi::xml_document document;
  auto fault = FaultOf(document.load_buffer(text.data(), text.size()));
  if (fault) return fault;
  if (has_includes != nullptr) {
    const auto is_include = [](const pugi::xml_node& node) { return IsIncludeTag(node.name()); };
    *has_includes = !document.find_node(is_include).empty();
  }
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

bool IsIncludeTag(std::string_view tag) { return diag::LowerCase(tag) == "include"; }

diag::Code UnreadableCode(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error) || error ? Code::kYamlCannotRead
                                                       : Code::kModelFileNotFound;
}

std::string ShownName(const std::filesystem::path& file) {
  return file == bytes::kStandardInput ? "<stdin>" : file.string();
}

}  // namespace mjforge::xml
