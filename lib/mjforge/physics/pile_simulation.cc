// Simulation of a pile: releases its bodies one after the other and brings them to rest.
#include "mjforge/physics/pile_simulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "mjforge/compiled/compiled.h"
#include "mjforge/physics/probe_bodies.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using compiled::VectorAt;

constexpr double kClearance = 0.005;  // m, gap between a released body and everything below it
// Damping and timestep while bodies fall into their places. MuJoCo 2.2 computes a wrong normal for
// a deep contact of convex geoms off the middle of a thin plate, and then throws a body through a
// wall; slow bodies and short steps avoid deep contacts. A damped body falls at most at 1 m/s.
constexpr double kDampingTime = 0.1;       // s
constexpr double kDampedTimestep = 0.001;  // s
// A body is released when the previous body is slower than kSlow, but at the latest after
// kPatience. Bodies that fall on fast bodies throw each other out.
constexpr double kSlow = 0.3;        // m/s
constexpr double kFall = 0.05;       // s, time in which a released body gets faster than kSlow
constexpr double kPatience = 0.5;    // s
constexpr double kSlowSpeed = 0.01;  // m/s, speed of all bodies at which damping ends
constexpr double kSlowTime = 0.1;    // s, time for which all bodies must be slower than kSlowSpeed
constexpr double kRestTime = 1;  // s, time for which no body may move; less if Pile::time is short
constexpr double kRestMotion = 5e-4;  // m, distance by which a body at rest may creep in kRestTime
constexpr double kRestTurn = 0.008;   // rad, angle by which a body at rest may turn in kRestTime

// Releases the bodies of one pile, while all other bodies are held.
class PileSimulation {
 public:
  PileSimulation(mjModel& m, mjData& d, const model::Pile& pile,
                 const std::vector<PiledBody>& bodies, const model::Pose& X_WR)
      : m_(m), d_(d), pile_(pile), X_WR_(X_WR), bodies_(bodies) {}

  bool Run() {
    Hold();
    Park();
    const std::vector<mjtNum> damping(m_.dof_damping, m_.dof_damping + m_.nv);
    const mjOption options = m_.opt;
    for (int dof = 0; dof < m_.nv; ++dof) {
      const bool is_piled = std::ranges::any_of(
          bodies_, [&](const PiledBody& piled) { return IsIn(m_.dof_bodyid[dof], piled); });
      if (is_piled) m_.dof_damping[dof] += m_.dof_M0[dof] / kDampingTime;
    }
    m_.opt.timestep = std::min(m_.opt.timestep, kDampedTimestep);
    // Damped bodies do not creep and need no exact forces, which would cost more than half of the
    // time.
    m_.opt.noslip_iterations = 0;
    m_.opt.solver = mjSOL_CG;
    ReleaseAll();
    const double end = d_.time + pile_.time;
    SlowDown(end - pile_.time / 2);
    std::ranges::copy(damping, m_.dof_damping);
    m_.opt = options;
    const bool rests = StaysAtRest(end);
    mj_forward(&m_, &d_);
    return rests;
  }

 private:
  // Returns false if the simulation diverged, ran out of buffers, or dropped a body below the
  // region.
  bool CanGoOn() const {
    return !HasDiverged(d_) && !IsCrowded(d_) &&
           std::ranges::none_of(bodies_, [&](const PiledBody& body) {
             return d_.xpos[3 * body.id + 2] < X_WR_.p.z() - 2 * body.radius;
           });
  }

  // Returns true if a body is in the tree of a piled body.
  bool IsIn(int body, const PiledBody& piled) const { return m_.body_rootid[body] == piled.id; }

  bool IsReleased(int body) const {
    const auto end = bodies_.begin() + static_cast<std::ptrdiff_t>(released_);
    return std::any_of(bodies_.begin(), end,
                       [&](const PiledBody& piled) { return IsIn(body, piled); });
  }

  // Makes all bodies that do not belong to the pile too heavy to be moved.
  void Hold() {
    released_ = bodies_.size();
    for (int dof = 0; dof < m_.nv; ++dof) {
      if (!IsReleased(m_.dof_bodyid[dof])) HoldDof(m_, dof);
    }
    released_ = 0;
    compiled::UpdatePoses(m_, d_);
  }

  // Moves all bodies of the pile to waiting positions above each other, higher than the pile can
  // get.
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

  // Moves the centre of mass of a body to `height` (world z, m), above the point `p_R` of the
  // region.
  void MoveTo(const PiledBody& body, const Eigen::Vector2d& p_R, double height) {
    Eigen::Vector3d p = X_WR_ * Eigen::Vector3d(p_R.x(), p_R.y(), 0);
    p.z() = height;
    mjtNum* qpos = d_.qpos + m_.jnt_qposadr[m_.body_jntadr[body.id]];
    compiled::WritePose({p - body.release->q * body.p_BCm, body.release->q}, qpos, qpos + 3);
  }

  void ReleaseAll() {
    for (const PiledBody& body : bodies_) {
      Release(body);
      const Eigen::Map<const Eigen::Vector3d> v(d_.qvel + m_.body_dofadr[body.id]);
      const double start = d_.time;
      do {
        Step();
      } while (CanGoOn() && d_.time < start + kPatience &&
               (d_.time < start + kFall || v.norm() > kSlow));
    }
  }

  // Lowers a body from above the pile to the first pose in which it nearly touches something.
  void Release(const PiledBody& body) {
    double top = X_WR_.p.z();
    mj_kinematics(&m_, &d_);
    for (std::size_t i = 0; i < released_; ++i) {
      top = std::max(top, compiled::CollidingBox(m_, d_, bodies_[i].id).max.z());
    }
    ++released_;
    const Eigen::Vector2d p_R = model::PositionOfDisc(pile_.region, body.radius, body.release->uv);
    double height = top + body.radius + kClearance;
    MoveTo(body, p_R, height);
    // Lifts the body above posts and sloping walls that may stand in the region.
    while (Touches(body) && height < parked_) {
      height += body.radius / 2;
      MoveTo(body, p_R, height);
    }
    do {
      height -= kClearance;
      MoveTo(body, p_R, height);
    } while (height > X_WR_.p.z() && !Touches(body));
    MoveTo(body, p_R, height + kClearance);
    stepper_.emplace(m_, d_);
  }

  bool Touches(const PiledBody& body) {
    mj_kinematics(&m_, &d_);
    mj_collision(&m_, &d_);
    return std::ranges::any_of(ContactsOf(d_), [&](const mjContact& contact) {
      return IsIn(m_.geom_bodyid[contact.geom1], body) != IsIn(m_.geom_bodyid[contact.geom2], body);
    });
  }

  // Makes one step, and moves bodies that are not yet released back to their waiting positions.
  void Step() {
    stepper_->Step();
    for (int joint = 0; joint < m_.njnt; ++joint) {
      if (IsReleased(m_.jnt_bodyid[joint])) continue;
      // Numbers of velocities, in the order of mjtJoint: free, ball, slide, hinge.
      constexpr int kVelocities[] = {6, 3, 1, 1};
      const int type = m_.jnt_type[joint];
      std::copy_n(held_.begin() + m_.jnt_qposadr[joint], kPositionSizes[type],
                  d_.qpos + m_.jnt_qposadr[joint]);
      std::fill_n(d_.qvel + m_.jnt_dofadr[joint], kVelocities[type], 0.0);
    }
  }

  // Simulates until all bodies are slow, but at most until the time `end`, s.
  void SlowDown(double end) {
    double slow_since = d_.time;
    while (CanGoOn() && d_.time < end && d_.time - slow_since < kSlowTime) {
      Step();
      if (FindFastestBody(m_, d_).speed > kSlowSpeed) slow_since = d_.time;
    }
  }

  // Simulates until no body has moved for kRestTime (or less if Pile::time is short); returns true
  // if that happens before the time `end`, s.
  bool StaysAtRest(double end) {
    const double rest = std::min(kRestTime, pile_.time / 3);
    std::vector<model::Pose> before = Poses();
    double since = d_.time;
    while (CanGoOn() && d_.time < end) {
      Step();
      if (d_.time - since < rest) continue;
      if (AreAt(before, rest / kRestTime)) return true;
      before = Poses();
      since = d_.time;
    }
    return false;
  }

  // Returns the poses of the piled bodies, with the centres of mass of their trees as origins.
  std::vector<model::Pose> Poses() const {
    return diag::Mapped<model::Pose>(bodies_, [&](const PiledBody& body) {
      return model::Pose{VectorAt(d_.subtree_com, body.id),
                         compiled::QuaternionAt(d_.xquat, body.id)};
    });
  }

  // Returns true if no body has moved from its pose in `before` by more than a body at rest may
  // creep in `share` of kRestTime.
  bool AreAt(const std::vector<model::Pose>& before, double share) const {
    const std::vector<model::Pose> now = Poses();
    for (std::size_t i = 0; i < now.size(); ++i) {
      if ((now[i].p - before[i].p).norm() > share * kRestMotion) return false;
      if (now[i].q.angularDistance(before[i].q) > share * kRestTurn) return false;
    }
    return true;
  }

  mjModel& m_;
  mjData& d_;
  const model::Pile& pile_;
  model::Pose X_WR_;
  const std::vector<PiledBody>& bodies_;
  std::size_t released_ = 0;  // number of bodies that are released
  double parked_ = 0;         // m, height above which bodies wait for their release
  std::vector<mjtNum> held_;  // qpos (nq) with the waiting positions of bodies
  std::optional<Stepper> stepper_;
};

}  // namespace

bool SimulatePile(mjModel& m, mjData& d, const model::Pile& pile,
                  const std::vector<PiledBody>& bodies, const model::Pose& X_WR) {
  return PileSimulation(m, d, pile, bodies, X_WR).Run();
}

}  // namespace mjforge::physics
