#include "mjforge/validate/geoms.h"

#include <optional>

namespace mjforge::validate {
namespace {

std::optional<model::GeomType> TypeOf(int type) {
  switch (type) {
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
    default:
      return std::nullopt;
  }
}

model::Box3 MeshBox(const mjModel& m, int mesh, const model::Pose& X_AG) {
  model::Box3 box;
  const Eigen::Matrix3d R_AG = X_AG.q.toRotationMatrix();
  for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) {
    const Eigen::Map<const Eigen::Vector3f> vertex(m.mesh_vert + 3 * (m.mesh_vertadr[mesh] + i));
    const Eigen::Vector3d p = R_AG * vertex.cast<double>() + X_AG.p;
    box.Add({p, p});
  }
  return box;
}

}  // namespace

model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id) {
  const mjtNum* p = pos + 3 * id;
  const mjtNum* q = quat + 4 * id;
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

bool CollidesInBody(const mjModel& m, int geom) {
  return m.geom_bodyid[geom] != 0 && (m.geom_contype[geom] != 0 || m.geom_conaffinity[geom] != 0);
}

model::Box3 GeomBox(const mjModel& m, int geom, const model::Pose& X_AG) {
  if (m.geom_type[geom] == mjGEOM_MESH) return MeshBox(m, m.geom_dataid[geom], X_AG);
  const std::optional<model::GeomType> type = TypeOf(m.geom_type[geom]);
  if (!type) return {};
  const Eigen::Vector3d size = Eigen::Map<const Eigen::Vector3d>(m.geom_size + 3 * geom);
  return model::BoundsOf({*type, size, nullptr}, X_AG);
}

}  // namespace mjforge::validate
