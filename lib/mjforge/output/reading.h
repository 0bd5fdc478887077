#ifndef MJFORGE_OUTPUT_READING_H_
#define MJFORGE_OUTPUT_READING_H_

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace mjforge::output {

/// The first `limit` bytes of a file, or a little more; nothing, with errno
/// set, if it cannot be read.
std::optional<std::string> ReadStart(const std::filesystem::path& file, std::size_t limit);

}  // namespace mjforge::output

#endif  // MJFORGE_OUTPUT_READING_H_
