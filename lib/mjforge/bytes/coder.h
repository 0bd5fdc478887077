// Binary encoding of structs, for messages between processes and for temporary files.

#pragma once

// Numbers and enumerators are stored as they are in memory, so only a program on the same kind of
// machine can decode them. Texts and lists are preceded by their length (8 bytes), optional values
// by a flag, and alternatives of a variant by their index (1 byte). Fields::Of(struct) returns
// references to the members of a struct (std::tie); encoding and decoding use the same tuple, so
// their order of members cannot differ.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace mjforge::bytes {
namespace internal {

/// Writes values to memory, or only counts their bytes if the memory is null.
class CodeWriter {
 public:
  static constexpr bool kReads = false;
  explicit CodeWriter(char* out) : out_(out) {}

  void Raw(const auto& value) { Put({reinterpret_cast<const char*>(&value), sizeof(value)}); }
  std::size_t Size(std::size_t size) {
    Raw(std::uint64_t{size});
    return size;
  }
  void Text(std::string_view text) {
    Size(text.size());
    Put(text);
  }
  std::size_t written() const { return written_; }

 private:
  void Put(std::string_view bytes) {
    if (out_ != nullptr) bytes.copy(out_ + written_, bytes.size());
    written_ += bytes.size();
  }

  char* out_;
  std::size_t written_ = 0;
};

/// Reads values. Throws std::runtime_error if the bytes end too early.
class CodeReader {
 public:
  static constexpr bool kReads = true;
  explicit CodeReader(std::string_view bytes) : bytes_(bytes) {}

  void Raw(auto& value) { std::memcpy(&value, Take(sizeof(value)).data(), sizeof(value)); }
  /// Reads the length of a text or list. Throws if it exceeds the number of bytes left: an item has
  /// at least one byte.
  std::size_t Size(std::size_t /*size*/) {
    std::uint64_t size = 0;
    Raw(size);
    return Checked(size);
  }
  void Text(auto& text) { text = Take(Size(0)); }

 private:
  std::size_t Checked(std::uint64_t size) const {
    if (size > bytes_.size()) throw std::runtime_error("it is cut short or damaged");
    return size;
  }
  std::string_view Take(std::size_t size) {
    const std::string_view taken = bytes_.substr(0, Checked(size));
    bytes_.remove_prefix(size);
    return taken;
  }

  std::string_view bytes_;
};

/// Returns a variant that holds the default value of its alternative `index`.
template <typename Variant, std::size_t i = 0>
Variant Alternative(std::size_t index) {
  if constexpr (i < std::variant_size_v<Variant>)
    return index == i ? Variant(std::in_place_index<i>) : Alternative<Variant, i + 1>(index);
  else
    throw std::runtime_error("it is damaged");
}

template <typename Fields, typename Coder, typename T>
void Code(Coder& coder, T& value) {
  const auto code = [&](auto& part) { Code<Fields>(coder, part); };
  if constexpr (requires { Fields::Of(value); }) {
    std::apply([&](auto&... members) { (code(members), ...); }, Fields::Of(value));
  } else if constexpr (std::is_convertible_v<T&, std::string_view>) {
    coder.Text(value);
  } else if constexpr (std::is_same_v<T, std::vector<bool>>) {
    std::vector<std::uint8_t> flags(value.begin(), value.end());
    code(flags);
    value.assign(flags.begin(), flags.end());
  } else if constexpr (requires { value.emplace_back(); }) {
    const std::size_t size = coder.Size(value.size());
    if constexpr (Coder::kReads) value.resize(size);
    for (auto& item : value) code(item);
  } else if constexpr (requires { value.has_value(); }) {
    bool has_value = value.has_value();
    coder.Raw(has_value);
    if (Coder::kReads && has_value) value.emplace();
    if (value) code(*value);
  } else if constexpr (requires { std::variant_size<T>::value; }) {
    auto index = static_cast<std::uint8_t>(value.index());
    coder.Raw(index);
    if constexpr (Coder::kReads) value = Alternative<T>(index);
    std::visit(code, value);
  } else if constexpr (requires { value.Add(*value.begin()); }) {  // a list such as diag::Findings
    std::vector<std::remove_cvref_t<decltype(*value.begin())>> items(value.begin(), value.end());
    code(items);
    if constexpr (Coder::kReads) {
      for (auto& item : items) value.Add(std::move(item));
    }
  } else {
    static_assert(std::is_trivially_copyable_v<T>);
    coder.Raw(value);
  }
}

}  // namespace internal

/// Encodes a value to `out`, or only counts its bytes if `out` is null. Returns the number of
/// bytes.
template <typename Fields, typename T>
std::size_t EncodeTo(char* out, const T& value) {
  internal::CodeWriter writer(out);
  internal::Code<Fields>(writer, const_cast<T&>(value));  // a writer does not change the value
  return writer.written();
}

template <typename Fields, typename T>
std::string Encode(const T& value) {
  std::string bytes(EncodeTo<Fields>(nullptr, value), '\0');
  EncodeTo<Fields>(bytes.data(), value);
  return bytes;
}

/// Decodes values one after the other. Views in the values refer to the bytes.
template <typename Fields>
class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : reader_(bytes) {}

  /// Throws std::runtime_error if the bytes end too early or are damaged.
  template <typename T>
  T Read() {
    T value = {};
    internal::Code<Fields>(reader_, value);
    return value;
  }

 private:
  internal::CodeReader reader_;
};

}  // namespace mjforge::bytes
