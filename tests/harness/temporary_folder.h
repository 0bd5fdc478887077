#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::harness {

/// A fresh, empty folder, removed with all that is in it, even what a test made
/// read-only.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  /// Writes a file, making the folders it needs; returns its path.
  std::filesystem::path Write(std::string_view name, std::string_view text) const;
  /// The whole text of a file; fails the test if there is none.
  std::string Read(std::string_view name) const;
  /// Every file in it and its subfolders, sorted: {"out/a.xml", "out/manifest.jsonl"}.
  std::vector<std::string> Files() const;

 private:
  std::filesystem::path path_;
};

/// The whole text of a file; fails the test if there is none.
std::string ReadFile(const std::filesystem::path& path);

}  // namespace mjforge::harness
