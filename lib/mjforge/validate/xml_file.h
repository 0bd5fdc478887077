#ifndef MJFORGE_VALIDATE_XML_FILE_H_
#define MJFORGE_VALIDATE_XML_FILE_H_

#include <cstdint>
#include <filesystem>
#include <optional>

#include "mjforge/diag/diag.h"

namespace mjforge::validate {

/// A file that is XML with a root element <mujoco>.
struct XmlFile {
  std::uint32_t source = 0;  // its number in Sources
  bool has_includes = false;
};

/// Reads the file into `sources`; nothing and a finding if it is not MJCF.
std::optional<XmlFile> ReadXmlFile(const std::filesystem::path& file, diag::Sources& sources,
                                   diag::Findings& findings);

/// The first text on a line of a source, for marks.
diag::SourceMark MarkOfLine(const diag::Sources& sources, std::uint32_t source, int line);

}  // namespace mjforge::validate

#endif  // MJFORGE_VALIDATE_XML_FILE_H_
