// Capture of stderr: replaces `stderr` by a stream of the C library whose text is appended to the
// CapturedStderr of the printing thread.
#include "mjforge/engine/captured_stderr.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::engine {
namespace {

// Limit of the captured text, bytes, because Qhull prints a few pages for each bad mesh.
constexpr std::size_t kMaxText = std::size_t{1} << 20;

std::mutex mutex;                          // protects `captures` and `own_stderr`
std::vector<std::string*> captures;        // texts of all existing CapturedStderr
std::FILE* own_stderr = nullptr;           // the original `stderr`
thread_local std::string* thread_capture;  // text of this thread's CapturedStderr, or null

// Appends text to the CapturedStderr of the calling thread or, if the thread has none, to the
// newest one of any thread, because later releases of MuJoCo compile meshes in threads of their
// own.
::ssize_t Append(void*, const char* bytes, std::size_t size) {
  const std::lock_guard lock(mutex);
  std::string* const text = thread_capture != nullptr ? thread_capture
                            : captures.empty()        ? nullptr
                                                      : captures.back();
  if (text != nullptr) text->append(bytes, std::min(size, kMaxText - text->size()));
  return static_cast<::ssize_t>(size);
}

// Returns the stream that replaces stderr, or null if it cannot be created. The stream has no
// buffer, so that each call of fprintf reaches Append at once.
std::FILE* CapturingStream() {
  static std::FILE* const stream = [] {
    std::FILE* const made = ::fopencookie(
        nullptr, "w", {.read = nullptr, .write = Append, .seek = nullptr, .close = nullptr});
    if (made != nullptr) std::setvbuf(made, nullptr, _IONBF, 0);
    return made;
  }();
  return stream;
}

}  // namespace

CapturedStderr::CapturedStderr() {
  const std::lock_guard lock(mutex);
  if (captures.empty() && CapturingStream() != nullptr) {
    own_stderr = stderr;
    stderr = CapturingStream();  // `stderr` is assignable in the GNU C library
  }
  captures.push_back(&text_);
  thread_capture = &text_;
}

CapturedStderr::~CapturedStderr() {
  const std::lock_guard lock(mutex);
  thread_capture = nullptr;
  std::erase(captures, &text_);
  if (captures.empty() && own_stderr != nullptr) stderr = own_stderr;
}

std::vector<std::string> CapturedStderr::QhullMessages() const {
  std::vector<std::string> messages;
  for (std::string_view rest = text_; !rest.empty();) {
    const std::string_view line = diag::CutAt('\n', rest);
    if (!line.starts_with("QH")) continue;
    const std::size_t colon = line.find(": ");
    messages.emplace_back(line.substr(colon == line.npos ? 0 : colon + 2));
  }
  return messages;
}

}  // namespace mjforge::engine
