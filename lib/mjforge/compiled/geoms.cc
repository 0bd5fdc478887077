#include "mjforge/compiled/compiled.h"

namespace mjforge::compiled {
namespace {

Eigen::Vector3d Vertex(const mjModel& m, int mesh, int i) {
  const auto at = static_cast<std::ptrdiff_t>(3) * (m.mesh_vertadr[mesh] + i);
  return Eigen::Map<const Eigen::Vector3f>(m.mesh_vert + at).cast<double>();
}

model::Box3 MeshBox(const mjModel& m, int mesh, const model::Pose& X_AG) {
  model::Box3 box;
  const Eigen::Matrix3d R_AG = X_AG.q.toRotationMatrix();
  for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) {
    const Eigen::Vector3d p = R_AG * Vertex(m, mesh, i) + X_AG.p;
    box.Add({p, p});
  }
  return box;
}

}  // namespace

model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id) {
  const mjtNum* p = pos + 3 * static_cast<std::ptrdiff_t>(id);
  const mjtNum* q = quat + 4 * static_cast<std::ptrdiff_t>(id);
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

std::optional<model::GeomType> GeomTypeOf(int mjtgeom) {
  switch (mjtgeom) {
    case mjGEOM_SPHERE:
      return model::GeomType::kSphere;
    case mjGEOM_CAPSULE:
      return model::GeomType::kCapsule;
    case mjGEOM_ELLIPSOID:
      return model::GeomType::kEllipsoid;
    case mjGEOM_CYLINDER:
      return model::GeomType::kCylinder;
    case mjGEOM_BOX:
      return model::GeomType::kBox;
    case mjGEOM_MESH:
      return model::GeomType::kMesh;
    default:
      return std::nullopt;
  }
}

bool CollidesInBody(const mjModel& m, int geom) {
  return m.geom_bodyid[geom] != 0 && (m.geom_contype[geom] != 0 || m.geom_conaffinity[geom] != 0);
}

model::TriangleMesh MeshOf(const mjModel& m, int mesh) {
  model::TriangleMesh surface;
  for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) surface.vertices.push_back(Vertex(m, mesh, i));
  for (int i = 0; i < m.mesh_facenum[mesh]; ++i) {
    const int* face = m.mesh_face + static_cast<std::ptrdiff_t>(3) * (m.mesh_faceadr[mesh] + i);
    surface.triangles.push_back({face[0], face[1], face[2]});
  }
  return surface;
}

model::Box3 GeomBox(const mjModel& m, int geom, const model::Pose& X_AG) {
  const std::optional<model::GeomType> type = GeomTypeOf(m.geom_type[geom]);
  if (!type) return {};
  if (*type == model::GeomType::kMesh) return MeshBox(m, m.geom_dataid[geom], X_AG);
  const Eigen::Vector3d size =
      Eigen::Map<const Eigen::Vector3d>(m.geom_size + static_cast<std::ptrdiff_t>(3) * geom);
  return model::BoundsOf({*type, size, nullptr}, X_AG);
}

}  // namespace mjforge::compiled
