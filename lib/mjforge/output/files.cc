#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "mjforge/output/atomic_file.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

// The comment that opens an object is shorter than this, settings and all.
constexpr std::size_t kCommentBytes = 64 * 1024;

}  // namespace

std::optional<std::string> ReadStart(const std::filesystem::path& file, std::size_t limit) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  std::string bytes;
  std::array<char, 64 * 1024> buffer;
  ssize_t count = 0;
  while (bytes.size() < limit) {
    count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
  const int error = errno;
  ::close(descriptor);
  errno = error;
  if (count < 0) return std::nullopt;
  return bytes;
}

bool WriteFile(const std::filesystem::path& file, std::string_view bytes, bool if_changed,
               diag::Findings& findings) {
  if (if_changed && ReadStart(file, bytes.size() + 1) == bytes) return true;
  const std::unique_ptr<AtomicFile> target = AtomicFile::Create(file, findings);
  return target && target->Append(bytes, findings) && target->Commit(findings);
}

std::optional<std::string> ReadFile(const std::filesystem::path& file, diag::Findings& findings) {
  std::optional<std::string> bytes = ReadStart(file, std::string::npos);
  if (!bytes) {
    findings.Add(
        diag::Code::kYamlCannotRead, {},
        fmt::format("cannot read '{}': {}", file.string(), std::generic_category().message(errno)));
  }
  return bytes;
}

bool MayReplace(const std::filesystem::path& file, bool force, std::size_t bytes,
                const std::function<bool(std::string_view)>& is_ours, diag::Findings& findings) {
  std::error_code ignored;
  if (!std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) return true;
  // A pipe would have us wait for somebody to write, a device is not ours to replace.
  if (std::filesystem::is_other(file, ignored)) {
    findings.Add(diag::Code::kOutputCannotWrite, {},
                 fmt::format("'{}' is a pipe or a device, not a file", file.string()),
                 "use '-o -' to write to standard output");
    return false;
  }
  if (force) return true;
  const std::optional<std::string> opening = ReadStart(file, bytes);
  if (opening && is_ours(*opening)) return true;
  AddForeign(file, findings);
  return false;
}

bool MayReplace(const std::filesystem::path& file, bool force, diag::Findings& findings) {
  return MayReplace(
      file, force, kCommentBytes,
      [](std::string_view opening) { return mjcf::ReadProvenance(opening).has_value(); }, findings);
}

void AddForeign(const std::filesystem::path& file, diag::Findings& findings) {
  findings.Add(diag::Code::kOutputExists, {},
               fmt::format("'{}' exists and was not made by mjforge", file.string()),
               "choose another place, or overwrite it with --force");
}

}  // namespace mjforge::output
