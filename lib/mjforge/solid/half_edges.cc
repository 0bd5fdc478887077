// HalfEdges: builds the table from the faces of a polytope, and lists edges and faces around a
// vertex.

#include "mjforge/solid/half_edges.h"

#include <algorithm>

namespace mjforge::solid {

HalfEdges::HalfEdges(const Polytope& polytope) : some_neighbour_(polytope.vertices.size(), -1) {
  for (std::size_t face = 0; face < polytope.faces.size(); ++face) {
    const std::vector<int>& corners = polytope.faces[face].corners;
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const int a = corners[i];
      const int b = corners[(i + 1) % count];
      next_[{a, b}] = {static_cast<int>(face), corners[(i + 2) % count]};
      some_neighbour_[static_cast<std::size_t>(a)] = b;
    }
  }
}

std::vector<std::pair<int, int>> HalfEdges::All() const {
  std::vector<std::pair<int, int>> all;
  for (const auto& [edge, unused] : next_) {
    if (edge.first < edge.second) all.push_back(edge);
  }
  return all;
}

std::vector<int> HalfEdges::FacesAround(int vertex) const {
  std::vector<int> faces;
  const int start = some_neighbour_[static_cast<std::size_t>(vertex)];
  int neighbour = start;
  do {
    faces.push_back(FaceAt(vertex, neighbour));
    // In the face to the left of the half-edge from `neighbour` to `vertex`, the next half-edge
    // runs from `vertex` to the next neighbour.
    neighbour = next_.at({neighbour, vertex}).second;
  } while (neighbour != start);
  std::ranges::reverse(faces);
  return faces;
}

}  // namespace mjforge::solid
