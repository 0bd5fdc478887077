// Searches a model for the causes of faults in a simulation, and writes texts of messages and
// hints.
#include "mjforge/physics/causes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/joint_couplings.h"
#include "mjforge/physics/joint_paths.h"

namespace mjforge::physics {
namespace {

using compiled::Moves;
using expr::RoundedText;

// Smallest motions of a hinge and of a slide that count as large.
constexpr double kFarHinge = 5 * std::numbers::pi / 180;  // rad
constexpr double kFarSlide = 0.005;                       // m
constexpr double kDeepStart = 0.002;  // m; a larger depth at the start pushes bodies apart fast

// Semi-implicit Euler diverges if (timestep * angular frequency)^2 exceeds 4, or damping removes
// more than twice the speed in a step.
constexpr double kMostSpring = 4;
constexpr double kMostDamping = 2;

bool IsSlide(const mjModel& m, int joint) { return m.jnt_type[joint] == mjJNT_SLIDE; }

std::string Name(const mjModel& m, mjtObj kind, int id) {
  return fmt::format("'{}'", compiled::NameOf(m, kind, id));
}

// Joins names to a text: "a, b, or c".
std::string Alternatives(std::span<const std::string> items) {
  if (items.size() == 1) return items.front();
  return fmt::format("{}{} or {}", fmt::join(items.first(items.size() - 1), ", "),
                     items.size() > 2 ? "," : "", items.back());
}

bool HasStartPose(const mjModel& m) {
  return !std::ranges::equal(compiled::StartOf(m), std::span(m.qpos0, compiled::Index(m.nq)));
}

// Finds the spring, damper or actuator that exceeds the limit of explicit integration most.
class UnstableElementSearch {
 public:
  explicit UnstableElementSearch(const mjModel& m) : m_(m), h_(m.opt.timestep) {
    for (int joint = 0; joint < m.njnt; ++joint) AddJoint(joint);
    for (int actuator = 0; actuator < m.nu; ++actuator) AddActuator(actuator);
    for (int tendon = 0; tendon < m.ntendon; ++tendon) AddTendon(tendon);
  }

  const std::optional<Divergence>& found() const { return found_; }

 private:
  std::string Step() const { return fmt::format("a timestep of {} ms", RoundedText(1000 * h_)); }

  // Stores an element (spring, damper or actuator) in found_ if it exceeds the limit of integration
  // more than all earlier elements. `excess` is relative to the limit: above 1, the simulation
  // diverges. The excess grows with the square of the timestep for springs, and with the timestep
  // for dampers.
  void Add(double excess, bool is_spring, const std::string& what, const std::string& remedy,
           std::string joint = {}, std::string actuator = {}) {
    // With implicit integrators only springs diverge, because these integrators use the velocity
    // after the step for damping.
    const bool is_explicit =
        m_.opt.integrator == mjINT_EULER || m_.opt.integrator == mjINT_RK4 || is_spring;
    if (!is_explicit || !(excess > 1) || excess <= excess_) return;
    excess_ = excess;
    const double most = h_ / (is_spring ? std::sqrt(excess) : excess);
    found_ = Divergence{
        fmt::format("{} is too {} for {}", what, is_spring ? "stiff" : "strong", Step()),
        fmt::format("{}, or use a timestep below {} ms", remedy, RoundedText(1000 * most, 2)),
        std::move(joint), std::move(actuator)};
  }

  void AddJoint(int joint) {
    const double inverse_mass = m_.dof_invweight0[m_.jnt_dofadr[joint]];
    const double excess = m_.jnt_stiffness[joint] * inverse_mass * h_ * h_ / kMostSpring;
    const std::string name = compiled::NameOf(m_, mjOBJ_JOINT, joint);
    Add(excess, true,
        fmt::format("the spring of joint '{}' of body {}", name,
                    Name(m_, mjOBJ_BODY, m_.jnt_bodyid[joint])),
        "lower its `stiffness`, give the joint an `armature` or the body more mass", name);
  }

  void AddActuator(int actuator) {
    const int type = m_.actuator_trntype[actuator];
    const int target = m_.actuator_trnid[2 * actuator];
    const bool is_of_joint = type == mjTRN_JOINT || type == mjTRN_JOINTINPARENT;
    if ((!is_of_joint && type != mjTRN_TENDON) || m_.actuator_biastype[actuator] != mjBIAS_AFFINE)
      return;
    const double gear = m_.actuator_gear[6 * actuator];
    const double mobility =
        gear * gear *
        (is_of_joint ? m_.dof_invweight0[m_.jnt_dofadr[target]] : m_.tendon_invweight0[target]);
    const mjtNum* const bias = m_.actuator_biasprm + mjNBIAS * actuator;
    const std::string name = compiled::NameOf(m_, mjOBJ_ACTUATOR, actuator);
    const auto gain = [&](double value) {
      return fmt::format("the gain of {} of actuator '{}' at {} {}", RoundedText(value), name,
                         is_of_joint ? "joint" : "tendon",
                         Name(m_, is_of_joint ? mjOBJ_JOINT : mjOBJ_TENDON, target));
    };
    const std::string remedy = "lower it, give the joint an `armature` or its body more mass";
    Add(-bias[1] * mobility * h_ * h_ / kMostSpring, true, gain(-bias[1]), remedy, {}, name);
    Add(-bias[2] * mobility * h_ / kMostDamping, false, gain(-bias[2]), remedy, {}, name);
  }

  void AddTendon(int tendon) {
    const double inverse_mass = m_.tendon_invweight0[tendon];
    const std::string name = Name(m_, mjOBJ_TENDON, tendon);
    Add(m_.tendon_stiffness[tendon] * inverse_mass * h_ * h_ / kMostSpring, true,
        "the spring of tendon " + name, "lower its `stiffness`, give the joints an `armature`");
    Add(m_.tendon_damping[tendon] * inverse_mass * h_ / kMostDamping, false,
        "the damping of tendon " + name, "lower it, give the joints an `armature`");
  }

  const mjModel& m_;
  double h_;
  double excess_ = 1;
  std::optional<Divergence> found_;
};

// Returns the joint in MuJoCo's warning about a bad position, velocity or acceleration; nullopt if
// there is no such warning.
std::optional<int> WarnedJoint(const mjModel& m, const mjData& d) {
  for (const int kind : {mjWARN_BADQACC, mjWARN_BADQVEL}) {
    const int dof = d.warning[kind].lastinfo;
    if (d.warning[kind].number > 0 && dof >= 0 && dof < m.nv) return m.dof_jntid[dof];
  }
  const int at = d.warning[mjWARN_BADQPOS].lastinfo;
  if (d.warning[mjWARN_BADQPOS].number == 0 || at < 0 || at >= m.nq) return std::nullopt;
  int joint = m.njnt - 1;
  while (joint > 0 && m.jnt_qposadr[joint] > at) --joint;
  return joint;
}

// Returns true for a floor. A contact with the floor is no cause of a divergence, because objects
// are lifted above the floor before the drop.
bool IsFloor(const mjModel& m, int geom) {
  return m.geom_bodyid[geom] == 0 && m.geom_type[geom] == mjGEOM_PLANE;
}

// Names the two geoms that penetrate each other deepest at the start as the cause of a divergence;
// returns nullopt if no depth exceeds kDeepStart.
std::optional<Divergence> DeepStart(const mjModel& m, Workspace& workspace) {
  mjData& d = workspace.For(m);
  compiled::CopyStart(m, d);
  mj_fwdPosition(&m, &d);
  const mjContact* deepest = nullptr;
  for (const mjContact& contact : ContactsOf(d)) {
    if (IsFloor(m, contact.geom1) || IsFloor(m, contact.geom2)) continue;
    if (deepest == nullptr || contact.dist < deepest->dist) deepest = &contact;
  }
  if (deepest == nullptr || !(-deepest->dist > kDeepStart)) return std::nullopt;
  return Divergence{
      fmt::format("geoms {} and {} start {} mm in each other", Name(m, mjOBJ_GEOM, deepest->geom1),
                  Name(m, mjOBJ_GEOM, deepest->geom2), RoundedText(-1000 * deepest->dist)),
      "make room, or add `contact: exclude`"};
}

// Returns the equalities and tendons that couple a joint: "equality 'gear' with joint 'wheel'",
// "tendon 'belt'".
std::vector<std::string> CouplingsOf(const mjModel& m, int joint) {
  std::vector<std::string> couplings;
  for (int i = 0; i < m.neq; ++i) {
    const int other = m.eq_obj1id[i] == joint ? m.eq_obj2id[i] : m.eq_obj1id[i];
    const bool is_joint = m.eq_type[i] == mjEQ_JOINT;
    const bool is_of_bodies = m.eq_type[i] == mjEQ_CONNECT || m.eq_type[i] == mjEQ_WELD;
    const auto [body1, body2] = engine::BodiesOfEquality(m, i);
    const bool couples = is_joint
                             ? m.eq_obj1id[i] == joint || m.eq_obj2id[i] == joint
                             : is_of_bodies && Moves(m, joint, body1) != Moves(m, joint, body2);
    if (!couples) continue;
    couplings.push_back("equality " + Name(m, mjOBJ_EQUALITY, i));
    if (is_joint && other >= 0)
      couplings.back() += fmt::format(" with joint {}", Name(m, mjOBJ_JOINT, other));
  }
  for (int i = 0; i < m.ntendon; ++i)
    if (IsOnTendon(m, joint, i)) couplings.push_back("tendon " + Name(m, mjOBJ_TENDON, i));
  return couplings;
}

}  // namespace

Divergence FindDivergence(const mjModel& m, const mjData& d, Workspace& workspace) {
  const std::optional<int> joint = WarnedJoint(m, d);
  if (const UnstableElementSearch search(m); search.found()) return *search.found();
  if (const auto deep = DeepStart(m, workspace)) return *deep;
  const std::string usual =
      "use a smaller timestep, softer contacts, or larger masses and inertias for its forces";
  if (!joint) return {.cause = "its state is not finite", .hint = usual};
  const std::string name = compiled::NameOf(m, mjOBJ_JOINT, *joint);
  return {.cause = fmt::format("joint '{}' of body {} is the first", name,
                               Name(m, mjOBJ_BODY, m.jnt_bodyid[*joint])),
          .hint = usual,
          .joint = name};
}

std::string MovedJointText(const mjModel& m, const mjData& d) {
  const std::span<const mjtNum> start = compiled::StartOf(m);
  double farthest = 1;
  std::string text;
  for (int joint = 0; joint < m.njnt; ++joint) {
    if (!compiled::HasOneNumber(m, joint)) continue;
    const int at = m.jnt_qposadr[joint];
    const double way = std::abs(d.qpos[at] - start[compiled::Index(at)]);
    const double share = way / (IsSlide(m, joint) ? kFarSlide : kFarHinge);
    if (share < farthest) continue;
    farthest = share;
    text = fmt::format(", as joint {} moves by {}", Name(m, mjOBJ_JOINT, joint),
                       expr::DistanceText(IsSlide(m, joint), way));
  }
  return text;
}

std::string EnergySourcesHint(const mjModel& m) {
  std::vector<std::string> sources = {"parts that push each other apart", "springs", "actuators"};
  if (m.neq > 0) sources.emplace_back("equalities that the start violates");
  if (m.ntendon > 0) sources.emplace_back("tendons that are stretched");
  if (HasStartPose(m)) sources.emplace_back("a start pose outside of limits");
  return "look for " + Alternatives(sources);
}

std::string HeldBackHint(const mjModel& m, int joint) {
  const std::vector<std::string> couplings = CouplingsOf(m, joint);
  std::string hint = couplings.empty()
                         ? "look at its `range`, at what it touches where it starts, and at "
                           "the inertia that it moves"
                         : "it is held back by " + Alternatives(couplings);
  if (HasStartPose(m))
    hint += "; it begins at the start pose, unless `at` in `checks: joints:` says another";
  return hint;
}

bool CanOtherJointSeparate(const mjModel& m, int joint, const std::pair<int, int>& bodies) {
  const JointCouplings couplings(m);
  for (int other = 0; other < m.njnt; ++other) {
    if (other == joint || !compiled::HasOneNumber(m, other)) continue;
    if (couplings.SetpointOf(other, joint, {})) continue;
    const std::vector<bool> moved = BodiesMovedBy(m, other);
    // A joint that moves both bodies does not change the pose of one relative to the other.
    if (moved[compiled::Index(bodies.first)] != moved[compiled::Index(bodies.second)]) return true;
  }
  return false;
}

std::string LimitHint(const mjModel& m, int joint, double beyond, const std::string& usual) {
  if (beyond < (IsSlide(m, joint) ? kFarSlide : kFarHinge)) return usual;
  return usual +
         "; the limit of a light part gives way far, so that the joint needs an `armature`, too";
}

}  // namespace mjforge::physics
