#include "mjforge/physics/fitting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/added.h"
#include "mjforge/physics/named.h"
#include "mjforge/physics/rounding.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using compiled::VectorAt;
using diag::Code;
using Eigen::Vector3d;

// m, from the tip to the hole. From higher up a peg would fall so deep into a rim that it overlaps
// by a millimetre that the rim would push it sideways, and let it through.
constexpr double kBefore = 0.0002;
constexpr double kSteel = 7850;   // kg/m^3, of a peg of steel
constexpr double kLonger = 1.5;   // a peg, than it has to go
constexpr double kMostTime = 2;   // s; a free fall of 1 m takes 0.45 s
constexpr double kNearly = 1e-4;  // m, a contact's softness
constexpr double kPushes = 2;     // so long, beside the time of a free fall
constexpr double kAgainst = 0.3;  // of a contact's normal, against a push

std::string PegName(std::size_t fitting) { return fmt::format("{}peg-{}", kAddedPrefix, fitting); }

double LengthOf(const model::Fitting& fitting) { return kLonger * fitting.depth; }

/// What goes into a hole: a body of the model, and where its tip is in the body's frame.
struct Peg {
  int body = 0;
  model::Pose X_BT;
};

struct Entry {
  double depth = 0;  // m, that the tip gets to
  /// Whether what is there keeps it from leaving sideways.
  bool is_held = false;
};

class Trial {
 public:
  Trial(mjModel& m, mjData& d, std::span<const mjtNum> start, int first, int added)
      : m_(m), d_(d), stepper_(m, d) {
    PlaceOthers(m, d, start, added > 0 ? m.body_jntadr[first] : 0, 7 * added);
    mj_kinematics(&m, &d);
  }

  /// Nothing if the simulation diverges.
  std::optional<Entry> Run(const Peg& peg, int hole, double depth) {
    const model::Pose X_WH = SitePose(d_, hole);
    Lay(peg, X_WH);
    const Vector3d way = X_WH.q * Vector3d::UnitZ();
    Eigen::Map<Vector3d>(m_.opt.gravity) = kEarthGravity * way;
    double deepest = -kBefore;
    for (double time = 0; time < kMostTime && deepest < depth; time += m_.opt.timestep) {
      stepper_.Step();
      if (HasBlownUp(d_)) return std::nullopt;
      deepest = std::max(deepest, (TipOf(peg) - X_WH.p).dot(way));
      Touch(peg.body);
    }
    if (deepest < depth - kNearly) return Entry{deepest, false};
    const bool is_held = IsHeld(peg, X_WH);
    if (HasBlownUp(d_)) return std::nullopt;
    return Entry{deepest, is_held};
  }

  /// What it last touched.
  const std::string& touched() const { return touched_; }

 private:
  /// In front of the hole, and holds all else.
  void Lay(const Peg& peg, const model::Pose& X_WH) {
    const Vector3d way = X_WH.q * Vector3d::UnitZ();
    const model::Pose X_WT = {X_WH.p - kBefore * way, X_WH.q};
    const model::Pose X_WB = X_WT * peg.X_BT.Inverse();
    const Eigen::Quaterniond q = X_WB.q;
    const mjtNum quat[] = {q.w(), q.x(), q.y(), q.z()};
    const int joint = m_.body_jntadr[peg.body];
    mju_copy3(d_.qpos + m_.jnt_qposadr[joint], X_WB.p.data());
    mju_copy4(d_.qpos + m_.jnt_qposadr[joint] + 3, quat);
    HoldOthers(m_, m_.jnt_dofadr[joint], 6);
  }

  Vector3d TipOf(const Peg& peg) const {
    return compiled::PoseAt(d_.xpos, d_.xquat, peg.body) * peg.X_BT.p;
  }

  /// Whether what is behind the hole's mouth stops it to both sides, along the hole's x axis or
  /// along its y axis, within its own width. A slot is a hole, too; but a peg that comes out of a
  /// hole is held only by what is before the mouth.
  bool IsHeld(const Peg& peg, const model::Pose& X_WH) {
    const std::vector<mjtNum> qpos(d_.qpos, d_.qpos + m_.nq);
    const Vector3d sides = SidesOf(peg, X_WH);
    const auto stops = [&](int axis, double sign) {
      std::ranges::copy(qpos, d_.qpos);
      return Stops(peg, X_WH, X_WH.q * (sign * Vector3d::Unit(axis)), sides[axis]);
    };
    return (stops(0, 1) && stops(0, -1)) || (stops(1, 1) && stops(1, -1));
  }

  /// How wide it is along the axes of the hole, m.
  Vector3d SidesOf(const Peg& peg, const model::Pose& X_WH) const {
    const model::Pose X_HW = X_WH.Inverse();
    model::Box3 box;
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      if (IsOf(peg.body, geom) && compiled::Collides(m_, geom))
        box.Add(compiled::GeomBox(m_, geom, X_HW * compiled::GeomPose(d_, geom)));
    }
    return box.empty() ? Vector3d(Vector3d::Zero()) : Vector3d(box.max - box.min);
  }

  /// Whether its weight, turned that way, presses it against something behind the mouth, and moves
  /// it by less than `most`, m.
  bool Stops(const Peg& peg, const model::Pose& X_WH, const Vector3d& push, double most) {
    mju_zero(d_.qvel, m_.nv);
    mju_zero(d_.qacc_warmstart, m_.nv);
    mj_kinematics(&m_, &d_);
    const Vector3d start = TipOf(peg);
    Eigen::Map<Vector3d>(m_.opt.gravity) = kEarthGravity * push;
    const double time = kPushes * std::sqrt(2 * most / kEarthGravity);
    bool is_pressed = false;
    for (double t = 0; t < time; t += m_.opt.timestep) {
      stepper_.Step();
      if (HasBlownUp(d_) || (TipOf(peg) - start).dot(push) > most) return false;
      is_pressed = is_pressed || IsPressed(peg, X_WH, push);
    }
    return is_pressed;
  }

  bool IsPressed(const Peg& peg, const model::Pose& X_WH, const Vector3d& push) const {
    const Vector3d way = X_WH.q * Vector3d::UnitZ();
    return std::any_of(d_.contact, d_.contact + d_.ncon, [&](const mjContact& contact) {
      const bool touches = IsOf(peg.body, contact.geom1) || IsOf(peg.body, contact.geom2);
      const Vector3d p = Eigen::Map<const Vector3d>(contact.pos);
      const double against = std::abs(Eigen::Map<const Vector3d>(contact.frame).dot(push));
      return touches && contact.dist < 0 && against > kAgainst && (p - X_WH.p).dot(way) > kNearly;
    });
  }

  bool IsOf(int root, int geom) const { return m_.body_rootid[m_.geom_bodyid[geom]] == root; }

  void Touch(int body) {
    for (int i = 0; i < d_.ncon; ++i) {
      const auto [one, two] = std::pair(d_.contact[i].geom1, d_.contact[i].geom2);
      if (!IsOf(body, one) && !IsOf(body, two)) continue;
      const int geom = IsOf(body, one) ? two : one;
      touched_ = compiled::NameOf(m_, mjOBJ_GEOM, geom);
    }
  }

  mjModel& m_;
  mjData& d_;
  std::string touched_;
  Stepper stepper_;
};

class Fits {
 public:
  Fits(const mjModel& m, Workspace& workspace, std::span<const mjtNum> start,
       const std::string& name, Verdict& verdict)
      : m_(m), workspace_(workspace), start_(start), name_(name), verdict_(verdict) {
    const auto& fits = verdict.checks().fits;
    for (std::size_t i = 0; i < fits.size(); ++i) {
      const int body = mj_name2id(&m, mjOBJ_BODY, PegName(i).c_str());
      if (body < 0) continue;
      if (first_ == 0) first_ = body;
      ++added_;
    }
  }

  Result::Fitting Check() {
    Result::Fitting counts;
    const auto& fits = verdict_.checks().fits;
    for (std::size_t i = 0; i < fits.size(); ++i) {
      ++counts.tried;
      const int hole = Find(fits[i], mjOBJ_SITE, fits[i].hole);
      const std::optional<Peg> peg = hole < 0 ? std::nullopt : PegOf(fits[i], i);
      if (peg && Goes(fits[i], *peg, hole)) ++counts.fit;
    }
    return counts;
  }

 private:
  int Find(const model::Fitting& fitting, mjtObj kind, const std::string& own) {
    return FindNamed(m_, kind, name_, own, {"fits", fitting.mark}, verdict_);
  }

  std::optional<Peg> PegOf(const model::Fitting& fitting, std::size_t index) {
    if (fitting.body.empty()) {
      const double half = LengthOf(fitting) / 2;
      return Peg{mj_name2id(&m_, mjOBJ_BODY, PegName(index).c_str()),
                 {Vector3d(0, 0, half), Eigen::Quaterniond::Identity()}};
    }
    const int body = Find(fitting, mjOBJ_BODY, fitting.body);
    const int tip = body < 0 ? -1 : Find(fitting, mjOBJ_SITE, fitting.tip);
    if (tip < 0) return std::nullopt;
    const int joint = m_.body_jntadr[body];
    if (m_.body_jntnum[body] != 1 || m_.jnt_type[joint] != mjJNT_FREE) {
      verdict_.Error(Code::kModelBadValue, fitting.mark,
                     fmt::format("`fits`: body '{}' is not free, so that it cannot be put in front "
                                 "of a hole",
                                 fitting.body));
      return std::nullopt;
    }
    if (m_.site_bodyid[tip] != body) {
      verdict_.Error(
          Code::kModelBadValue, fitting.mark,
          fmt::format("`fits`: site '{}' is not on body '{}'", fitting.tip, fitting.body));
      return std::nullopt;
    }
    return Peg{body, compiled::PoseAt(m_.site_pos, m_.site_quat, tip)};
  }

  bool Goes(const model::Fitting& fitting, const Peg& peg, int hole) {
    for (;;) {
      engine::Model copy(mj_copyModel(nullptr, &m_));
      LeaveOnly(*copy, peg.body);
      mjData& d = workspace_.For(*copy);
      Trial trial(*copy, d, start_, first_, added_);
      const std::optional<Entry> entry = trial.Run(peg, hole, fitting.depth);
      if (MakeRoom(*copy, d)) continue;
      if (entry && entry->is_held) return true;
      Report(fitting, entry, trial.touched());
      return false;
    }
  }

  /// Of the pegs that were added, only this one is there.
  void LeaveOnly(mjModel& m, int peg) const {
    for (int geom = 0; geom < m.ngeom; ++geom) {
      const int body = m.geom_bodyid[geom];
      if (body >= first_ && body < first_ + added_ && body != peg)
        m.geom_contype[geom] = m.geom_conaffinity[geom] = 0;
    }
  }

  void Report(const model::Fitting& fitting, const std::optional<Entry>& entry,
              const std::string& touched) {
    const std::string peg = fitting.body.empty() ? "a peg" : fmt::format("'{}'", fitting.body);
    const double wanted = 1000 * fitting.depth;
    if (!entry) {
      verdict_.Error(
          Code::kPhysicsUnstable, fitting.mark,
          fmt::format("the simulation diverges as {} goes into '{}'", peg, fitting.hole));
    } else if (entry->depth >= fitting.depth - kNearly) {
      verdict_.Error(Code::kPhysicsDoesNotFit, fitting.mark,
                     fmt::format("nothing holds {} sideways, {} mm behind '{}'", peg,
                                 RoundedText(wanted), fitting.hole),
                     "the site must be at the mouth of a hole, and its z axis is the way in");
    } else {
      const Beyond depth(std::max(0.0, 1000 * entry->depth), wanted);
      verdict_.Error(Code::kPhysicsDoesNotFit, fitting.mark,
                     fmt::format("{} goes {} mm into '{}', not {} mm{}", peg, depth.value,
                                 fitting.hole, depth.limit,
                                 touched.empty() ? "" : fmt::format(": it touches '{}'", touched)),
                     "make the hole wider or deeper; the z axis of its site is the way in");
    }
  }

  const mjModel& m_;
  Workspace& workspace_;
  std::span<const mjtNum> start_;
  const std::string& name_;
  Verdict& verdict_;
  int first_ = 0;  // body of the first added peg
  int added_ = 0;
};

}  // namespace

std::string WithPegs(std::string_view text, const model::Checks& checks) {
  std::string pegs;
  for (std::size_t i = 0; i < checks.fits.size(); ++i) {
    const model::Fitting& fitting = checks.fits[i];
    if (!fitting.body.empty()) continue;
    const double x = fitting.peg[0] / 2;
    const double y = fitting.peg[1] / 2;
    const double length = LengthOf(fitting);
    const double area = fitting.is_round ? std::numbers::pi * x * x : 4 * x * y;
    const std::string shape = fitting.is_round
                                  ? fmt::format(R"(type="cylinder" size="{} {}")", x, length / 2)
                                  : fmt::format(R"(type="box" size="{} {} {}")", x, y, length / 2);
    pegs += fmt::format(R"(<body name="{}"><freejoint/>{}</body>)", PegName(i),
                        AddedGeom(shape, kSteel * area * length));
  }
  return WithBodies(text, pegs);
}

void CheckFitting(mjModel& m, Workspace& workspace, std::span<const mjtNum> start,
                  const std::string& name, Verdict& verdict, Result& result) {
  result.fits = Fits(m, workspace, start, name, verdict).Check();
}

}  // namespace mjforge::physics
