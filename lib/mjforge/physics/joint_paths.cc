// Computes the paths on which joints are driven, the bodies that joints move, and the space that
// these bodies need.
#include "mjforge/physics/joint_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {
namespace {

constexpr double kPush = 0.1;  // push of a hinge or slide, as a share of its range
// Push of a ball joint, as a share of its range: smaller, because MuJoCo's limit of a ball joint
// assumes the same inertia about all axes, and is soft about the axis of a thin body.
constexpr double kPushOfBall = 0.02;
constexpr double kNear = 0.001;  // m, clearance of bodies that are driven at the same time

using Box = Eigen::AlignedBox3d;

/// Returns a box that contains all colliding geoms that the joint of a path moves, at every
/// position on the path. For a hinge the box is larger than needed: each point moves by at most
/// angle times radius, and stays within a sphere about the anchor of the joint.
Box SweptBox(const mjModel& m, const mjData& d, const JointPath& path,
             const std::vector<bool>& moved) {
  model::Box3 at_start;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    if (moved[compiled::Index(m.geom_bodyid[geom])] && compiled::Collides(m, geom))
      at_start.Add(compiled::GeomBox(m, geom, compiled::GeomPose(d, geom)));
  }
  if (at_start.empty()) return {};
  const Box box = at_start.ToEigen();
  const double back = path.low - path.push - path.start;
  const double forth = path.high + path.push - path.start;
  if (m.jnt_type[path.joint] == mjJNT_SLIDE) {
    const Eigen::Vector3d axis = compiled::VectorAt(d.xaxis, path.joint);
    return Box(box).translated(back * axis).merged(Box(box).translated(forth * axis));
  }
  const Eigen::Vector3d anchor = compiled::VectorAt(d.xanchor, path.joint);
  const Eigen::Vector3d corner =
      (box.min() - anchor).cwiseAbs().cwiseMax((box.max() - anchor).cwiseAbs());
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(corner.norm());
  const double angle = std::min(std::max(-back, forth), std::numbers::pi);
  const Eigen::Vector3d turned = angle * reach;
  return Box(anchor - reach, anchor + reach)
      .intersection(Box(box.min() - turned, box.max() + turned));
}

}  // namespace

std::vector<JointPath> PathsOf(const mjModel& m, int joint, std::span<const mjtNum> qpos) {
  const std::optional<compiled::JointRange> range = compiled::RangeOf(m, joint);
  if (!range) return {};
  const bool limited = range->limited;
  if (m.jnt_type[joint] != mjJNT_BALL) {
    const int at = m.jnt_qposadr[joint];
    const double zero = m.qpos0[at];
    const double start = qpos[static_cast<std::size_t>(at)] - zero;
    const double push = limited ? kPush * (range->high - range->low) : 0;
    return {{joint, 0, limited, range->low - zero, range->high - zero, start, push}};
  }
  const double most =
      limited ? range->high : 0.9 * range->high;  // a rotation by half a turn is ambiguous
  std::vector<JointPath> paths;
  paths.reserve(3);
  for (int axis = 0; axis < 3; ++axis)
    paths.push_back({joint, axis, limited, -most, most, 0, limited ? kPushOfBall * 2 * most : 0});
  return paths;
}

bool IsOnTendon(const mjModel& m, int joint, int tendon) {
  if (tendon < 0) return false;
  for (int i = m.tendon_adr[tendon]; i < m.tendon_adr[tendon] + m.tendon_num[tendon]; ++i) {
    if (m.wrap_type[i] == mjWRAP_JOINT && m.wrap_objid[i] == joint) return true;
    if (m.wrap_type[i] == mjWRAP_SITE && compiled::Moves(m, joint, m.site_bodyid[m.wrap_objid[i]]))
      return true;
  }
  return false;
}

std::vector<bool> BodiesMovedBy(const mjModel& m, int joint) {
  std::vector<bool> moved(compiled::Index(m.nbody));
  moved[compiled::Index(m.jnt_bodyid[joint])] = true;
  // Visits parents first, because ids of bodies are greater than those of their parents.
  for (int body = m.jnt_bodyid[joint] + 1; body < m.nbody; ++body)
    moved[compiled::Index(body)] = moved[compiled::Index(m.body_parentid[body])];
  return moved;
}

std::vector<std::vector<int>> IndependentGroups(const mjModel& m, const mjData& d,
                                                const JointCouplings& couplings,
                                                std::span<const int> joints) {
  struct Group {
    std::vector<int> joints;
    std::vector<Box> boxes;
    std::vector<bool> moved;
    bool open = true;  // joints may be added to the group
  };
  std::vector<Group> groups;
  for (const int joint : joints) {
    const std::vector<JointPath> paths = PathsOf(m, joint, {d.qpos, compiled::Index(m.nq)});
    const bool alone = paths.size() != 1 || couplings.IsCoupled(joint);
    const std::vector<bool> moved = BodiesMovedBy(m, joint);
    Box box = alone ? Box() : SweptBox(m, d, paths[0], moved);
    if (!box.isEmpty()) box = Box(box.min().array() - kNear, box.max().array() + kNear);
    const auto fits = [&](const Group& group) {
      if (alone || !group.open) return false;
      for (std::size_t i = 0; i < moved.size(); ++i) {
        if (moved[i] && group.moved[i]) return false;
      }
      return std::ranges::none_of(group.boxes, [&](const Box& other) {
        return !box.isEmpty() && !other.isEmpty() && box.intersects(other);
      });
    };
    auto group = std::ranges::find_if(groups, fits);
    if (group == groups.end()) {
      groups.emplace_back().moved.resize(compiled::Index(m.nbody));
      group = groups.end() - 1;
      group->open = !alone;
    }
    group->joints.push_back(joint);
    group->boxes.push_back(box);
    for (std::size_t i = 0; i < moved.size(); ++i) group->moved[i] = group->moved[i] || moved[i];
  }
  std::vector<std::vector<int>> all;
  all.reserve(groups.size());
  for (Group& group : groups) all.push_back(std::move(group.joints));
  return all;
}

}  // namespace mjforge::physics
