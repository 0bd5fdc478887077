// Settles piles: simulates releases until one has no fault, and makes the poses at rest the start
// poses of the bodies.
#include "mjforge/physics/pile.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/physics/pile_simulation.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {
namespace {

using compiled::VectorAt;
using diag::Code;
using expr::RoundedText;

// Largest number of releases that are tried for a pile. Each try assigns the release poses to other
// bodies.
constexpr std::size_t kMostTries = 4;
constexpr double kEdge = 0.001;  // m, distance by which a centre of mass may be outside the region
constexpr double kLargeMassRatio = 100;  // mass ratio from which MuJoCo's contacts are too soft

/// Returns true if a body belongs to the tree of bodies with this root.
bool IsIn(const mjModel& m, int body, int root) { return m.body_rootid[body] == root; }

/// Adds findings about the faults of a pile.
class PileReport {
 public:
  PileReport(const mjModel& m, const mjData& d, const model::Object& object,
             const model::Pile& pile, const std::vector<PiledBody>& bodies,
             static_checks::Reporter& reporter)
      : m_(m), d_(d), object_(object), pile_(pile), bodies_(bodies), reporter_(reporter) {}

  /// Adds an error for each body that left the region; returns true if it adds an error.
  bool AddLeft(const model::Pose& X_WR) {
    bool has_left = false;
    for (const PiledBody& body : bodies_) {
      const Eigen::Vector3d p_R = X_WR.Inverse() * VectorAt(d_.subtree_com, body.id);
      const double outside = model::DistanceOutside(pile_.region, p_R.head<2>());
      std::string where;
      if (outside > kEdge) {
        where = fmt::format("{} mm outside of", RoundedText(1000 * outside));
      } else if (p_R.z() <= 0) {
        where = "below";
      } else if (p_R.z() > pile_.region.height) {
        where = "above the `height` of";
      } else {
        continue;
      }
      has_left = true;
      reporter_.Error(Code::kPhysicsPileLeft, pile_.mark,
                      fmt::format("'{}' lies {} '{}'", NameOf(body), where, pile_.at),
                      "pile up fewer or smaller bodies, or in a deeper region");
    }
    return has_left;
  }

  void AddMoving() {
    const FastestBody fastest = FindFastestBody(m_, d_);
    const auto heavier = [&](const PiledBody& a, const PiledBody& b) { return Mass(a) < Mass(b); };
    const auto [light, heavy] = std::ranges::minmax_element(bodies_, heavier);
    const double ratio = Mass(*heavy) / Mass(*light);
    reporter_.Error(
        Code::kPhysicsPileMoves, pile_.mark,
        fmt::format("the pile in '{}' is not at rest after {:g} s: '{}' moves at {}", pile_.at,
                    pile_.time, OwnName(fastest.body), expr::SpeedText(fastest.speed)),
        ratio > kLargeMassRatio
            ? fmt::format("'{}' has {} times the mass of '{}', which MuJoCo's contacts can hardly "
                          "carry",
                          NameOf(*heavy), RoundedText(ratio), NameOf(*light))
            : "give it more `time`, more friction, or fewer round bodies");
  }

  void AddDeep() {
    const mjContact* deepest = nullptr;
    for (const mjContact& contact : ContactsOf(d_)) {
      if (!Has(contact.geom1) && !Has(contact.geom2)) continue;
      if (deepest == nullptr || contact.dist < deepest->dist) deepest = &contact;
    }
    if (deepest == nullptr || -deepest->dist <= model::Pile::kMostDepth) return;
    const int first = m_.geom_bodyid[deepest->geom1];
    const int second = m_.geom_bodyid[deepest->geom2];
    reporter_.Error(
        Code::kPhysicsPileDeep, pile_.mark,
        fmt::format("in the pile in '{}', '{}' ({} kg) and '{}' ({} kg) overlap by {} mm", pile_.at,
                    OwnName(first), RoundedText(MassOfTree(first)), OwnName(second),
                    RoundedText(MassOfTree(second)), RoundedText(-1000 * deepest->dist)),
        "make the masses more alike, or the contacts harder: a smaller solref, solimp closer to 1");
  }

 private:
  double Mass(const PiledBody& body) const { return m_.body_subtreemass[body.id]; }
  double MassOfTree(int body) const { return m_.body_subtreemass[m_.body_rootid[body]]; }
  bool Has(int geom) const {
    return std::ranges::any_of(
        bodies_, [&](const PiledBody& body) { return IsIn(m_, m_.geom_bodyid[geom], body.id); });
  }
  std::string OwnName(int body) const {
    return physics::OwnName(m_, mjOBJ_BODY, body, object_.name);
  }
  std::string NameOf(const PiledBody& body) const { return OwnName(body.id); }

  const mjModel& m_;
  const mjData& d_;
  const model::Object& object_;
  const model::Pile& pile_;
  const std::vector<PiledBody>& bodies_;
  static_checks::Reporter& reporter_;
};

/// Returns the ids in MuJoCo of the bodies of an object.
std::vector<int> IdsOf(const model::Object& object) {
  std::vector<int> ids(object.bodies.size());
  int id = 0;
  for (const int body : mjcf::DepthFirstOrder(object)) ids[static_cast<std::size_t>(body)] = ++id;
  return ids;
}

/// Moves the bodies of all piles far from each other. Before the simulation the bodies of a pile
/// overlap, and MuJoCo's buffers would be sized for the contacts between them.
void Separate(model::Object& object) {
  constexpr double kApart = 100;  // m
  double height = 0;
  for (const model::Pile& pile : object.piles) {
    for (const auto& item : pile.items)
      object.bodies[static_cast<std::size_t>(item.body)].X_PB.p.z() += height += kApart;
  }
}

/// Returns the bodies of a pile in the order in which they are released. `release` is the number of
/// the try, from 0. Needs the poses that mj_kinematics and mj_comPos compute.
std::vector<PiledBody> BodiesOf(const mjModel& m, const mjData& d, const model::Pile& pile,
                                std::size_t release, const std::vector<int>& ids) {
  std::vector<PiledBody> bodies;
  for (std::size_t i = 0; i < pile.items.size(); ++i) {
    PiledBody body;
    body.id = ids[static_cast<std::size_t>(pile.items[i].body)];
    body.release = &pile.items[(i + release) % pile.items.size()];
    const Eigen::Vector3d p_WCm = VectorAt(d.subtree_com, body.id);
    for (int geom = 0; geom < m.ngeom; ++geom) {
      if (!IsIn(m, m.geom_bodyid[geom], body.id) || !compiled::Collides(m, geom)) continue;
      body.radius =
          std::max(body.radius, (VectorAt(d.geom_xpos, geom) - p_WCm).norm() + m.geom_rbound[geom]);
    }
    body.p_BCm = compiled::PoseAt(d.xpos, d.xquat, body.id).Inverse() * p_WCm;
    bodies.push_back(body);
  }
  if (pile.is_big_first)
    std::ranges::stable_sort(bodies, std::ranges::greater(), &PiledBody::radius);
  return bodies;
}

/// Makes the present poses and joint positions in `d` the start of the body `root` and of all its
/// descendants.
void TakeStart(const mjModel& m, const mjData& d, const std::vector<int>& ids, int root,
               model::Object& object) {
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    if (!IsIn(m, ids[i], root)) continue;
    model::Body& body = object.bodies[i];
    for (std::size_t j = 0; j < body.joints.size(); ++j) {
      const mjtNum* qpos = d.qpos + m.jnt_qposadr[m.body_jntadr[ids[i]] + static_cast<int>(j)];
      if (body.joints[j].type == "free") {
        body.X_PB = compiled::PoseAt(qpos, qpos + 3, 0);
        body.X_PB.q.normalize();
      } else {
        body.joints[j].start.assign(qpos, qpos + (body.joints[j].type == "ball" ? 4 : 1));
      }
    }
  }
}

}  // namespace

struct PileSettler::Impl {
  engine::Engine engine;
  Workspace workspace;

  /// Simulates releases of a pile until one has no fault; adds findings about the faults of the
  /// last release.
  void Settle(model::Object& object, const model::Pile& pile, diag::Findings& findings) {
    mjcf::MjcfDocument document;
    mjcf::WriteMjcf(object, mjcf::Target::kMujoco, {}, document);
    const engine::Loaded loaded = engine.LoadText(document.text, document.assets);
    if (!loaded.model) {
      findings.Add(Code::kMujocoError, pile.mark,
                   fmt::format("MuJoCo refused the object with a pile: {}",
                               engine::ParseRefusal(loaded.error).reason));
      return;
    }
    const std::vector<int> ids = IdsOf(object);
    diag::Findings faults;
    for (std::size_t release = 0; release < std::min(kMostTries, pile.items.size()); ++release) {
      faults.clear();
      static_checks::Reporter reporter(object.checks, faults);
      if (!Try(release, *loaded.model, ids, object, pile, reporter)) {
        faults.Add(Code::kPhysicsUnstable, pile.mark,
                   fmt::format("the simulation of the pile in '{}' diverges", pile.at),
                   "use a smaller timestep, or softer contacts");
      }
      if (!faults.HasErrors()) break;
    }
    for (const diag::Finding& fault : faults) findings.Add(fault);
  }

  /// Simulates one release, and makes the poses at the end the start of the bodies. Reports faults
  /// to `reporter`. Returns false, and changes no start, if the simulation diverges.
  bool Try(std::size_t release, mjModel& m, const std::vector<int>& ids, model::Object& object,
           const model::Pile& pile, static_checks::Reporter& reporter) {
    std::vector<PiledBody> bodies;
    model::Pose X_WR;
    mjData* end = nullptr;
    const bool rests = Simulate(m, workspace, [&](mjData& d) {
      end = &d;
      compiled::CopyStart(m, d);
      compiled::UpdatePoses(m, d);
      bodies = BodiesOf(m, d, pile, release, ids);
      X_WR = compiled::PoseAt(d.xpos, d.xquat, ids[static_cast<std::size_t>(pile.support)]) *
             pile.region.X_BR;
      return SimulatePile(m, d, pile, bodies, X_WR);
    });
    if (HasDiverged(*end)) return false;
    PileReport report(m, *end, object, pile, bodies, reporter);
    // Reports no motion if a body left the region, because that body may still fall.
    if (!report.AddLeft(X_WR) && !rests) report.AddMoving();
    report.AddDeep();
    for (const PiledBody& body : bodies) TakeStart(m, *end, ids, body.id, object);
    return true;
  }
};

PileSettler::PileSettler() : impl_(std::make_unique<Impl>()) {}
PileSettler::~PileSettler() = default;

bool PileSettler::Settle(model::Object& object, diag::Findings& findings) {
  const std::size_t before = findings.size();
  Separate(object);
  for (const model::Pile& pile : object.piles) {
    const std::optional<std::string> failure =
        engine::FailureOf([&] { impl_->Settle(object, pile, findings); });
    if (failure) {
      findings.Add(Code::kMujocoError, pile.mark,
                   fmt::format("MuJoCo cannot simulate the pile in '{}': {}", pile.at,
                               engine::OneLine(*failure)));
    }
  }
  return !findings.HasErrors(before);
}

}  // namespace mjforge::physics
