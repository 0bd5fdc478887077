// Half-edge table of a polytope: which faces meet at an edge and at a vertex.

#pragma once

#include <map>
#include <utility>
#include <vector>

#include "mjforge/solid/polytope.h"

namespace mjforge::solid {

/// Half-edge table of a closed polytope. Indices of faces and vertices are those of the polytope.
class HalfEdges {
 public:
  explicit HalfEdges(const Polytope& polytope);

  /// Returns the face to the left of the edge from a to b, seen from outside. Throws
  /// std::out_of_range if the polytope has no such edge.
  int FaceAt(int a, int b) const { return next_.at({a, b}).first; }
  /// Returns each edge once, as a pair of vertices.
  std::vector<std::pair<int, int>> All() const;
  /// Returns the faces around a vertex, counter-clockwise seen from outside.
  std::vector<int> FacesAround(int vertex) const;

 private:
  // Maps each half-edge (start vertex, end vertex) to its face and to the next vertex of that face.
  std::map<std::pair<int, int>, std::pair<int, int>> next_;
  std::vector<int> some_neighbour_;  // a neighbour of each vertex
};

}  // namespace mjforge::solid
