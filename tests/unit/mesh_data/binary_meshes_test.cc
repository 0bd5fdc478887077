#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <vector>

#include "mjforge/mesh_data/mesh_data.h"

namespace mjforge::mesh_data {
namespace {

template <typename T>
void Append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Returns an MSH file with these counts (vertices, normals, texture coordinates, faces), numbers
/// and indices.
std::string Msh(const std::vector<std::int32_t>& counts, const std::vector<float>& numbers,
                const std::vector<std::int32_t>& faces) {
  std::string bytes;
  for (const std::int32_t count : counts) Append(bytes, count);
  for (const float number : numbers) Append(bytes, number);
  for (const std::int32_t face : faces) Append(bytes, face);
  return bytes;
}

const std::vector<float> kNumbers = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

std::string MshFault(const std::string& bytes) { return CheckFile(Format::kMsh, bytes).fault; }

TEST_CASE("each index of an MSH file is that of a vertex") {
  CHECK(MshFault(Msh({4, 0, 0, 1}, kNumbers, {0, 1, 3})).empty());
  CHECK(CheckFile(Format::kMsh, Msh({4, 0, 0, 0}, kNumbers, {})).vertices == 4);
  CHECK(MshFault(Msh({4, 0, 0, 2}, kNumbers, {0, 1, 3, 0, 1, 4})) ==
        "face 1 uses vertex 4 of 4, counted from 0");
  CHECK(MshFault(Msh({4, 0, 0, 1}, kNumbers, {0, -1, 3})) ==
        "face 0 uses vertex -1 of 4, counted from 0");
}

TEST_CASE("an MSH file has the size that its header requires") {
  CHECK(MshFault(Msh({4, 0, 0, 2}, kNumbers, {0, 1, 3})) ==
        "it has 76 bytes, but its header requires 88");
  // 32 bits are not enough for 3 * 1431655766 vertices.
  CHECK(MshFault(Msh({1431655766, 0, 0, 0}, {0, 0}, {})) ==
        "it has 24 bytes, but its header requires 17179869208");
  CHECK(MshFault(Msh({4, 0, 0, -1}, kNumbers, {})) == "its header has a count of -1");
  CHECK(MshFault("short").empty());
}

TEST_CASE("each index of an SKN file is that of a vertex") {
  const auto fault = [](const std::vector<std::int32_t>& counts,
                        const std::vector<std::int32_t>& faces) {
    return CheckFile(Format::kSkn, Msh(counts, kNumbers, faces) + "bones").fault;
  };
  CHECK(fault({4, 0, 1, 1}, {0, 1, 3}).empty());
  CHECK(fault({4, 0, 1, 1}, {0, 1, 4}) == "face 0 uses vertex 4 of 4, counted from 0");
  CHECK(fault({4, 0, 2, 1}, {0, 1, 3}) == "it has 81 bytes, but its header requires 88");
  CHECK(fault({4, -1, 0, 0}, {}) == "its header has a count of -1");
}

TEST_CASE("each number of a binary mesh is finite") {
  const float bad = std::numeric_limits<float>::infinity();
  std::vector<float> vertices = kNumbers;
  vertices[5] = bad;
  CHECK(MshFault(Msh({4, 0, 0, 0}, vertices, {})) == "a coordinate is not a finite number");
  std::string stl(80, ' ');
  Append(stl, std::uint32_t{1});
  for (int i = 0; i < 12; ++i) Append(stl, i < 3 ? bad : 0.0f);  // a normal, which nothing reads
  CHECK(CheckFile(Format::kStl, stl + "  ").fault.empty());
  CHECK(CheckFile(Format::kStl, stl + "  ").vertices == 3);
  stl.replace(stl.size() - sizeof(bad), sizeof(bad), reinterpret_cast<const char*>(&bad),
              sizeof(bad));
  CHECK(CheckFile(Format::kStl, stl + "  ").fault == "a coordinate is not a finite number");
  CHECK(CheckFile(Format::kStl, "solid text\n").fault.empty());
}

}  // namespace
}  // namespace mjforge::mesh_data
