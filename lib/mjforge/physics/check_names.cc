// Names of bodies and sites in checks: lookup, and the finding for an unknown name.
#include "mjforge/physics/check_names.h"

#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {

std::string OwnName(const mjModel& m, mjtObj kind, int id, std::string_view object) {
  return std::string(static_checks::OwnName(compiled::NameOf(m, kind, id), object));
}

std::optional<int> FindNamed(const ProbeTest& test, mjtObj kind, const std::string& name,
                             const NamingCheck& check) {
  const mjModel& m = test.m;
  for (const std::string& full : {fmt::format("{}_{}", test.object, name), name}) {
    const int id = mj_name2id(&m, kind, full.c_str());
    if (id >= 0) return id;
  }
  std::vector<std::string> names;
  for (int i = kind == mjOBJ_BODY ? 1 : 0; i < (kind == mjOBJ_BODY ? m.nbody : m.nsite); ++i) {
    const std::string own = OwnName(m, kind, i, test.object);
    if (!own.starts_with(kProbePrefix)) names.push_back(own);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  test.reporter.Error(diag::Code::kModelUnknownReference, check.mark,
                      fmt::format("`{}`: the object has no {} '{}'", check.key,
                                  kind == mjOBJ_BODY ? "body" : "site", name),
                      diag::DidYouMean(name, known));
  return std::nullopt;
}

model::Pose SitePose(const mjData& d, int site) {
  mjtNum quat[4];
  mju_mat2Quat(quat, d.site_xmat + 9 * site);
  return compiled::PoseAt(d.site_xpos + 3 * site, quat, 0);
}

}  // namespace mjforge::physics
