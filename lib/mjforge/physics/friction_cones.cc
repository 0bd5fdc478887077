// Check for large friction coefficients, which make contacts soft if the friction cones are
// pyramidal.
#include "mjforge/physics/model_checks.h"

#include <string>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"

namespace mjforge::physics {
namespace {

constexpr double kMostFriction = 2;

}  // namespace

void CheckFrictionCones(const ModelTest& test) {
  const mjModel& m = test.m;
  if (m.opt.cone != mjCONE_PYRAMIDAL) return;
  int roughest = -1;
  double most = kMostFriction;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    if (!compiled::Collides(m, geom) || m.geom_friction[3 * geom] <= most) continue;
    most = m.geom_friction[3 * geom];
    roughest = geom;
  }
  if (roughest < 0) return;
  const std::string name = compiled::NameOf(m, mjOBJ_GEOM, roughest);
  const model::Part* const part = test.PartOf(name);
  // The depths in the message were measured with hammers; docs/physics.md has the table.
  test.reporter.Warning(
      diag::Code::kPhysicsFriction, test.PartMark(part),
      fmt::format("part '{}' has a friction of {}, more than {}: MuJoCo's pyramidal cones make a "
                  "contact the softer the more friction it has; hammers rest 0.16 mm deep with 1, "
                  "1.7 mm with 3 and 12 mm with 5",
                  part != nullptr ? part->NameInSpec() : name, expr::RoundedText(most),
                  expr::RoundedText(kMostFriction)),
      "use less, or `mjcf: {option: {cone: elliptic, impratio: 20}}`, and the same in the host's "
      "file");
}

}  // namespace mjforge::physics
