// Reading files, and permission to replace existing files.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "mjforge/bytes/bytes.h"
#include "mjforge/output/atomic_file.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

// First bytes of the files that mjforge writes for variants.
constexpr std::string_view kObjectMark = "<!-- mjforge ";
constexpr std::string_view kPlacementMark = R"({"mjforge":)";

}  // namespace

std::optional<std::string> ReadFile(const std::filesystem::path& file, std::uint64_t limit,
                                    diag::Findings& findings) {
  std::string why_not;
  std::optional<std::string> content = bytes::Read(file, limit, why_not);
  if (!content) findings.AddCannotRead(file.string(), why_not);
  return content;
}

bool MayReplace(const std::filesystem::path& file, bool force, std::size_t bytes,
                const std::function<bool(std::string_view)>& is_ours, diag::Findings& findings) {
  std::error_code ignored;
  if (!std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) return true;
  // Rejects pipes, because opening a pipe blocks until a process writes to it, and devices, which
  // must not be replaced.
  if (std::filesystem::is_other(file, ignored)) {
    findings.Add(diag::Code::kOutputCannotWrite, {},
                 fmt::format("'{}' is a pipe or a device, not a file", file.string()),
                 "use '-o -' to write to standard output");
    return false;
  }
  if (std::filesystem::is_directory(file, ignored)) {
    findings.Add(diag::Code::kOutputCannotWrite, {},
                 fmt::format("'{}' is a folder, not a file", file.string()), "choose another name");
    return false;
  }
  if (force) return true;
  if (std::filesystem::is_symlink(file, ignored)) {
    findings.Add(diag::Code::kOutputCannotWrite, {},
                 fmt::format("'{}' is a link, not a file", file.string()),
                 "name the file itself, or replace the link with --force");
    return false;
  }
  std::string why_not;
  const std::optional<std::string> opening = bytes::ReadStart(file, bytes, why_not);
  if (opening && is_ours(*opening)) return true;
  findings.Add(diag::Code::kOutputExists, {},
               fmt::format("'{}' exists and was not made by mjforge", file.string()),
               "choose another place, or overwrite it with --force");
  return false;
}

bool IsDamagedCopy(std::string_view present, std::string_view bytes) {
  if (present.size() > bytes.size()) return !bytes.empty() && present.starts_with(bytes);
  const auto [end, other] = std::ranges::mismatch(present, bytes);
  if (std::all_of(end, present.end(), [](char c) { return c == 0; })) return true;
  const std::size_t equal = std::transform_reduce(present.begin(), present.end(), bytes.begin(),
                                                  std::size_t{0}, std::plus<>(), std::equal_to<>());
  return present.size() == bytes.size() && 2 * equal >= bytes.size();
}

bool MayReplace(const std::filesystem::path& file, std::string_view text, bool force,
                diag::Findings& findings) {
  return MayReplace(
      file, force, kCommentBytes,
      [text](std::string_view opening) {
        // Accepts the remains of a power cut: such a file ends at any byte or has zeros from there
        // on.
        const std::string_view mark = text.starts_with('{') ? kPlacementMark : kObjectMark;
        const std::string_view left = opening.substr(0, opening.find('\0'));
        const bool is_cut = left.find("-->") == left.npos &&
                            left.substr(0, mark.size()) == mark.substr(0, left.size());
        return is_cut || mjcf::ReadProvenance(opening).has_value() ||
               IsDamagedCopy(opening, text.substr(0, kCommentBytes));
      },
      findings);
}

}  // namespace mjforge::output
