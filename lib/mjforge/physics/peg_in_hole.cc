// Peg-in-hole test: drops pegs into holes, and pushes them sideways to see whether they are held.
#include "mjforge/physics/probe_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/named_elements.h"
#include "mjforge/physics/solid_geoms.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using diag::Code;
using Eigen::Vector3d;
using expr::ExceededLimit;
using expr::RoundedText;

// Initial distance of the peg's tip from the hole, m. If the peg started farther away, and its side
// overlapped the rim by a millimetre, the peg would sink so deep into the rim that the contact
// would push it sideways, into the hole.
constexpr double kStartDistance = 0.0002;
constexpr double kSteel = 7850;           // kg/m^3, density of a peg
constexpr double kLengthPerDepth = 1.5;   // length of a peg, as a multiple of the required depth
constexpr double kLongestFall = 2;        // s; a free fall of 1 m takes 0.45 s
constexpr double kDepthTolerance = 1e-4;  // m, tolerance of depths, because contacts are soft
constexpr double kNoHole = 0.001;  // m; a geom nearer than this behind the site closes the hole
constexpr double kPushTime =
    2;  // duration of a push, as a multiple of the time of a free fall over the peg's width
// Least cosine of the angle between a push and the normal of a contact that resists the push.
constexpr double kLeastCosine = 0.3;

std::string PegName(std::size_t fitting) { return fmt::format("{}peg-{}", kProbePrefix, fitting); }

Vector3d ZAxis(const model::Pose& X) { return Eigen::Quaterniond(X.q) * Vector3d::UnitZ(); }

double LengthOf(const model::FittingCheck& fitting) { return kLengthPerDepth * fitting.depth; }

/// Body that must go into a hole.
struct Peg {
  int body = 0;
  model::Pose X_BT;  // pose of the tip of the peg in the frame of the body
};

/// End of a hole: the first colliding geom on the hole's axis.
struct HoleEnd {
  double distance = 0;  // m, distance from the mouth; 0 if the mouth is in the geom
  std::string geom;
};

/// Result of dropping a peg into a hole.
struct Insertion {
  double depth = 0;      // m, largest depth of the tip
  bool is_held = false;  // true: the hole stops the peg from leaving sideways
};

/// Simulation of one peg that drops into one hole.
class PegDrop {
 public:
  PegDrop(mjModel& m, mjData& d, std::span<const mjtNum> start, int first, int count)
      : m_(m), d_(d), stepper_(m, d) {
    PlaceObject(m, d, start, count > 0 ? m.body_jntadr[first] : 0, 7 * count);
    mj_kinematics(&m, &d);
  }

  /// Drops a peg into a hole until its tip is at `depth`, m, and then pushes the peg sideways.
  /// `hole` is the id of a site. Returns nullopt if the simulation diverges.
  std::optional<Insertion> Run(const Peg& peg, int hole, double depth) {
    const model::Pose X_WH = SitePose(d_, hole);
    Place(peg, X_WH);
    const Vector3d way = ZAxis(X_WH);
    Eigen::Map<Vector3d>(m_.opt.gravity) = kEarthGravity * way;
    double deepest = -kStartDistance;
    for (double time = 0; time < kLongestFall && deepest < depth; time += m_.opt.timestep) {
      stepper_.Step();
      if (HasDiverged(d_)) return std::nullopt;
      deepest = std::max(deepest, (TipOf(peg) - X_WH.p).dot(way));
      NoteTouched(peg.body);
    }
    if (deepest < depth - kDepthTolerance) return Insertion{deepest, false};
    const bool is_held = IsHeld(peg, X_WH);
    if (HasDiverged(d_)) return std::nullopt;
    return Insertion{deepest, is_held};
  }

  /// Returns the first geom on the axis of a hole, which ends the hole; nullopt if the hole has no
  /// end. Ignores geoms of the body `peg`. `hole` is the id of a site.
  std::optional<HoleEnd> EndOf(int hole, int peg) const {
    const model::Pose X_WH = SitePose(d_, hole);
    const Vector3d way = ZAxis(X_WH);
    std::optional<HoleEnd> end;
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      if (!IsSolid(m_, geom) || IsOf(peg, geom)) continue;
      double distance = RayTo(m_, d_, geom, X_WH.p, way);
      if (distance < 0) continue;
      // A convex geom contains the mouth if rays in both directions hit the geom.
      if (RayTo(m_, d_, geom, X_WH.p, -way) >= 0) distance = 0;
      if (!end || distance < end->distance)
        end = HoleEnd{distance, compiled::NameOf(m_, mjOBJ_GEOM, geom)};
    }
    return end;
  }

  /// Returns the name of the geom that the peg touched last; an empty text if the peg touched none.
  const std::string& touched() const { return touched_; }

 private:
  /// Places the peg in front of the hole, and holds everything else in place.
  void Place(const Peg& peg, const model::Pose& X_WH) {
    const Vector3d way = ZAxis(X_WH);
    const model::Pose X_WT = {X_WH.p - kStartDistance * way, X_WH.q};
    const model::Pose X_WB = X_WT * peg.X_BT.Inverse();
    const int joint = m_.body_jntadr[peg.body];
    mjtNum* const qpos = d_.qpos + m_.jnt_qposadr[joint];
    compiled::WritePose(X_WB, qpos, qpos + 3);
    HoldOthers(m_, m_.jnt_dofadr[joint], 6);
  }

  Vector3d TipOf(const Peg& peg) const {
    return compiled::PoseAt(d_.xpos, d_.xquat, peg.body) * peg.X_BT.p;
  }

  /// Returns true if the hole holds the peg sideways: geoms behind the mouth of the hole stop the
  /// peg, within the width of the peg, in both directions of the x axis of the hole, or of its y
  /// axis. Therefore a slot counts as a hole, but walls in front of the mouth do not.
  bool IsHeld(const Peg& peg, const model::Pose& X_WH) {
    const std::vector<mjtNum> qpos(d_.qpos, d_.qpos + m_.nq);
    const Vector3d sides = SidesOf(peg, X_WH);
    const auto stops = [&](int axis, double sign) {
      std::ranges::copy(qpos, d_.qpos);
      return Stops(peg, X_WH, X_WH.q * (sign * Vector3d::Unit(axis)), sides[axis]);
    };
    return (stops(0, 1) && stops(0, -1)) || (stops(1, 1) && stops(1, -1));
  }

  /// Returns the size of the peg along the axes of the hole, m.
  Vector3d SidesOf(const Peg& peg, const model::Pose& X_WH) const {
    const model::Pose X_HW = X_WH.Inverse();
    model::Box3 box;
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      if (IsOf(peg.body, geom) && compiled::Collides(m_, geom))
        box.Add(compiled::GeomBox(m_, geom, X_HW * compiled::GeomPose(d_, geom)));
    }
    return box.empty() ? Vector3d(Vector3d::Zero()) : Vector3d(box.max - box.min);
  }

  /// Turns gravity in the direction of `push`. Returns true if the peg is then pressed against a
  /// geom behind the mouth, and moves by at most `most`, m.
  bool Stops(const Peg& peg, const model::Pose& X_WH, const Vector3d& push, double most) {
    mju_zero(d_.qvel, m_.nv);
    mju_zero(d_.qacc_warmstart, m_.nv);
    mj_kinematics(&m_, &d_);
    const Vector3d start = TipOf(peg);
    Eigen::Map<Vector3d>(m_.opt.gravity) = kEarthGravity * push;
    const double time = kPushTime * std::sqrt(2 * most / kEarthGravity);
    bool is_pressed = false;
    for (double t = 0; t < time; t += m_.opt.timestep) {
      stepper_.Step();
      if (HasDiverged(d_) || (TipOf(peg) - start).dot(push) > most) return false;
      is_pressed = is_pressed || IsPressed(peg, X_WH, push);
    }
    return is_pressed;
  }

  /// Returns true if a contact of the peg behind the mouth of the hole resists the push.
  bool IsPressed(const Peg& peg, const model::Pose& X_WH, const Vector3d& push) const {
    const Vector3d way = ZAxis(X_WH);
    return std::ranges::any_of(ContactsOf(d_), [&](const mjContact& contact) {
      const bool touches = IsOf(peg.body, contact.geom1) || IsOf(peg.body, contact.geom2);
      const Vector3d p = Eigen::Map<const Vector3d>(contact.pos);
      const double against = std::abs(Eigen::Map<const Vector3d>(contact.frame).dot(push));
      return touches && contact.dist < 0 && against > kLeastCosine &&
             (p - X_WH.p).dot(way) > kDepthTolerance;
    });
  }

  bool IsOf(int root, int geom) const { return m_.body_rootid[m_.geom_bodyid[geom]] == root; }

  void NoteTouched(int body) {
    for (const mjContact& contact : ContactsOf(d_)) {
      const bool is_first = IsOf(body, contact.geom1);
      if (!is_first && !IsOf(body, contact.geom2)) continue;
      touched_ = compiled::NameOf(m_, mjOBJ_GEOM, is_first ? contact.geom2 : contact.geom1);
    }
  }

  mjModel& m_;
  mjData& d_;
  std::string touched_;
  Stepper stepper_;
};

class PegTests {
 public:
  explicit PegTests(const ProbeTest& test) : test_(test), fits_(test.checks().fits) {
    for (std::size_t i = 0; i < fits_.size(); ++i) {
      const int body = mj_name2id(&test.m, mjOBJ_BODY, PegName(i).c_str());
      if (body < 0) continue;
      if (first_ == 0) first_ = body;
      ++count_;
    }
  }

  Result::Fitting Check() {
    Result::Fitting counts;
    for (std::size_t i = 0; i < fits_.size(); ++i) {
      ++counts.tried;
      const std::optional<int> hole = Find(fits_[i], mjOBJ_SITE, fits_[i].hole);
      const std::optional<Peg> peg = hole ? PegOf(fits_[i], i) : std::nullopt;
      if (peg && Fits(fits_[i], *peg, *hole)) ++counts.fit;
    }
    return counts;
  }

 private:
  std::optional<int> Find(const model::FittingCheck& fitting, mjtObj kind,
                          const std::string& name) {
    return FindNamed(test_, kind, name, {"fits", fitting.mark});
  }

  std::optional<Peg> PegOf(const model::FittingCheck& fitting, std::size_t index) {
    const mjModel& m = test_.m;
    if (fitting.body.empty()) {
      const double half = LengthOf(fitting) / 2;
      return Peg{mj_name2id(&m, mjOBJ_BODY, PegName(index).c_str()),
                 {Vector3d(0, 0, half), Eigen::Quaterniond::Identity()}};
    }
    const std::optional<int> body = Find(fitting, mjOBJ_BODY, fitting.body);
    const std::optional<int> tip = body ? Find(fitting, mjOBJ_SITE, fitting.tip) : std::nullopt;
    if (!tip) return std::nullopt;
    if (m.body_jntnum[*body] != 1 || m.jnt_type[m.body_jntadr[*body]] != mjJNT_FREE) {
      test_.reporter.Error(
          Code::kModelBadValue, fitting.mark,
          fmt::format("`fits`: body '{}' is not free, so that it cannot be put in front "
                      "of a hole",
                      fitting.body));
      return std::nullopt;
    }
    if (m.site_bodyid[*tip] != *body) {
      test_.reporter.Error(
          Code::kModelBadValue, fitting.mark,
          fmt::format("`fits`: site '{}' is not on body '{}'", fitting.tip, fitting.body));
      return std::nullopt;
    }
    return Peg{*body, compiled::PoseAt(m.site_pos, m.site_quat, *tip)};
  }

  /// Returns true if the peg fits; otherwise reports why not.
  bool Fits(const model::FittingCheck& fitting, const Peg& peg, int hole) {
    const engine::Model copy(mj_copyModel(nullptr, &test_.m));
    RemoveOtherPegs(*copy, peg.body);
    std::string touched;
    std::optional<HoleEnd> end;
    const auto insertion = Simulate(*copy, test_.workspace, [&](mjData& d) {
      PegDrop drop(*copy, d, test_.start, first_, count_);
      end = drop.EndOf(hole, peg.body);
      const std::optional<Insertion> result = drop.Run(peg, hole, fitting.depth);
      touched = drop.touched();
      return result;
    });
    if (insertion && insertion->is_held) return true;
    // Requires an end of the hole only for added pegs, because a body of the object may be a ring
    // that goes over a post on the axis.
    if (insertion && end && fitting.body.empty() && end->distance < kNoHole)
      ReportNoHole(fitting, *end);
    else
      Report(fitting, insertion, touched, NarrowHint(fitting, insertion, end));
    return false;
  }

  void RemoveOtherPegs(mjModel& m, int peg) const {
    for (int geom = 0; geom < m.ngeom; ++geom) {
      const int body = m.geom_bodyid[geom];
      if (body >= first_ && body < first_ + count_ && body != peg)
        m.geom_contype[geom] = m.geom_conaffinity[geom] = 0;
    }
  }

  void ReportNoHole(const model::FittingCheck& fitting, const HoleEnd& end) {
    test_.reporter.Error(
        Code::kPhysicsDoesNotFit, fitting.mark,
        fmt::format("there is no hole at '{}': '{}' is {} mm behind it", fitting.hole, end.geom,
                    RoundedText(1000 * end.distance)),
        "the site must be at the mouth of a hole that nothing closes, and its z axis is the way "
        "in");
  }

  /// Returns the hint for a peg that did not go far enough into the hole.
  static std::string NarrowHint(const model::FittingCheck& fitting,
                                const std::optional<Insertion>& insertion,
                                const std::optional<HoleEnd>& end) {
    if (!insertion || !fitting.body.empty())
      return "make the hole wider or deeper; the z axis of its site is the way in";
    if (!end || end->distance >= fitting.depth)
      return "the hole is deep enough, but too narrow: make it wider, or the peg thinner";
    const bool is_wide = insertion->depth > end->distance - kNoHole;
    return fmt::format("the hole ends after {} mm: make it {}", RoundedText(1000 * end->distance),
                       is_wide ? "deeper" : "wider and deeper");
  }

  void Report(const model::FittingCheck& fitting, const std::optional<Insertion>& insertion,
              const std::string& touched, const std::string& hint) {
    const std::string peg = fitting.body.empty() ? "a peg" : fmt::format("'{}'", fitting.body);
    const double wanted = 1000 * fitting.depth;
    if (!insertion) {
      test_.reporter.Error(
          Code::kPhysicsUnstable, fitting.mark,
          fmt::format("the simulation diverges as {} goes into '{}'", peg, fitting.hole));
    } else if (insertion->depth >= fitting.depth - kDepthTolerance) {
      test_.reporter.Error(Code::kPhysicsDoesNotFit, fitting.mark,
                           fmt::format("nothing holds {} sideways, {} mm behind '{}'", peg,
                                       RoundedText(wanted), fitting.hole),
                           "the site must be at the mouth of a hole, and its z axis is the way in");
    } else {
      const ExceededLimit depth(std::max(0.0, 1000 * insertion->depth), wanted);
      test_.reporter.Error(
          Code::kPhysicsDoesNotFit, fitting.mark,
          fmt::format("{} goes {} mm into '{}', not {} mm{}", peg, depth.value, fitting.hole,
                      depth.limit,
                      touched.empty() ? "" : fmt::format(": it touches '{}'", touched)),
          hint);
    }
  }

  const ProbeTest& test_;
  const std::vector<model::FittingCheck>& fits_;
  int first_ = 0;  // id of the body of the first peg that was added
  int count_ = 0;  // number of added pegs
};

}  // namespace

std::string WithPegs(std::string_view text, const model::Checks& checks) {
  std::string pegs;
  for (std::size_t i = 0; i < checks.fits.size(); ++i) {
    const model::FittingCheck& fitting = checks.fits[i];
    if (!fitting.body.empty()) continue;
    const double x = fitting.peg[0] / 2;
    const double y = fitting.peg[1] / 2;
    const double length = LengthOf(fitting);
    const double area = fitting.is_round ? std::numbers::pi * x * x : 4 * x * y;
    const std::string shape = fitting.is_round
                                  ? fmt::format(R"(type="cylinder" size="{} {}")", x, length / 2)
                                  : fmt::format(R"(type="box" size="{} {} {}")", x, y, length / 2);
    pegs += fmt::format(R"(<body name="{}"><freejoint/>{}</body>)", PegName(i),
                        ProbeGeom(shape, kSteel * area * length));
  }
  return WithBodies(text, pegs);
}

void CheckPegInHole(const ProbeTest& test) { test.result.fits = PegTests(test).Check(); }

}  // namespace mjforge::physics
