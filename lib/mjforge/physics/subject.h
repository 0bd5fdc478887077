#ifndef MJFORGE_PHYSICS_SUBJECT_H_
#define MJFORGE_PHYSICS_SUBJECT_H_

// The solids of an object, from the object itself, which knows what each
// weighs, or from a compiled model, which knows that of whole bodies only.

#include <memory>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::physics {

struct Solid {
  std::string name;
  model::Shape shape;
  model::Pose X_BG;
  double mass = 0;  // kg
  diag::SourceMark mark;
};

struct RigidBody {
  std::string name;
  double mass = 0;                                    // kg
  Eigen::Vector3d p_BCm = Eigen::Vector3d::Zero();    // m
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();  // principal, kg m^2
  /// Those that collide; all, if none does.
  std::vector<Solid> solids;
  bool masses_known = false;  // of each solid; else they share the body's by volume
  diag::SourceMark mark;
};

struct Subject {
  std::string name;
  diag::SourceMark mark;
  std::vector<RigidBody> bodies;  // with solids
  double mass = 0;
  model::Box3 box;  // of all solids, in the root's or the world's frame
  std::vector<std::unique_ptr<model::TriangleMesh>> meshes;  // of a compiled model's solids
};

/// "lid", or "geom 3" for what has no name.
std::string NameOf(const mjModel& m, mjtObj kind, int id);

/// The object must outlive the subject.
Subject SubjectOf(const model::Object& object);
/// All of a model's bodies but the world; findings are to point at `mark`.
Subject SubjectOf(const mjModel& m, diag::SourceMark mark);

}  // namespace mjforge::physics

#endif  // MJFORGE_PHYSICS_SUBJECT_H_
