// Simulation of piles: release of one body after the other, rest, and the faults of a pile.
#include "mjforge/physics/pile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/probe_bodies.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/stepper.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {
namespace {

using compiled::VectorAt;
using diag::Code;
using expr::RoundedText;

constexpr double kClearance = 0.005;  // m, between a body at its release and all below it
// A body is released when the one before it is slower than this, because bodies that fall on fast
// ones throw each other out; at the latest after kPatience.
constexpr double kSlow = 0.3;            // m/s
constexpr double kFall = 0.05;           // s, in which a released body gets faster than kSlow
constexpr double kPatience = 0.5;        // s
constexpr double kRestSpeed = 0.01;      // m/s
constexpr double kRestTime = 0.1;        // s, for which all bodies must be slow to be at rest
constexpr double kEdge = 0.001;          // m, that a centre of mass may be outside of the region
constexpr double kLargeMassRatio = 100;  // at which contacts of MuJoCo get soft

/// A body of a pile in the compiled model.
struct PiledBody {
  const model::Pile::Item* item = nullptr;
  int id = 0;
  double radius = 0;                                // m, sphere around the centre of mass
  Eigen::Vector3d p_BCm = Eigen::Vector3d::Zero();  // centre of mass of its tree
};

/// Returns true if a body is in the tree of a root.
bool IsIn(const mjModel& m, int body, int root) { return m.body_rootid[body] == root; }

/// Releases the bodies of one pile, while all other bodies are held.
class PileSimulation {
 public:
  PileSimulation(mjModel& m, mjData& d, const model::Pile& pile, std::vector<PiledBody> bodies,
                 const model::Pose& X_WR)
      : m_(m), d_(d), pile_(pile), X_WR_(X_WR), bodies_(std::move(bodies)) {}

  /// Returns true if the bodies came to rest.
  bool Run() {
    Hold();
    Park();
    for (const PiledBody& body : bodies_) {
      Release(body);
      const double start = d_.time;
      do {
        Step();
      } while (CanGoOn() && d_.time < start + kPatience &&
               (d_.time < start + kFall || SpeedOf(body) > kSlow));
    }
    const double end = d_.time + pile_.time;
    double slow_since = d_.time;
    while (CanGoOn() && d_.time < end && d_.time - slow_since < kRestTime) {
      Step();
      if (FindFastestBody(m_, d_).speed > kRestSpeed) slow_since = d_.time;
    }
    mj_forward(&m_, &d_);
    return d_.time - slow_since >= kRestTime;
  }

 private:
  bool CanGoOn() const { return !HasDiverged(d_) && !IsCrowded(d_); }

  bool IsReleased(int body) const {
    const auto end = bodies_.begin() + static_cast<std::ptrdiff_t>(released_);
    return std::any_of(bodies_.begin(), end,
                       [&](const PiledBody& piled) { return IsIn(m_, body, piled.id); });
  }

  bool IsPiled(int body) const {
    return std::ranges::any_of(bodies_,
                               [&](const PiledBody& piled) { return IsIn(m_, body, piled.id); });
  }

  /// Makes all other bodies too heavy to be moved.
  void Hold() {
    for (int dof = 0; dof < m_.nv; ++dof) {
      if (!IsPiled(m_.dof_bodyid[dof])) HoldDof(m_, dof);
    }
    mj_kinematics(&m_, &d_);
    mj_comPos(&m_, &d_);
  }

  /// Puts all bodies of the pile above each other, higher than the pile can get.
  void Park() {
    double height = X_WR_.p.z();
    for (const PiledBody& body : bodies_) height += 2 * body.radius;
    const model::Box3 all = compiled::CollidingBox(m_, d_, 0);
    if (!all.empty()) height = std::max(height, all.max.z() + 2 * bodies_.front().radius);
    parked_ = height;
    for (const PiledBody& body : bodies_) {
      height += body.radius + kClearance;
      MoveTo(body, {0, 0}, height);
      height += body.radius;
    }
    held_.assign(d_.qpos, d_.qpos + m_.nq);
  }

  /// Moves the centre of mass of a body to a height, above a point of the region.
  void MoveTo(const PiledBody& body, const Eigen::Vector2d& p_R, double height) {
    Eigen::Vector3d p = X_WR_ * Eigen::Vector3d(p_R.x(), p_R.y(), 0);
    p.z() = height;
    mjtNum* qpos = d_.qpos + m_.jnt_qposadr[m_.body_jntadr[body.id]];
    compiled::WritePose({p - body.item->q * body.p_BCm, body.item->q}, qpos, qpos + 3);
  }

  void Release(const PiledBody& body) {
    double top = X_WR_.p.z();
    mj_kinematics(&m_, &d_);
    for (std::size_t i = 0; i < released_; ++i) {
      const model::Box3 box = compiled::CollidingBox(m_, d_, bodies_[i].id);
      if (!box.empty()) top = std::max(top, box.max.z());
    }
    ++released_;
    const Eigen::Vector2d p_R = model::PositionOfDisc(pile_.region, body.radius, body.item->uv);
    double height = top + body.radius + kClearance;
    MoveTo(body, p_R, height);
    // Posts and sloping walls may stand in the region.
    for (; Touches(body) && height < parked_; height += body.radius / 2) MoveTo(body, p_R, height);
    stepper_.emplace(m_, d_);
  }

  bool Touches(const PiledBody& body) {
    mj_fwdPosition(&m_, &d_);
    return std::any_of(d_.contact, d_.contact + d_.ncon, [&](const mjContact& contact) {
      return IsIn(m_, m_.geom_bodyid[contact.geom1], body.id) !=
             IsIn(m_, m_.geom_bodyid[contact.geom2], body.id);
    });
  }

  void Step() {
    stepper_->Step();
    for (int joint = 0; joint < m_.njnt; ++joint) {
      if (IsReleased(m_.jnt_bodyid[joint])) continue;
      constexpr int kPositions[] = {7, 4, 1, 1};  // in the order of mjtJoint
      constexpr int kVelocities[] = {6, 3, 1, 1};
      const auto type = compiled::Index(m_.jnt_type[joint]);
      std::copy_n(held_.begin() + m_.jnt_qposadr[joint], kPositions[type],
                  d_.qpos + m_.jnt_qposadr[joint]);
      std::fill_n(d_.qvel + m_.jnt_dofadr[joint], kVelocities[type], 0.0);
    }
  }

  double SpeedOf(const PiledBody& body) const {
    return Eigen::Map<const Eigen::Vector3d>(d_.qvel + m_.body_dofadr[body.id]).norm();
  }

  mjModel& m_;
  mjData& d_;
  const model::Pile& pile_;
  model::Pose X_WR_;
  std::vector<PiledBody> bodies_;  // in the order of their release
  std::size_t released_ = 0;
  double parked_ = 0;         // m, height above which bodies wait
  std::vector<mjtNum> held_;  // qpos of bodies that are not released
  std::optional<Stepper> stepper_;
};

/// Adds findings about the faults of a pile.
class PileReport {
 public:
  PileReport(const mjModel& m, const mjData& d, const model::Object& object,
             const model::Pile& pile, const std::vector<PiledBody>& bodies,
             static_checks::Reporter& reporter)
      : m_(m), d_(d), object_(object), pile_(pile), bodies_(bodies), reporter_(reporter) {}

  void AddLeft(const model::Pose& X_WR) {
    for (const PiledBody& body : bodies_) {
      const Eigen::Vector3d p_R = X_WR.Inverse() * VectorAt(d_.subtree_com, body.id);
      const double outside = model::DistanceOutside(pile_.region, p_R.head<2>());
      if (outside <= kEdge && p_R.z() > 0) continue;
      reporter_.Error(Code::kPhysicsPileLeft, pile_.mark,
                      outside > kEdge ? fmt::format("'{}' lies {} mm outside of '{}'", NameOf(body),
                                                    RoundedText(1000 * outside), pile_.at)
                                      : fmt::format("'{}' lies below '{}'", NameOf(body), pile_.at),
                      "pile up fewer or smaller bodies, or in a deeper region");
    }
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
    for (int i = 0; i < d_.ncon; ++i) {
      const mjContact& contact = d_.contact[i];
      if (!Has(contact.geom1) && !Has(contact.geom2)) continue;
      if (deepest == nullptr || contact.dist < deepest->dist) deepest = &contact;
    }
    if (deepest == nullptr || -deepest->dist <= model::Pile::kMostDepth) return;
    const int first = m_.geom_bodyid[deepest->geom1];
    const int second = m_.geom_bodyid[deepest->geom2];
    reporter_.Error(
        Code::kPhysicsPileDeep, pile_.mark,
        fmt::format("in the pile in '{}', '{}' ({} kg) and '{}' ({} kg) are {} mm in each other",
                    pile_.at, OwnName(first), RoundedText(MassOfTree(first)), OwnName(second),
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
    return std::string(
        static_checks::OwnName(compiled::NameOf(m_, mjOBJ_BODY, body), object_.name));
  }
  std::string NameOf(const PiledBody& body) const { return OwnName(body.id); }

  const mjModel& m_;
  const mjData& d_;
  const model::Object& object_;
  const model::Pile& pile_;
  const std::vector<PiledBody>& bodies_;
  static_checks::Reporter& reporter_;
};

}  // namespace

struct PileSettler::Impl {
  engine::Engine engine;
  Workspace workspace;

  void Settle(model::Object& object, const model::Pile& pile, static_checks::Reporter& reporter);
};

PileSettler::PileSettler() : impl_(std::make_unique<Impl>()) {}
PileSettler::~PileSettler() = default;

namespace {

/// Returns the ids in MuJoCo of the bodies of an object.
std::vector<int> IdsOf(const model::Object& object) {
  std::vector<int> ids(object.bodies.size());
  int id = 0;
  for (const int body : mjcf::DepthFirstOrder(object)) ids[static_cast<std::size_t>(body)] = ++id;
  return ids;
}

/// Returns the bodies of a pile in the order of their release. Needs the poses of mj_kinematics and
/// mj_comPos.
std::vector<PiledBody> BodiesOf(const mjModel& m, const mjData& d, const model::Pile& pile,
                                const std::vector<int>& ids) {
  std::vector<PiledBody> bodies;
  for (const model::Pile::Item& item : pile.items) {
    PiledBody body = {&item, ids[static_cast<std::size_t>(item.body)]};
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

/// Makes the poses and joint positions of a simulation the start of a body and all below it.
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

void PileSettler::Impl::Settle(model::Object& object, const model::Pile& pile,
                               static_checks::Reporter& reporter) {
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(object, mjcf::Target::kMujoco, {}, document);
  const engine::Loaded loaded = engine.LoadText(document.text, document.assets);
  if (!loaded.model) {
    reporter.Error(Code::kMujocoError, pile.mark,
                   fmt::format("MuJoCo refused the object with a pile: {}",
                               engine::ParseRefusal(loaded.error).reason));
    return;
  }
  mjModel& m = *loaded.model;
  const std::vector<int> ids = IdsOf(object);
  std::vector<PiledBody> bodies;
  model::Pose X_WR;
  mjData* end = nullptr;
  const bool rests = Simulate(m, workspace, [&](mjData& d) {
    end = &d;
    std::ranges::copy(compiled::StartOf(m), d.qpos);
    mj_kinematics(&m, &d);
    mj_comPos(&m, &d);
    bodies = BodiesOf(m, d, pile, ids);
    X_WR = compiled::PoseAt(d.xpos, d.xquat, ids[static_cast<std::size_t>(pile.support)]) *
           pile.region.X_BR;
    return PileSimulation(m, d, pile, bodies, X_WR).Run();
  });
  if (HasDiverged(*end)) {
    reporter.Error(Code::kPhysicsUnstable, pile.mark,
                   fmt::format("the simulation of the pile in '{}' diverges", pile.at),
                   "use a smaller timestep, or softer contacts");
    return;
  }
  PileReport report(m, *end, object, pile, bodies, reporter);
  report.AddLeft(X_WR);
  if (!rests) report.AddMoving();
  report.AddDeep();
  for (const PiledBody& body : bodies) TakeStart(m, *end, ids, body.id, object);
}

bool PileSettler::Settle(model::Object& object, diag::Findings& findings) {
  const std::size_t before = findings.size();
  static_checks::Reporter reporter(object.checks, findings);
  for (const model::Pile& pile : object.piles) {
    try {
      impl_->Settle(object, pile, reporter);
    } catch (const std::bad_alloc&) {
      throw;  // MuJoCo did not fail
    } catch (const std::exception& error) {
      findings.Add(Code::kMujocoError, pile.mark,
                   fmt::format("MuJoCo cannot simulate the pile in '{}': {}", pile.at,
                               engine::OneLine(error.what())));
    }
  }
  return !findings.HasErrors(before);
}

}  // namespace mjforge::physics
