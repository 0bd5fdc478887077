// Reads poses, meshes and bounding boxes of geoms from compiled models.
#include <algorithm>

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

Eigen::Vector3d VectorAt(const mjtNum* array, int id) {
  return Eigen::Map<const Eigen::Vector3d>(array + 3 * static_cast<std::ptrdiff_t>(id));
}

Eigen::Quaterniond QuaternionAt(const mjtNum* array, int id) {
  const mjtNum* q = array + 4 * static_cast<std::ptrdiff_t>(id);
  return {q[0], q[1], q[2], q[3]};
}

Eigen::Matrix3d MatrixAt(const mjtNum* array, int id) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(array + 9 * static_cast<std::ptrdiff_t>(id));
}

model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id) {
  return {VectorAt(pos, id), QuaternionAt(quat, id)};
}

void WritePose(const model::Pose& X, mjtNum* pos, mjtNum* quat) {
  const Eigen::Vector3d p = X.p;
  const Eigen::Quaterniond q = X.q;
  const mjtNum wxyz[] = {q.w(), q.x(), q.y(), q.z()};
  mju_copy3(pos, p.data());
  mju_copy4(quat, wxyz);
}

std::optional<model::GeomType> GeomTypeOf(int mjtgeom) {
  const auto found = std::ranges::find(kGeomTypes, mjtgeom);
  if (found == kGeomTypes.end()) return std::nullopt;
  return static_cast<model::GeomType>(found - kGeomTypes.begin());
}

bool Collides(const mjModel& m, int geom) {
  return m.geom_contype[geom] != 0 || m.geom_conaffinity[geom] != 0;
}

model::Pose GeomPose(const mjData& d, int geom) {
  return {VectorAt(d.geom_xpos, geom), Eigen::Quaterniond(MatrixAt(d.geom_xmat, geom))};
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
  return model::BoundsOf({*type, VectorAt(m.geom_size, geom), nullptr}, X_AG);
}

model::Box3 CollidingBox(const mjModel& m, const mjData& d, int root) {
  model::Box3 box;
  for (int i = 0; i < m.ngeom; ++i) {
    const bool inside = root == 0 || m.body_rootid[m.geom_bodyid[i]] == root;
    if (inside && Collides(m, i)) box.Add(GeomBox(m, i, GeomPose(d, i)));
  }
  return box;
}

}  // namespace mjforge::compiled
