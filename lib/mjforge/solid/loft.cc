// Triangulation of a loft: both end caps, then the sides.

#include "mjforge/solid/loft.h"

namespace mjforge::solid {

TriangleMesh Loft(const std::vector<LoftSection>& sections) {
  TriangleMesh mesh;
  for (const LoftSection& section : sections) {
    for (const Point2& p : section.corners) mesh.vertices.emplace_back(p.x(), p.y(), section.z);
  }
  const int count = static_cast<int>(sections.front().corners.size());
  const int last = static_cast<int>(mesh.vertices.size()) - count;
  for (int i = 1; i + 1 < count; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({last, last + i, last + i + 1});
  }
  for (int below = 0; below < last; below += count) {
    for (int i = 0; i < count; ++i) {
      const int next = (i + 1) % count;
      mesh.triangles.push_back({below + i, below + next, below + count + next});
      mesh.triangles.push_back({below + i, below + count + next, below + count + i});
    }
  }
  return mesh;
}

}  // namespace mjforge::solid
