#include "mjforge/physics/subject.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {
namespace {

// Where only the whole is known each solid gets its share by volume: as if all
// were of one stuff.
void ShareMass(RigidBody& body) {
  double volume = 0;
  for (const Solid& solid : body.solids) volume += model::Volume(solid.shape);
  for (Solid& solid : body.solids)
    solid.mass = volume > 0 ? body.mass * model::Volume(solid.shape) / volume : 0;
}

void AddBox(const RigidBody& body, const model::Pose& X_FB, Subject& subject) {
  for (const Solid& solid : body.solids)
    subject.box.Add(model::BoundsOf(solid.shape, X_FB * solid.X_BG));
}

Eigen::Vector3d PrincipalInertia(const Eigen::Matrix3d& inertia) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace

std::string NameOf(const mjModel& m, mjtObj kind, int id) {
  const char* name = mj_id2name(&m, kind, id);
  if (name != nullptr && *name != 0) return name;
  return std::string(mju_type2Str(kind)) + ' ' + std::to_string(id);
}

Subject SubjectOf(const model::Object& object) {
  Subject subject;
  subject.name = object.name;
  if (!object.bodies.empty()) subject.mark = object.bodies.front().mark;
  subject.mass = object.mass_properties.mass;
  const std::vector<model::Pose> X_RootB = model::BodyPoses(object);
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    const model::Body& from = object.bodies[i];
    const bool any_collides = std::ranges::any_of(
        from.parts, [](const model::Part& part) { return part.role != model::Role::kVisual; });
    RigidBody body;
    body.name = from.name;
    body.mark = from.mark ? from.mark : subject.mark;
    body.mass = from.mass_properties.mass;
    body.p_BCm = from.mass_properties.p_FCm;
    body.inertia = PrincipalInertia(from.mass_properties.I_Cm_F);
    double sum = 0;
    for (const model::Part& part : from.parts) {
      if (any_collides && part.role == model::Role::kVisual) continue;
      sum += part.mass;
      body.solids.push_back({part.name, part.shape, part.X_BG, part.mass, part.mark});
    }
    if (body.solids.empty()) continue;
    // Of an attached body only the whole may be known.
    body.masses_known = sum > 0;
    if (body.masses_known) body.mass = sum;  // it may have given half of it to what it is fixed to
    if (!body.masses_known) ShareMass(body);
    AddBox(body, X_RootB[i], subject);
    subject.bodies.push_back(std::move(body));
  }
  return subject;
}

Subject SubjectOf(const mjModel& m, diag::SourceMark mark) {
  Subject subject;
  subject.name = m.names;  // the model's name is the first
  subject.mark = mark;
  std::map<int, const model::TriangleMesh*> meshes;
  std::vector<model::Pose> X_WB(static_cast<std::size_t>(m.nbody));
  for (int id = 1; id < m.nbody; ++id) {
    X_WB[static_cast<std::size_t>(id)] = X_WB[static_cast<std::size_t>(m.body_parentid[id])] *
                                         compiled::PoseAt(m.body_pos, m.body_quat, id);
    RigidBody body;
    body.name = NameOf(m, mjOBJ_BODY, id);
    body.mark = mark;
    body.mass = m.body_mass[id];
    body.p_BCm = compiled::VectorAt(m.body_ipos, id);
    body.inertia = compiled::VectorAt(m.body_inertia, id);
    subject.mass += body.mass;
    const int first = m.body_geomadr[id];
    const int end = first + m.body_geomnum[id];
    bool any_collides = false;
    for (int i = first; i < end; ++i) any_collides |= compiled::CollidesInBody(m, i);
    for (int i = first; i < end; ++i) {
      const auto type = compiled::GeomTypeOf(m.geom_type[i]);
      if (!type || (any_collides && !compiled::CollidesInBody(m, i))) continue;
      model::Shape shape = {*type, compiled::VectorAt(m.geom_size, i), nullptr};
      if (*type == model::GeomType::kMesh) {
        const auto [known, is_new] = meshes.try_emplace(m.geom_dataid[i], nullptr);
        if (is_new) {
          subject.meshes.push_back(
              std::make_unique<model::TriangleMesh>(compiled::MeshOf(m, m.geom_dataid[i])));
          known->second = subject.meshes.back().get();
        }
        shape.mesh = known->second;
      }
      body.solids.push_back(
          {NameOf(m, mjOBJ_GEOM, i), shape, compiled::PoseAt(m.geom_pos, m.geom_quat, i), 0, mark});
    }
    if (body.solids.empty()) continue;
    ShareMass(body);
    AddBox(body, X_WB[static_cast<std::size_t>(id)], subject);
    subject.bodies.push_back(std::move(body));
  }
  return subject;
}

}  // namespace mjforge::physics
