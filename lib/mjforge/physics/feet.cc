// Check of the feet of an object that stands on a floor: feet that do not reach the floor, and too
// little friction.
#include "mjforge/physics/model_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"

namespace mjforge::physics {
namespace {

using expr::RoundedText;

constexpr double kTouches = 0.0005;  // m; a part whose bottom is lower than this touches the floor
constexpr double kLifted = 0.001;    // m; a part whose bottom is this high or higher is lifted
constexpr double kHalf = 0.5;        // largest gap under a foot, as a share of the foot's height
constexpr double kAlike = 0.1;       // largest relative difference between sizes of similar parts

/// Part of the object, with all geoms (pieces) of which the part is made.
struct Foot {
  std::string name;
  diag::SourceMark mark;
  int type = 0;  // mjtGeom of the part's last piece
  int pieces = 0;
  double size = 0;    // m, largest geom_rbound of a piece
  double bottom = 0;  // m above the floor
  double top = 0;     // m above the floor

  double height() const { return top - bottom; }
};

bool AreClose(double one, double two) { return std::abs(one - two) <= kAlike * std::max(one, two); }

bool AreAlike(const Foot& one, const Foot& two) {
  return one.type == two.type && one.pieces == two.pieces && AreClose(one.size, two.size) &&
         AreClose(one.height(), two.height());
}

/// Returns the parts with colliding geoms in a tree of bodies. Heights are relative to the floor,
/// which is at `height`, m.
std::vector<Foot> FeetOf(const ModelTest& test, const mjData& d, int root, double height) {
  const mjModel& m = test.m;
  std::map<std::pair<int, std::string>, Foot> feet;  // key: body and part name
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const int body = m.geom_bodyid[geom];
    if (m.body_rootid[body] != root || !compiled::Collides(m, geom)) continue;
    const model::Box3 box = compiled::GeomBox(m, geom, compiled::GeomPose(d, geom));
    if (box.empty()) continue;
    std::string name = compiled::NameOf(m, mjOBJ_GEOM, geom);
    const model::Part* const part = test.PartOf(name);
    if (part != nullptr) name = part->NameInSpec();
    Foot& foot = feet[{body, name}];
    if (foot.pieces == 0) foot.bottom = foot.top = box.min.z() - height;
    foot.name = name;
    foot.mark = test.PartMark(part);
    foot.type = m.geom_type[geom];
    ++foot.pieces;
    foot.size = std::max(foot.size, m.geom_rbound[geom]);
    foot.bottom = std::min(foot.bottom, box.min.z() - height);
    foot.top = std::max(foot.top, box.max.z() - height);
  }
  std::vector<Foot> all;
  all.reserve(feet.size());
  for (auto& [key, foot] : feet) all.push_back(std::move(foot));
  return all;
}

/// Returns a part on the floor that is similar to a lifted part. Returns null if fewer than two
/// similar parts are on the floor, or if more similar parts are in the air than on the floor,
/// because such parts may be pieces of a curved runner.
const Foot* LikeOnFloor(const std::vector<Foot>& feet, const Foot& lifted) {
  const Foot* like = nullptr;
  int on_floor = 0;
  int in_air = 0;
  for (const Foot& foot : feet) {
    if (!AreAlike(lifted, foot)) continue;
    if (foot.bottom < kTouches) {
      ++on_floor;
      like = &foot;
    } else if (foot.bottom >= kLifted) {
      ++in_air;
    }
  }
  return on_floor >= 2 && on_floor >= in_air ? like : nullptr;
}

void CheckLifted(const ModelTest& test, const std::vector<Foot>& feet) {
  const Foot* highest = nullptr;
  const Foot* like = nullptr;
  for (const Foot& foot : feet) {
    if (foot.bottom < kLifted || foot.bottom > kHalf * foot.height()) continue;
    if (highest != nullptr && foot.bottom <= highest->bottom) continue;
    const Foot* const found = LikeOnFloor(feet, foot);
    if (found == nullptr) continue;
    highest = &foot;
    like = found;
  }
  if (highest == nullptr) return;
  test.reporter.Warning(
      diag::Code::kPhysicsFeet, highest->mark,
      fmt::format("part '{}' is {} mm above the floor where '{}' rests, which must be stable; part "
                  "'{}', which is like it, stands on the floor",
                  highest->name, RoundedText(1000 * highest->bottom), test.object.name, like->name),
      "let all feet reach the floor: look at their `pos` and sizes");
}

/// Returns the friction coefficient of the contacts between a tree of bodies and the floor,
/// weighted by normal force; nullopt if no contact carries a load.
std::optional<double> FrictionOf(const mjModel& m, const mjData& d, int root) {
  double load = 0;
  double most = 0;  // N, sum of the friction forces that the contacts can bear
  for (int i = 0; i < d.ncon; ++i) {
    const mjContact& contact = d.contact[i];
    const int one = m.body_rootid[m.geom_bodyid[contact.geom1]];
    const int two = m.body_rootid[m.geom_bodyid[contact.geom2]];
    if (std::minmax({one, two}) != std::pair(0, root)) continue;
    mjtNum force[6];
    mj_contactForce(&m, &d, i, force);
    load += force[0];
    if (contact.dim > 1) most += force[0] * contact.friction[0];
  }
  return load > 0 ? std::optional(most / load) : std::nullopt;
}

void CheckGlides(const ModelTest& test, const mjData& d, int root) {
  // Tests slopes of up to 45 degrees only, because friction of 1, the friction of the floor, holds
  // no object on a steeper slope.
  const double slope = std::min(test.checks().nudge, std::numbers::pi / 4);
  const std::optional<double> friction = FrictionOf(test.m, d, root);
  if (!friction || *friction >= std::tan(slope)) return;
  test.reporter.Warning(
      diag::Code::kPhysicsFeet, test.mark,
      fmt::format("'{}', which must be stable, glides off a floor that leans by {} deg: "
                  "the friction of its feet is {}, and must be {}",
                  test.object.name, RoundedText(slope * 180 / std::numbers::pi),
                  RoundedText(*friction), RoundedText(std::tan(slope))),
      "give them more friction; with a `priority` theirs counts, whatever the floor has");
}

}  // namespace

void CheckFeet(const ModelTest& test, const mjData& d, int root, double height) {
  CheckLifted(test, FeetOf(test, d, root, height));
  CheckGlides(test, d, root);
}

}  // namespace mjforge::physics
