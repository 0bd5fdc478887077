#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "harness/source_folder.h"

namespace mjforge::docs {

/// The project's folder.
inline const std::filesystem::path kRoot = harness::SourceFolder();

/// A file or a command on a page, in the page's order.
struct Step {
  enum class Kind { kFile, kCommand } kind = Kind::kFile;
  int line = 0;         // on the page, from 1
  std::string name;     // the file's name or the command line
  std::string text;     // the file's whole text or the command's output
  std::string chapter;  // heading of the second level that it is below: "yaml/empty"
};

/// A block that begins with "```LANGUAGE NAME" is a file, and so is a ```yaml block whose first
/// line is `# file: NAME`. In ```console blocks each `$ LINE` is a command, with its output below.
std::vector<Step> ReadSteps(const std::filesystem::path& page);

/// Puts other outputs below the commands at these lines, and leaves the rest.
void ReplaceOutputs(const std::filesystem::path& page, const std::map<int, std::string>& outputs);

/// Targets of the page's links and pictures, `[text](target)`, `<a href="target"`, `<img
/// src="target"`.
std::vector<std::string> ReadLinks(const std::filesystem::path& page);

/// Headings as the anchors that links name: "Exit status" is "exit-status".
std::vector<std::string> ReadAnchors(const std::filesystem::path& page);

/// Whether the output is the expected one, where a line `...` stands for any lines.
bool Fits(const std::string& output, const std::string& expected);

}  // namespace mjforge::docs
