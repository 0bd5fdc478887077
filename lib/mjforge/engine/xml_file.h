#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::engine {

/// Of a file that could not be read: model/file-not-found if it does not exist, else
/// yaml/cannot-read.
diag::Code CodeOfUnread(const std::filesystem::path& file);

/// A file that is XML with a root element <mujoco>.
struct XmlFile {
  std::uint32_t source = 0;  // its number in Sources
  bool has_includes = false;
  /// What this MuJoCo reads, with includes in their places, if it was written for a later one.
  std::optional<std::string> adapted;
};

/// What is wrong with a text, and at which byte.
struct XmlFault {
  std::size_t offset = 0;
  std::string message;
  std::string hint;
};
std::optional<XmlFault> WhyNotXml(std::string_view text);
/// The same for a text whose root element must be <mujoco>.
std::optional<XmlFault> WhyNotMjcf(std::string_view text, bool* has_includes = nullptr);

/// Reads a file or standard input into `sources`; nothing and a finding if it is not MJCF, or needs
/// a later MuJoCo. A warning for each kind of thing in it that this MuJoCo leaves out.
std::optional<XmlFile> ReadXmlFile(const std::filesystem::path& file, diag::Sources& sources,
                                   diag::Findings& findings);

/// What this MuJoCo reads in place of a file that was written for a later one, with absolute names
/// of files, so that it can stand in any folder. Nothing if it reads the file as it is, or not at
/// all.
std::optional<std::string> AdaptedText(const std::filesystem::path& file);

/// The name of a file in messages.
std::string ShownName(const std::filesystem::path& file);

/// A text as the value of an attribute, which stands between double quotes.
std::string EscapeXml(std::string_view text);

/// The place of a byte of a source.
diag::SourceMark MarkAt(const diag::Sources& sources, std::uint32_t source, std::size_t offset);

/// The first text on a line of a source, for marks.
diag::SourceMark MarkOfLine(const diag::Sources& sources, std::uint32_t source, int line);

}  // namespace mjforge::engine
