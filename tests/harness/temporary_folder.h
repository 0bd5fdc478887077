// Temporary folders for tests.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::harness {

/// A new folder that is removed with its content, including read-only files.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  /// Writes a file and creates its folders. Returns the file's path.
  std::filesystem::path Write(std::string_view name, std::string_view text) const;
  /// Returns the content of a file. Fails the test if the file does not exist.
  std::string Read(std::string_view name) const;
  /// Returns all files of the folder and its subfolders, sorted: {"out/a.xml",
  /// "out/manifest.jsonl"}.
  std::vector<std::string> Files() const;

 private:
  std::filesystem::path path_;
};

/// Returns the content of a file. Fails the test if the file does not exist.
std::string ReadFile(const std::filesystem::path& path);

}  // namespace mjforge::harness
