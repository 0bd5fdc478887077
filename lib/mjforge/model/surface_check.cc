// Check for meshes with a well-defined interior: the triangles must traverse each edge equally
// often in both directions, and the enclosed volume must be positive.

#include <cstdint>
#include <unordered_map>

#include <fmt/format.h>

#include "mjforge/diag/diag.h"
#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

// Number of triangles that traverse an edge from its smaller to its larger vertex index (`up`), and
// in the opposite direction (`down`).
struct EdgeUses {
  int up = 0;
  int down = 0;
};

}  // namespace

std::optional<std::string> FindSurfaceDefect(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "no triangles";
  std::unordered_map<std::uint64_t, EdgeUses> edges;
  edges.reserve(mesh.triangles.size() * 3 / 2);
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = static_cast<std::uint32_t>(triangle[i]);
      const auto to = static_cast<std::uint32_t>(triangle[(i + 1) % 3]);
      EdgeUses& uses = edges[std::uint64_t{std::min(from, to)} << 32 | std::max(from, to)];
      ++(from < to ? uses.up : uses.down);
    }
  }
  // Reports the smallest odd number of triangles at an edge, because the first such edge depends on
  // the order of the hash map.
  int open = 0;
  bool is_reversed = false;
  for (const auto& [edge, uses] : edges) {
    if (uses.up == uses.down) continue;
    const int count = uses.up + uses.down;
    if (count % 2 == 0) {
      is_reversed = true;
    } else if (open == 0 || count < open) {
      open = count;
    }
  }
  if (open > 0) return "edge shared by " + diag::Counted(open, "triangle");
  if (is_reversed) return "neighbouring triangles face opposite ways";
  const double volume = Volume({.type = GeomType::kMesh, .mesh = &mesh});
  if (volume < 0) return "inside out";
  if (!(volume > 0)) return "no volume";
  return std::nullopt;
}

}  // namespace mjforge::model
