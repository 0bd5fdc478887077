// Checks of binary mesh and skin files: STL, and MuJoCo's own formats MSH and SKN.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "mjforge/mesh_data/formats.h"

namespace mjforge::mesh_data {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr const char* kNotFinite = "a coordinate is not a finite number";

template <typename T>
T ValueAt(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

// Returns true if all `count` floats from the byte `at` on are finite.
bool AreFinite(std::string_view bytes, std::size_t at, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(ValueAt<float>(bytes, at + i * sizeof(float)))) return false;
  }
  return true;
}

// The header of MSH and SKN: four counts of type int.
using Counts = std::array<std::uint64_t, 4>;
constexpr std::size_t kHeader = 4 * sizeof(std::int32_t);

// Reads the counts of the header into `counts`. Returns a message about a negative count; an empty
// text if there is none or the content is shorter than a header.
std::string ReadCounts(std::string_view content, Counts& counts) {
  for (std::size_t i = 0; i < counts.size() && content.size() >= kHeader; ++i) {
    const auto count = ValueAt<std::int32_t>(content, i * sizeof(std::int32_t));
    if (count < 0) return fmt::format("its header has a count of {}", count);
    counts[i] = static_cast<std::uint64_t>(count);
  }
  return {};
}

// Returns the first fault of the data after a header: `numbers` floats, and `faces` triples of
// indices below `vertices`. Returns an empty text if there is no fault.
std::string FindDataFault(std::string_view content, std::uint64_t numbers, std::uint64_t faces,
                          std::uint64_t vertices) {
  if (!AreFinite(content, kHeader, numbers)) return kNotFinite;
  for (std::size_t i = 0; i < 3 * faces; ++i) {
    const auto index = ValueAt<std::int32_t>(content, kHeader + sizeof(float) * (numbers + i));
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices)
      return fmt::format("face {} uses vertex {} of {}, counted from 0", i / 3, index, vertices);
  }
  return {};
}

}  // namespace

bool IsBinaryStl(std::string_view content) {
  constexpr std::size_t kCount = kStlHeader - sizeof(std::uint32_t);
  return content.size() >= kStlHeader && (content.size() - kStlHeader) % kStlTriangle == 0 &&
         (content.size() - kStlHeader) / kStlTriangle == ValueAt<std::uint32_t>(content, kCount);
}

Check CheckStl(std::string_view content) {
  constexpr std::size_t kCorners = 12;  // offset after the normal, which MuJoCo ignores
  if (!IsBinaryStl(content)) return {};
  const std::size_t triangles = (content.size() - kStlHeader) / kStlTriangle;
  for (std::size_t i = 0; i < triangles; ++i) {
    if (!AreFinite(content, kStlHeader + i * kStlTriangle + kCorners, 9)) return {kNotFinite, 0};
  }
  return {{}, 3 * triangles};
}

Check CheckMsh(std::string_view content) {
  // An MSH file has the counts of vertices, normals, texture coordinates and faces, and then their
  // data. Source: the format MSH in MuJoCo's XML reference, under `mesh`.
  Counts counts;
  std::string fault = ReadCounts(content, counts);
  if (content.size() < kHeader || !fault.empty()) return {std::move(fault), 0};
  const auto [vertices, normals, texcoords, faces] = counts;
  const std::uint64_t numbers = 3 * vertices + 3 * normals + 2 * texcoords;
  const std::uint64_t size = kHeader + sizeof(float) * (numbers + 3 * faces);
  if (content.size() != size)
    return {fmt::format("it has {} bytes, but its header requires {}", content.size(), size), 0};
  return {FindDataFault(content, numbers, faces, vertices), vertices};
}

Check CheckSkn(std::string_view content) {
  // An SKN file has the counts of vertices, texture coordinates, faces and bones, and then their
  // data. MuJoCo checks the bones. Source: the format SKN in MuJoCo's XML reference, under `skin`.
  Counts counts;
  std::string fault = ReadCounts(content, counts);
  if (content.size() < kHeader || !fault.empty()) return {std::move(fault), 0};
  const auto [vertices, texcoords, faces, bones] = counts;
  const std::uint64_t numbers = 3 * vertices + 2 * texcoords;
  const std::uint64_t size = kHeader + sizeof(float) * (numbers + 3 * faces);
  if (content.size() < size)
    return {fmt::format("it has {} bytes, but its header requires {}", content.size(), size), 0};
  return {FindDataFault(content, numbers, faces, vertices), vertices};
}

}  // namespace mjforge::mesh_data
