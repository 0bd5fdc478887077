// Checks that a text is well-formed XML, and that its root element is that of MJCF; names and codes
// of files for messages.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::xml {

/// The reason why a text is not XML or not MJCF, and the offset of the faulty place, bytes.
struct XmlFault {
  std::size_t offset = 0;
  std::string message;
  std::string hint;
};
std::optional<XmlFault> FindXmlFault(std::string_view text);
/// Returns the fault of a text that is not XML or whose root element is not <mujoco>; nullopt for
/// MJCF. If the text is XML and `has_includes` is not null, sets `*has_includes`: to true if the
/// text contains an include element, otherwise to false.
std::optional<XmlFault> FindMjcfFault(std::string_view text, bool* has_includes = nullptr);

/// Returns true for the tag of MJCF's include element. MuJoCo ignores the case of this tag, unlike
/// that of all other tags.
bool IsIncludeTag(std::string_view tag);

/// Returns the code of the finding for a file that cannot be read: model/file-not-found if the file
/// does not exist, otherwise yaml/cannot-read.
diag::Code UnreadableCode(const std::filesystem::path& file);

/// Returns the name of a file as messages show it; "<stdin>" for standard input.
std::string ShownName(const std::filesystem::path& file);

}  // namespace mjforge::xml
