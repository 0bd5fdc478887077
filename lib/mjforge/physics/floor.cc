// Floor on which objects are dropped.
#include "mjforge/physics/floor.h"

#include <algorithm>
#include <variant>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"

namespace mjforge::physics {
namespace {

/// Returns the height of the lowest point of all colliding geoms, except planes.
double LowestPoint(const mjModel& m) {
  const compiled::Data d = compiled::MakeData(m);
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

void LevelFloor(mjModel& m, int geom) {
  for (const compiled::ArrayField& field : compiled::ArrayFields(mjOBJ_GEOM)) {
    if (field.variable != nullptr) continue;  // user data has no default
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
  engine::UpdateBodyOf(m, geom);
}

}  // namespace mjforge::physics
