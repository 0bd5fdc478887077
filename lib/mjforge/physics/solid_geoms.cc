// Selects colliding geoms that have an inside, and casts rays to them.
#include "mjforge/physics/solid_geoms.h"

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"

namespace mjforge::physics {

bool IsSolid(const mjModel& m, int geom) {
  return compiled::Collides(m, geom) && compiled::GeomTypeOf(m.geom_type[geom]).has_value();
}

double RayTo(const mjModel& m, const mjData& d, int geom, const Eigen::Vector3d& from,
             const Eigen::Vector3d& way) {
  const int type = m.geom_type[geom];
  if (type == mjGEOM_MESH)
    return engine::CastRay(mj_rayMesh, &m, &d, geom, from.data(), way.data());
  return engine::CastRay(mju_rayGeom, d.geom_xpos + 3 * geom, d.geom_xmat + 9 * geom,
                         m.geom_size + 3 * geom, from.data(), way.data(), type);
}

}  // namespace mjforge::physics
