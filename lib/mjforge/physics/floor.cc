// Finds fixed geoms on which objects can lie, lifts free bodies above a floor, and levels floors.
#include "mjforge/physics/floor.h"

#include <algorithm>
#include <variant>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

// Largest difference between 1 and the z component of the normal of a plane that counts as level.
constexpr double kLevel = 1e-9;

/// Returns the height of the lowest point of all colliding geoms except planes, m; 0 if there are
/// none.
double LowestPoint(mjModel& m) {
  // Poses need no buffers for constraints, which take most of the memory of a scene.
  const engine::BufferSizes sizes = engine::BufferSizesOf(m);
  engine::SetBufferSizes(m, {});
  const compiled::Data d = compiled::MakeData(m);
  engine::SetBufferSizes(m, sizes);
  mj_kinematics(&m, d.get());
  const model::Box3 box = compiled::CollidingBox(m, *d, 0);
  return box.empty() ? 0 : box.min.z();
}

}  // namespace

double LargestMargin(const mjModel& m) {
  double margin = 0;
  for (int i = 0; i < m.ngeom; ++i) margin = std::max(margin, m.geom_margin[i]);
  return margin;
}

double DropHeight(const mjModel& m) { return 0.002 + LargestMargin(m); }

Ground GroundOf(const mjModel& m, const mjData& d) {
  Ground ground;
  for (int i = 0; i < m.ngeom; ++i) {
    if (m.body_weldid[m.geom_bodyid[i]] != 0) continue;
    if (!compiled::Collides(m, i)) continue;
    const bool level = d.geom_xmat[9 * i + 8] > 1 - kLevel;
    if (m.geom_type[i] == mjGEOM_PLANE && level) {
      ++ground.planes;
      ground.height = d.geom_xpos[3 * i + 2];
    } else {
      ++ground.others;
    }
  }
  return ground;
}

bool LiftFreeBodies(const mjModel& m, mjData& d, double height) {
  const std::vector<int> bodies = FreeBodies(m);
  const model::Box3 box = CollidingBox(m, d, bodies);
  if (box.empty()) return false;
  for (const int body : bodies)
    d.qpos[m.jnt_qposadr[m.body_jntadr[body]] + 2] += height - box.min.z();
  return true;
}

void LevelFloor(mjModel& m, int geom) {
  for (const compiled::ArrayField& field : compiled::ArrayFields(mjOBJ_GEOM)) {
    if (field.variable != nullptr) continue;  // <geom user="..."> has no default
    std::visit(
        [&](auto array) {
          std::copy_n(field.usual->begin(), field.count, m.*array + field.count * geom);
        },
        field.array);
  }
  m.geom_sameframe[geom] = 0;
  mju_unit4(m.geom_quat + 4 * geom);
  const mjtNum pos[] = {0, 0, LowestPoint(m) - DropHeight(m)};
  mju_copy3(m.geom_pos + 3 * geom, pos);
  engine::UpdateCollisionData(m, geom);
}

}  // namespace mjforge::physics
