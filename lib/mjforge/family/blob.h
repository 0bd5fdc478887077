// Encoding of numbers and texts in a file of rows (rows.h).

#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace mjforge::family {

/// Appends numbers as their bytes in memory, and texts as their length and bytes. The byte order is
/// not portable, because a file of rows is read on the same kind of machine that wrote the file.
class BlobWriter {
 public:
  template <typename T>
  requires std::is_trivially_copyable_v<T>
  void Number(T number) { Raw({reinterpret_cast<const char*>(&number), sizeof(number)}); }
  void Text(std::string_view text) {
    Number(std::uint64_t{text.size()});
    Raw(text);
  }
  void Raw(std::string_view bytes) { bytes_ += bytes; }

  std::string Take() { return std::move(bytes_); }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads numbers and texts that BlobWriter wrote. Throws std::runtime_error if the bytes end too
/// early.
class BlobReader {
 public:
  explicit BlobReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T Number() {
    T number;
    std::memcpy(&number, Raw(sizeof(T)).data(), sizeof(T));
    return number;
  }
  std::string_view Text() { return Raw(Number<std::uint64_t>()); }
  /// Reads the length of a list. Throws if fewer bytes are left than the list has entries.
  std::uint64_t Count() {
    const auto count = Number<std::uint64_t>();
    if (count > bytes_.size()) throw std::runtime_error("it is cut short or damaged");
    return count;
  }
  std::string_view Raw(std::uint64_t count) {
    if (count > bytes_.size()) throw std::runtime_error("it is cut short or damaged");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  bool empty() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

}  // namespace mjforge::family
