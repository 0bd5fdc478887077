#include "mjforge/validate/describe.h"

#include <string_view>
#include <vector>

#include "mjforge/compiled/compiled.h"

namespace mjforge::validate {
namespace {

/// The names of what stands beside the bodies.
void DescribeElements(const mjModel& m, CompiledModel& described) {
  struct Kind {
    std::string_view kind;
    const int* names;
    int count;
  };
  const Kind kinds[] = {
      {"camera", m.name_camadr, m.ncam},      {"light", m.name_lightadr, m.nlight},
      {"pair", m.name_pairadr, m.npair},      {"exclude", m.name_excludeadr, m.nexclude},
      {"equality", m.name_eqadr, m.neq},      {"tendon", m.name_tendonadr, m.ntendon},
      {"actuator", m.name_actuatoradr, m.nu}, {"sensor", m.name_sensoradr, m.nsensor}};
  for (const Kind& kind : kinds) {
    for (int i = 0; i < kind.count; ++i) {
      described.elements.push_back({std::string(kind.kind), m.names + kind.names[i]});
    }
  }
}

}  // namespace

CompiledModel Describe(const mjModel& m) {
  CompiledModel described;
  described.object = compiled::ObjectOf(m, {}, compiled::Nameless::kEmpty);
  described.body_geoms.assign(m.body_geomnum + 1, m.body_geomnum + m.nbody);
  described.joints = m.njnt;
  described.geoms = m.ngeom;
  described.sites = m.nsite;
  DescribeElements(m, described);
  return described;
}

}  // namespace mjforge::validate
