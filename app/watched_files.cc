// Polling of files: compares device, inode, size and time of modification with earlier values.
#include "watched_files.h"

#include <sys/stat.h>

#include <chrono>
#include <thread>
#include <utility>

namespace mjforge::app {

namespace {

constexpr std::chrono::milliseconds kPollInterval(50);

}  // namespace

WatchedFiles::WatchedFiles(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) Add(file);
}

void WatchedFiles::Add(const std::filesystem::path& file) {
  if (!stamps_.contains(file)) stamps_[file] = StampOf(file);
}

WatchedFiles::Stamp WatchedFiles::StampOf(const std::filesystem::path& file) {
  struct stat found = {};
  if (::stat(file.c_str(), &found) != 0) found = {};
  return {found.st_dev, found.st_ino, static_cast<std::uint64_t>(found.st_size),
          found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

WatchedFiles::Stamps WatchedFiles::Now() const {
  Stamps now;
  for (const auto& [file, old] : stamps_) now[file] = StampOf(file);
  return now;
}

bool WatchedFiles::HasChanged() {
  Stamps now = Now();
  const bool is_steady = now == std::exchange(last_, now);
  if (now == stamps_ || !is_steady) return false;
  stamps_ = std::move(now);
  return true;
}

void WatchedFiles::Wait() {
  do std::this_thread::sleep_for(kPollInterval);
  while (!HasChanged());
}

}  // namespace mjforge::app
