#pragma once

#include <map>
#include <utility>
#include <vector>

#include "mjforge/solid/polytope.h"

namespace mjforge::solid {

/// Which faces of a polytope meet.
class Edges {
 public:
  explicit Edges(const Polytope& polytope);

  /// The face on the left of the way from a to b, seen from outside.
  int FaceAt(int a, int b) const { return next_.at({a, b}).first; }
  /// Each edge once, by its vertices.
  std::vector<std::pair<int, int>> All() const;
  /// The faces around a vertex, counter-clockwise seen from outside.
  std::vector<int> FacesAround(int vertex) const;

 private:
  // Of each side of a face: the face, and the vertex behind the side's end.
  std::map<std::pair<int, int>, std::pair<int, int>> next_;
  std::vector<int> some_neighbour_;  // of each vertex
};

}  // namespace mjforge::solid
