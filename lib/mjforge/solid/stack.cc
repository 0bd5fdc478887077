#include "mjforge/solid/stack.h"

namespace mjforge::solid {

Piece StackOf(const std::vector<Layer>& layers) {
  Piece piece;
  piece.turns = {0};
  for (const Layer& layer : layers) {
    for (const Point& p : layer.corners) piece.vertices.emplace_back(p.x(), p.y(), layer.z);
  }
  const int count = static_cast<int>(layers.front().corners.size());
  const int last = static_cast<int>(piece.vertices.size()) - count;
  for (int i = 1; i + 1 < count; ++i) {
    piece.triangles.push_back({0, i + 1, i});
    piece.triangles.push_back({last, last + i, last + i + 1});
  }
  for (int below = 0; below < last; below += count) {
    for (int i = 0; i < count; ++i) {
      const int next = (i + 1) % count;
      piece.triangles.push_back({below + i, below + next, below + count + next});
      piece.triangles.push_back({below + i, below + count + next, below + count + i});
    }
  }
  return piece;
}

}  // namespace mjforge::solid
