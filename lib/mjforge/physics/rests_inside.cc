// Check for bodies that come to rest in each other: detects collisions of the pairs whose contacts
// MuJoCo ignores.
#include "mjforge/physics/model_checks.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/broad_phase.h"
#include "mjforge/physics/solid_geoms.h"

namespace mjforge::physics {
namespace {

using expr::RoundedText;

/// Contact bits of a geom: contype and conaffinity.
using Bits = std::pair<int, int>;

bool Match(const Bits& one, const Bits& two) {
  return (one.first & two.second) != 0 || (two.first & one.second) != 0;
}

Bits BitsOf(const mjModel& m, int geom) { return {m.geom_contype[geom], m.geom_conaffinity[geom]}; }

/// Returns true for a colliding geom that is not a plane or a height field.
/// Pairs of geoms whose contacts MuJoCo ignores because of `exclude` or their contact bits.
class IgnoredPairs {
 public:
  explicit IgnoredPairs(const mjModel& m) : m_(m) {
    for (int i = 0; i < m.nexclude; ++i) excluded_.insert(engine::ExcludedBodies(m, i));
    for (int i = 0; i < m.npair; ++i)
      paired_.insert(std::minmax({m.pair_geom1[i], m.pair_geom2[i]}));
  }

  /// Returns true if the model has no ignored pairs.
  bool empty() const {
    std::set<Bits> all;
    for (int geom = 0; geom < m_.ngeom; ++geom)
      if (IsSolid(m_, geom)) all.insert(BitsOf(m_, geom));
    const bool all_match = std::ranges::all_of(all, [&](const Bits& one) {
      return std::ranges::all_of(all, [&](const Bits& two) { return Match(one, two); });
    });
    return excluded_.empty() && all_match;
  }

  bool AreExcluded(int body1, int body2) const {
    return excluded_.contains(std::minmax({body1, body2}));
  }

  bool Contain(int geom1, int geom2) const {
    return (AreExcluded(m_.geom_bodyid[geom1], m_.geom_bodyid[geom2]) ||
            !Match(BitsOf(m_, geom1), BitsOf(m_, geom2))) &&
           !paired_.contains(std::minmax({geom1, geom2}));
  }

 private:
  const mjModel& m_;
  std::set<std::pair<int, int>> excluded_;  // pairs of bodies, the lower id first
  std::set<std::pair<int, int>> paired_;    // geoms of <pair>, the lower id first
};

/// Deepest contact between two groups of bodies. The bodies of each group are welded to each other.
struct Penetration {
  double depth = 0;  // m
  int body1 = 0;     // lower id than body2
  int body2 = 0;
};
/// Penetrations of pairs of groups. Key: body_weldid of the two groups, the lower id first.
using Penetrations = std::map<std::pair<int, int>, Penetration>;

/// Returns true if the parent of `body` is `parent` or is welded to `parent`; bodies welded to
/// `body` count as `body`. MuJoCo lets parent and child collide only if the parent is fixed to the
/// world.
bool IsParent(const mjModel& m, int parent, int body) {
  return m.body_weldid[m.body_parentid[m.body_weldid[body]]] == m.body_weldid[parent];
}

/// Returns a copy of the model in which all solid geoms have matching contact bits, no other geoms
/// collide, and no bodies are excluded.
engine::Model WithAllContacts(const mjModel& m) {
  engine::Model copy(mj_copyModel(nullptr, &m));
  copy->nexclude = 0;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    copy->geom_contype[geom] = copy->geom_conaffinity[geom] = IsSolid(m, geom) ? 1 : 0;
    engine::UpdateCollisionData(*copy, geom);
  }
  return copy;
}

/// Returns the penetrations of the pairs in `ignored` at the positions `qpos` (nq numbers).
Penetrations Find(mjModel& m, const IgnoredPairs& ignored, std::span<const mjtNum> qpos,
                  Workspace& workspace) {
  BroadPhase broad_phase(m);
  return Simulate(m, workspace, [&](mjData& d) {
    std::ranges::copy(qpos, d.qpos);
    compiled::UpdatePoses(m, d);
    broad_phase.Collide(m, d);
    Penetrations found;
    for (const mjContact& contact : ContactsOf(d)) {
      if (!ignored.Contain(contact.geom1, contact.geom2)) continue;
      const auto [body1, body2] =
          std::minmax({m.geom_bodyid[contact.geom1], m.geom_bodyid[contact.geom2]});
      if (IsParent(m, body1, body2)) continue;  // may overlap, like an axle and its wheel
      Penetration& deepest = found[std::minmax({m.body_weldid[body1], m.body_weldid[body2]})];
      if (-contact.dist > deepest.depth) deepest = {-contact.dist, body1, body2};
    }
    return found;
  });
}

}  // namespace

void CheckRestsInside(const ModelTest& test, std::span<const mjtNum> rest) {
  const mjModel& m = test.m;
  const IgnoredPairs ignored(m);
  if (ignored.empty()) return;
  const engine::Model all = WithAllContacts(m);
  const Penetrations before = Find(*all, ignored, compiled::StartOf(m), test.workspace);
  for (const auto& [pair, deepest] : Find(*all, ignored, rest, test.workspace)) {
    const auto found = before.find(pair);
    const double start = found != before.end() ? found->second.depth : 0;
    if (!(deepest.depth > start + test.checks().joint_penetration)) continue;
    const std::string one = test.BodyName(deepest.body1);
    const std::string two = test.BodyName(deepest.body2);
    const bool are_excluded = ignored.AreExcluded(deepest.body1, deepest.body2);
    test.reporter.Warning(
        diag::Code::kPhysicsRestsInside, test.BodyMark(two),
        fmt::format(
            "bodies '{}' and '{}' come to rest {} mm in each other, and start {} mm in each "
            "other: {}",
            one, two, RoundedText(1000 * deepest.depth), RoundedText(1000 * start),
            are_excluded ? "their contact is excluded" : "their contact bits do not match"),
        are_excluded ? "let them collide: take them out of `contact: exclude`, and make room"
                     : "let them collide: look at `contype` and `conaffinity`");
  }
}

}  // namespace mjforge::physics
