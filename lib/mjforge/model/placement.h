// Interface to the placement of bodies in regions: inputs and result of one attempt, and stable
// poses.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/model/object.h"
#include "mjforge/model/region.h"

namespace mjforge::model {

/// A side of a body, as seen by an observer who looks in the direction of the body's front: if the
/// front is -y, the right is -x.
enum class Side { kLeft, kRight, kFront, kBack };

/// A neighbour beside which a body is placed.
struct Beside {
  int body = -1;  // index in Object::bodies
  Side side = Side::kRight;
  double front = 0;  // angle of the neighbour's front about z, from its -y axis, rad
  double gap = 0;    // distance of the bounding boxes in the direction of the side, m
};

/// An attempt to place a body, with the values drawn from `place:` of its spec. Points and
/// directions are in the frame of the object. The footprint of a body is its projection onto the
/// plane of the region.
struct PlaceTry {
  int support = -1;                // index of the body to which the region or site belongs
  const Region* region = nullptr;  // null: the body is placed by a site of the support
  /// Pose of a site of the support in the support, and pose of a site of the body in the body. Used
  /// only if `region` is null: the body is then placed such that both sites coincide, except for
  /// the yaw, and may overlap the support.
  Pose X_SupportSite;
  Pose X_BodySite;
  /// Position of the footprint in the region: two numbers from -1 to 1, which span all positions at
  /// which the footprint is inside; in a disc, a point of the unit disc. If `beside` is given, one
  /// of the numbers (y for Side::kLeft and kRight, x for kFront and kBack) is the offset along the
  /// neighbour's side: 0 aligns the centres of the two bounding boxes, -1 and 1 align their ends.
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  std::optional<Beside> beside;
  /// Rotation about the vertical, rad. Before this rotation, the body's front faces the point
  /// `facing`, or is along `direction`, or has the direction of the neighbour's front. If `facing`,
  /// `direction` and `beside` are nullopt, the body's axes are parallel to the region's axes.
  double yaw = 0;
  std::optional<Eigen::Vector2d> facing;     // point that the front faces, m
  std::optional<Eigen::Vector2d> direction;  // horizontal vector of any length but 0
  double front = 0;                          // angle of the body's front, from its -y axis, rad
  /// Rotation of the body before the yaw. If nullopt, the body is placed as it is modelled or, if
  /// it would tip over, in the stable pose with the smallest rotation.
  std::optional<Eigen::Quaterniond> lying;
  /// Least distance to all other bodies, m. Exceptions are the support, and bodies whose parts are
  /// all below the region: the distance to them may be smaller, but they must not overlap the body.
  double clear = 0;
  double overhang = 0;  // share of the footprint that may be outside of the region, 0 .. 1
};

enum class PlaceVerdict {
  kStands,    // the body has a place: PlaceResult::X_SupportBody
  kTooLarge,  // the footprint does not fit into the region at any position
  kTooHigh,   // the body is higher than the free height above the region
  kOutside,   // the position beside the neighbour (`beside`) is outside of the region
  kBlocked,   // the distance to the body `blocker` is too small, or the body would tip over on it
};

struct PlaceResult {
  PlaceVerdict verdict = PlaceVerdict::kStands;
  Pose X_SupportBody;   // pose of the body in its support, only for kStands
  int blocker = -1;     // index of a body in Object::bodies, only for kBlocked
  double distance = 0;  // distance from the body to the blocker, m; 0 if they overlap
  /// Sides of the footprint's bounding rectangle in the region's frame, m.
  Eigen::Vector2d footprint = Eigen::Vector2d::Zero();
  /// Sides of the body's bounding box before the yaw, with z up, m.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
};

/// An orientation in which a body is at rest on a level plane.
struct StablePose {
  std::string name;  // upright, upside_down, on_front, on_back, on_left, on_right, on_left_2, ...
  Eigen::Quaterniond rotation;  // value for PlaceTry::lying
  double margin = 0;            // smallest tilt that tips the body over, rad
  double probability = 0;       // probability that a random throw ends in this pose
};

/// Places bodies of one object between other bodies, the obstacles. Descendants of a body are
/// "below" that body in the tree. Bodies and their joints are at the start state.
class Placer {
 public:
  Placer() = default;
  Placer(const Placer&) = delete;
  Placer& operator=(const Placer&) = delete;
  virtual ~Placer() = default;

  /// Removes all obstacles, and continues with another object, which must outlive all following
  /// calls. Between calls, bodies may be added and moved, but the parts of obstacles and of bodies
  /// that were passed to Try() must not change.
  virtual void Begin(const Object& object) = 0;

  /// Makes the body, with all bodies below it, an obstacle at its present pose. Bodies that are
  /// placed later must have at least the distance `clear`, m, to this obstacle.
  virtual void AddObstacle(int body, double clear = 0) = 0;

  /// Returns the pose of a body, with all bodies below it, that `where` describes, or the reason
  /// why the body cannot stand there. Does not move the body, which must not be an obstacle.
  virtual PlaceResult Try(int body, const PlaceTry& where) = 0;

  /// Returns the first of some obstacles (`among`) that a body, with all bodies below it, overlaps
  /// at a pose in the object's frame; -1 if it overlaps none. The body may be an obstacle itself.
  virtual int FindOverlap(int body, const Pose& X_WBody, const std::vector<int>& among) = 0;

  /// Returns the diameter, m, of the largest upright cylinder that is as high as the body and fits
  /// into the region of `where` between the obstacles.
  virtual double WidestGap(int body, const PlaceTry& where) = 0;

  /// Returns the stable poses of a body, with all bodies below it, the most probable pose first.
  /// `front` is the angle of the body's front from its -y axis, rad.
  virtual std::vector<StablePose> StablePoses(int body, double front) = 0;
};

}  // namespace mjforge::model
