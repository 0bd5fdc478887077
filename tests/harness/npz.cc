// Reading of .npz files by their central directory.

#include "harness/npz.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <regex>

namespace mjforge::harness {

namespace {

template <typename T>
T At(const std::string& bytes, std::size_t at) {
  T number{};
  REQUIRE(at + sizeof(T) <= bytes.size());
  std::memcpy(&number, bytes.data() + at, sizeof(T));
  return number;
}

NpyArray ReadNpy(const std::string& bytes) {
  REQUIRE(bytes.starts_with(std::string("\x93NUMPY\x01\x00", 8)));
  const std::size_t header = 10 + At<std::uint16_t>(bytes, 8);
  CHECK(header % 64 == 0);
  const std::string words = bytes.substr(10, header - 10);
  std::smatch found;
  const std::regex pattern(
      R"(\{'descr': '([^']+)', 'fortran_order': False, 'shape': \(([0-9, ]*)\), \} *\n)");
  REQUIRE(std::regex_match(words, found, pattern));
  NpyArray array{found[1], {}, bytes.substr(header)};
  std::uint64_t size = array.type.starts_with("<U") ? 4 * std::stoul(array.type.substr(2))
                                                    : std::stoul(array.type.substr(2));
  const std::string shape = found[2];
  const std::regex number("[0-9]+");
  for (std::sregex_iterator i(shape.begin(), shape.end(), number); i != std::sregex_iterator(); ++i)
    array.shape.push_back(std::stoull(i->str()));
  for (const std::uint64_t count : array.shape) size *= count;
  CHECK(array.bytes.size() == size);
  return array;
}

}  // namespace

std::vector<double> NpyArray::Numbers() const {
  REQUIRE(type == "<f8");
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

std::vector<std::string> NpyArray::Texts() const {
  REQUIRE(type.starts_with("<U"));
  const std::size_t length = 4 * std::stoul(type.substr(2));
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < bytes.size(); at += length) {
    std::string& text = texts.emplace_back();
    for (std::size_t i = 0; i < length && bytes[at + i] != 0; i += 4) text += bytes[at + i];
  }
  return texts;
}

std::vector<std::pair<std::string, NpyArray>> ReadNpz(const std::string& bytes) {
  std::vector<std::pair<std::string, NpyArray>> arrays;
  const std::size_t end = bytes.rfind("PK\x05\x06");
  REQUIRE(end != std::string::npos);
  std::size_t at = At<std::uint32_t>(bytes, end + 16);  // of the central directory
  for (int left = At<std::uint16_t>(bytes, end + 10); left > 0; --left) {
    CHECK(At<std::uint16_t>(bytes, at + 10) == 0);  // stored
    const auto size = At<std::uint32_t>(bytes, at + 24);
    const auto name = At<std::uint16_t>(bytes, at + 28);
    const auto more = At<std::uint16_t>(bytes, at + 30) + At<std::uint16_t>(bytes, at + 32);
    const auto local = At<std::uint32_t>(bytes, at + 42);
    const std::size_t start =
        local + 30 + At<std::uint16_t>(bytes, local + 26) + At<std::uint16_t>(bytes, local + 28);
    const std::string member = bytes.substr(at + 46, name);
    REQUIRE(member.ends_with(".npy"));
    arrays.emplace_back(member.substr(0, member.size() - 4), ReadNpy(bytes.substr(start, size)));
    at += 46 + name + static_cast<std::size_t>(more);
  }
  return arrays;
}

std::map<std::string, NpyArray> NpzByName(const std::string& bytes) {
  std::map<std::string, NpyArray> arrays;
  for (auto& [name, array] : ReadNpz(bytes)) CHECK(arrays.emplace(name, std::move(array)).second);
  return arrays;
}

}  // namespace mjforge::harness
