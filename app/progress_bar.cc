// Progress bar of a batch: share of finished variants, rate, time left, failures.
#include "progress_bar.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <string>

#include "console.h"

namespace mjforge::app {
namespace {

constexpr std::size_t kBarWidth = 20;
constexpr std::size_t kDefaultWidth = 80;
constexpr std::chrono::milliseconds kDelay{500};  // shorter batches have no bar
constexpr std::string_view kClearLine = "\r\x1b[K";

std::size_t TerminalWidth() {
  struct winsize size = {};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kDefaultWidth;
  return size.ws_col;
}

// Returns a time as "1:02:03" or "0:07".
std::string TimeText(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::ceil(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

// Returns "[#####.....]  50 %  500 of 1000  250/s  0:02 left  3 failed", cut to `width` columns.
// `seconds` is the time since the start of this run.
std::string ProgressLine(const batch::Summary& summary, double seconds, std::size_t width) {
  const auto done = static_cast<double>(summary.done());
  const double share = summary.count == 0 ? 1 : done / static_cast<double>(summary.count);
  const auto filled = static_cast<std::size_t>(share * kBarWidth);
  const double made = done - static_cast<double>(summary.resumed);
  const double rate = seconds > 0 ? made / seconds : 0;
  std::string line =
      fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  {} of {}", "", filled, "", kBarWidth - filled,
                  std::floor(100 * share), summary.done(), summary.count);
  if (rate > 0) {
    line += fmt::format("  {:.{}f}/s  {} left", rate, rate < 10 ? 1 : 0,
                        TimeText((static_cast<double>(summary.count) - done) / rate));
  }
  if (summary.failed + summary.skipped > 0)
    line += fmt::format("  {} failed", summary.failed + summary.skipped);
  if (line.size() > width) line.resize(width);
  return line;
}

}  // namespace

ProgressBar::ProgressBar(bool enabled) : enabled_(enabled && IsTerminal()) {}

void ProgressBar::Show(const batch::Summary& summary) {
  const auto elapsed = std::chrono::steady_clock::now() - start_;
  if (!enabled_ || elapsed < kDelay) return;
  const double seconds = Seconds(elapsed).count();
  // Uses one column less than the terminal, because a full line would wrap.
  fmt::print(stderr, "{}{}", kClearLine, ProgressLine(summary, seconds, TerminalWidth() - 1));
  std::fflush(stderr);
  shown_ = true;
}

void ProgressBar::Clear() {
  if (!shown_) return;
  fmt::print(stderr, "{}", kClearLine);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace mjforge::app
