// Watch for changes of files, by polling.
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

  /// Waits until a file is changed, made or removed (since the constructor, or since HasChanged()
  /// last returned true), and then until no file changes for a moment, because an editor may write
  /// a file in several steps.
  void Wait();

  /// Watches another file from now on, unless it is watched already.
  void Add(const std::filesystem::path& file);

  /// Returns true if a file was changed, made or removed since the constructor ran or this function
  /// last returned true, and no file has changed since the last call. Must be called at intervals.
  bool HasChanged();

 private:
  // State of a file: device, inode, size and time of change; zeros if the file does not exist.
  using Stamp = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::time_t, long>;
  using Stamps = std::map<std::filesystem::path, Stamp>;

  static Stamp StampOf(const std::filesystem::path& file);
  Stamps Now() const;

  Stamps stamps_;
  Stamps last_;  // result of Now() at the last call of HasChanged
};

}  // namespace mjforge::app
