// Makes free bodies too heavy to be moved in a copy of a model, and disables actuators and the
// floor.
#include "mjforge/physics/held_model.h"

#include <algorithm>

#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

// Armature of a held free body: for translations, a multiple of the mass of its tree; for
// rotations, the same multiple of this mass times the square of the size of the tree.
constexpr double kHeldRootMass = 1e6;
// Tolerance of the solver. In a model with the large mass of held bodies, MuJoCo's default of 1e-8
// lets MuJoCo 3 and 4 stop before an equality of light joints holds: for example, the lid of a jar
// made half a turn without rising.
constexpr double kTolerance = 1e-12;

}  // namespace

engine::Model HeldModel(const mjModel& model) {
  engine::Model held(mj_copyModel(nullptr, &model));
  mjModel& m = *held;
  m.opt.disableflags |= mjDSBL_ACTUATION;
  m.opt.tolerance = std::min<mjtNum>(m.opt.tolerance, kTolerance);
  for (const int body : FreeBodies(m)) {
    double size = 0;
    for (int geom = 0; geom < m.ngeom; ++geom) {
      if (m.body_rootid[m.geom_bodyid[geom]] == body) size = std::max(size, m.geom_rbound[geom]);
    }
    const double mass = kHeldRootMass * m.body_subtreemass[body];
    for (int k = 0; k < 6; ++k)
      m.dof_armature[m.body_dofadr[body] + k] += k < 3 ? mass : mass * size * size;
  }
  for (int i = 0; i < m.ngeom; ++i) {
    if (m.geom_bodyid[i] == 0 && m.geom_type[i] == mjGEOM_PLANE)
      m.geom_contype[i] = m.geom_conaffinity[i] = 0;
  }
  return held;
}

}  // namespace mjforge::physics
