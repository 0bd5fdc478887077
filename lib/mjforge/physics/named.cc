#include "mjforge/physics/named.h"

#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/physics/added.h"

namespace mjforge::physics {

std::string OwnName(const mjModel& m, mjtObj kind, int id, std::string_view object) {
  std::string name = compiled::NameOf(m, kind, id);
  const std::string prefix = std::string(object) + "_";
  if (name.starts_with(prefix)) name.erase(0, prefix.size());
  return name;
}

int FindNamed(const mjModel& m, mjtObj kind, std::string_view object, const std::string& own,
              const CheckPlace& place, Verdict& verdict) {
  for (const std::string& full : {fmt::format("{}_{}", object, own), own}) {
    const int id = mj_name2id(&m, kind, full.c_str());
    if (id >= 0) return id;
  }
  std::vector<std::string> names;
  for (int i = kind == mjOBJ_BODY ? 1 : 0; i < (kind == mjOBJ_BODY ? m.nbody : m.nsite); ++i) {
    const std::string name = OwnName(m, kind, i, object);
    if (!name.starts_with(kAddedPrefix)) names.push_back(name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  verdict.Error(diag::Code::kModelUnknownReference, place.mark,
                fmt::format("`{}`: the object has no {} '{}'", place.check,
                            kind == mjOBJ_BODY ? "body" : "site", own),
                diag::DidYouMean(own, known));
  return -1;
}

model::Pose SitePose(const mjData& d, int site) {
  mjtNum quat[4];
  mju_mat2Quat(quat, d.site_xmat + 9 * site);
  return compiled::PoseAt(d.site_xpos + 3 * site, quat, 0);
}

}  // namespace mjforge::physics
