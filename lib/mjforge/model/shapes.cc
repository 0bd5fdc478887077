// Geometry of shapes: names and sizes, support functions, bounding boxes.

#include "mjforge/model/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mjforge::model {
namespace {

double MeshSupport(const TriangleMesh& mesh, const Eigen::Vector3d& direction) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    largest = std::max(largest, direction.dot(vertex));
  }
  return largest;
}

Box3 MeshBounds(const TriangleMesh& mesh, const Eigen::Vector3d& p, const Eigen::Matrix3d& R_AG) {
  Box3 box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3d p_A = R_AG * vertex;
    box.min = box.min.cwiseMin(p_A);
    box.max = box.max.cwiseMax(p_A);
  }
  box.min += p;
  box.max += p;
  return box;
}

}  // namespace

std::string_view GeomTypeName(GeomType type) {
  return kGeomTypeNames[static_cast<std::size_t>(type)];
}

int SizeCount(GeomType type) {
  constexpr std::array<int, 6> kCounts = {1, 2, 3, 2, 3, 0};
  return kCounts[static_cast<std::size_t>(type)];
}

// Source of Support() and SupportPoint(): Ericson, "Real-Time Collision Detection", 2005, 9.5.
std::vector<Eigen::Vector3d> VerticesOf(const Shape& shape) {
  if (shape.type == GeomType::kMesh) return shape.mesh->vertices;
  if (shape.type != GeomType::kBox) return {};
  const std::array corners = solid::CornersOfBox(shape.size);
  return {corners.begin(), corners.end()};
}

double Support(const Shape& shape, const Eigen::Vector3d& direction_G) {
  const Eigen::Vector3d& d = direction_G;
  const Eigen::Vector3d& s = shape.size;
  switch (shape.type) {
    case GeomType::kSphere:
      return s.x() * d.norm();
    case GeomType::kCapsule:
      return s.x() * d.norm() + s.y() * std::abs(d.z());
    case GeomType::kEllipsoid:
      return s.cwiseProduct(d).norm();
    case GeomType::kCylinder:
      return s.x() * d.head<2>().norm() + s.y() * std::abs(d.z());
    case GeomType::kBox:
      return s.dot(d.cwiseAbs());
    case GeomType::kMesh:
      return MeshSupport(*shape.mesh, d);
  }
  return 0;
}

Eigen::Vector3d SupportPoint(const Shape& shape, const Eigen::Vector3d& direction_G) {
  const Eigen::Vector3d& d = direction_G;
  const Eigen::Vector3d& s = shape.size;
  const auto towards = [](double number) { return number < 0 ? -1.0 : 1.0; };
  switch (shape.type) {
    case GeomType::kSphere:
      return s.x() * d.stableNormalized();
    case GeomType::kCapsule:
      return s.x() * d.stableNormalized() + Eigen::Vector3d(0, 0, s.y() * towards(d.z()));
    case GeomType::kEllipsoid:
      return s.cwiseProduct(s.cwiseProduct(d).stableNormalized());
    case GeomType::kCylinder: {
      const Eigen::Vector2d across = s.x() * d.head<2>().stableNormalized();
      return {across.x(), across.y(), s.y() * towards(d.z())};
    }
    case GeomType::kBox:
      return s.cwiseProduct(d.unaryExpr(towards));
    case GeomType::kMesh: {
      // std::ranges::max_element would compute each vertex's product twice.
      const std::vector<Eigen::Vector3d>& vertices = shape.mesh->vertices;
      std::size_t farthest = 0;
      double most = d.dot(vertices[0]);
      for (std::size_t i = 1; i < vertices.size(); ++i) {
        const double along = d.dot(vertices[i]);
        if (!(most < along)) continue;
        farthest = i;
        most = along;
      }
      return vertices[farthest];
    }
  }
  return Eigen::Vector3d::Zero();
}

// Needs one value of the support function per axis for both sides of the bounding box, because all
// shapes except meshes are symmetric about their centre.
Box3 BoundsOf(const Shape& shape, const Pose& X_AG) {
  const Eigen::Matrix3d R_AG = X_AG.q.toRotationMatrix();
  if (shape.type == GeomType::kMesh) return MeshBounds(*shape.mesh, X_AG.p, R_AG);
  Eigen::Vector3d half;
  for (Eigen::Index i = 0; i < 3; ++i) half(i) = Support(shape, R_AG.row(i).transpose());
  return {.min = X_AG.p - half, .max = X_AG.p + half};
}

Box3 BoundsOf(const solid::Extent& extent, const Pose& X_AS) {
  const Eigen::Matrix3d R_AS = X_AS.q.toRotationMatrix();
  Box3 box;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = R_AS.row(i);
    box.min(i) = X_AS.p(i) - solid::Support(extent, -axis);
    box.max(i) = X_AS.p(i) + solid::Support(extent, axis);
  }
  return box;
}

void Box3::Add(const Box3& other) {
  min = min.cwiseMin(other.min);
  max = max.cwiseMax(other.max);
}

}  // namespace mjforge::model
