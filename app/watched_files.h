// Files that are watched for changes, as editors make them.
#pragma once

#include <ctime>
#include <filesystem>
#include <map>
#include <tuple>
#include <vector>

namespace mjforge::app {

/// Watches files, which need not exist, by polling: editors replace files in several ways, and some
/// file systems report no changes.
class WatchedFiles {
 public:
  explicit WatchedFiles(const std::vector<std::filesystem::path>& files = {});

  /// Waits until a file was changed, made or removed since the constructor ran, and then all stay
  /// the same for a moment, because an editor may write a file in several steps.
  void Wait();

  /// Watches another file from now on, unless it is watched already.
  void Add(const std::filesystem::path& file);

  /// Returns true if a file was changed, made or removed since the constructor ran or this function
  /// last returned true, and all are as they were at the last call. For calls at intervals.
  bool HasChanged();

 private:
  // Device, inode, size and time of change; zeros if there is no file.
  using Stamp = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::time_t, long>;
  using Stamps = std::map<std::filesystem::path, Stamp>;

  static Stamp StampOf(const std::filesystem::path& file);
  Stamps Now() const;

  Stamps stamps_;
  Stamps last_;  // at the last call of HasChanged
};

}  // namespace mjforge::app
