#include <cstdint>
#include <unordered_map>

#include <fmt/format.h>

#include "mjforge/model/meshes.h"
#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

// How often an edge is walked from its smaller to its larger vertex and back.
struct Walks {
  int up = 0;
  int down = 0;
};

}  // namespace

std::optional<std::string> WhyNotSolid(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "no triangles";
  std::unordered_map<std::uint64_t, Walks> edges;
  edges.reserve(mesh.triangles.size() * 3 / 2);
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = static_cast<std::uint32_t>(triangle[i]);
      const auto to = static_cast<std::uint32_t>(triangle[(i + 1) % 3]);
      Walks& walks = edges[std::uint64_t{std::min(from, to)} << 32 | std::max(from, to)];
      ++(from < to ? walks.up : walks.down);
    }
  }
  // The worst edge in words that do not depend on the map's order.
  int open = 0;
  bool turned = false;
  for (const auto& [edge, walks] : edges) {
    if (walks.up == walks.down) continue;
    const int count = walks.up + walks.down;
    if (count % 2 == 0) {
      turned = true;
    } else if (open == 0 || count < open) {
      open = count;
    }
  }
  if (open > 0) return fmt::format("edge shared by {} triangle{}", open, open == 1 ? "" : "s");
  if (turned) return "neighbouring triangles face opposite ways";
  const double volume = Volume({.type = GeomType::kMesh, .mesh = &mesh});
  if (volume < 0) return "inside out";
  if (!(volume > 0)) return "no volume";
  return std::nullopt;
}

}  // namespace mjforge::model
