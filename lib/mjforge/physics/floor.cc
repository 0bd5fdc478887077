#include "mjforge/physics/floor.h"

#include <algorithm>
#include <array>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {
namespace {

constexpr double kClearance = 0.002;  // m

template <std::size_t n>
void Set(mjtNum* numbers, int id, const std::array<double, n>& values) {
  std::ranges::copy(values, numbers + static_cast<std::ptrdiff_t>(n) * id);
}

/// The lowest point of all that can collide; planes have none.
double LowestPoint(const mjModel& m) {
  const compiled::Data d = compiled::MakeData(m);
  mj_kinematics(&m, d.get());
  const model::Box3 box = compiled::CollidingBox(m, *d, 0);
  return box.empty() ? 0 : box.min.z();
}

}  // namespace

double DropHeight(const mjModel& m) {
  double margin = 0;
  for (int i = 0; i < m.ngeom; ++i) margin = std::max(margin, m.geom_margin[i]);
  return kClearance + margin;
}

void LevelFloor(mjModel& m, int geom) {
  m.geom_contype[geom] = m.geom_conaffinity[geom] = 1;
  m.geom_condim[geom] = 3;
  m.geom_priority[geom] = 0;
  m.geom_solmix[geom] = 1;
  m.geom_margin[geom] = m.geom_gap[geom] = 0;
  Set<3>(m.geom_friction, geom, {1, 0.005, 0.0001});
  Set<mjNREF>(m.geom_solref, geom, {0.02, 1});
  Set<mjNIMP>(m.geom_solimp, geom, {0.9, 0.95, 0.001, 0.5, 2});
  Set<4>(m.geom_quat, geom, {1, 0, 0, 0});
  m.geom_sameframe[geom] = 0;
  Set<3>(m.geom_pos, geom, {0, 0, LowestPoint(m) - DropHeight(m)});
}

}  // namespace mjforge::physics
