// NumPy's archives of arrays, read independently of the library that writes them.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mjforge::harness {

struct NpyArray {
  std::string type;  // "<f8"
  std::vector<std::uint64_t> shape;
  std::string bytes;

  std::vector<double> Numbers() const;
  /// Texts of an array of type <U.
  std::vector<std::string> Texts() const;
};

/// Returns the arrays of an .npz file in their order, by name. Fails the test if a member is
/// compressed, is no array, or has a wrong size.
std::vector<std::pair<std::string, NpyArray>> ReadNpz(const std::string& bytes);
std::map<std::string, NpyArray> NpzByName(const std::string& bytes);

}  // namespace mjforge::harness
