// Looks up bodies, joints and sites that checks name, and reports unknown names.
#include "mjforge/physics/named_elements.h"

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {

std::string OwnName(const mjModel& m, mjtObj kind, int id, std::string_view object) {
  return std::string(model::OwnName(compiled::NameOf(m, kind, id), object));
}

std::vector<std::string> OwnNames(const mjModel& m, mjtObj kind, std::string_view object) {
  const int first = kind == mjOBJ_BODY ? 1 : 0;
  const int end = kind == mjOBJ_BODY ? m.nbody : kind == mjOBJ_JOINT ? m.njnt : m.nsite;
  std::vector<std::string> names;
  for (int i = first; i < end; ++i) {
    const std::string name = OwnName(m, kind, i, object);
    if (!name.starts_with(kProbePrefix)) names.push_back(name);
  }
  return names;
}

std::optional<int> IdOf(const mjModel& m, mjtObj kind, std::string_view object,
                        const std::string& name) {
  for (const std::string& full : {fmt::format("{}_{}", object, name), name}) {
    const int id = mj_name2id(&m, kind, full.c_str());
    if (id >= 0) return id;
  }
  return std::nullopt;
}

std::optional<int> FindNamed(const ProbeTest& test, mjtObj kind, const std::string& name,
                             const NamingCheck& check) {
  const std::optional<int> id = IdOf(test.m, kind, test.object.name, name);
  if (id) return id;
  const std::vector<std::string> names = OwnNames(test.m, kind, test.object.name);
  test.reporter.Error(diag::Code::kModelUnknownReference, check.mark,
                      fmt::format("`{}`: the object has no {} '{}'", check.key,
                                  kind == mjOBJ_BODY ? "body" : "site", name),
                      diag::DidYouMean(name, names));
  return std::nullopt;
}

model::Pose SitePose(const mjData& d, int site) {
  mjtNum quat[4];
  mju_mat2Quat(quat, d.site_xmat + 9 * site);
  return compiled::PoseAt(d.site_xpos + 3 * site, quat, 0);
}

}  // namespace mjforge::physics
