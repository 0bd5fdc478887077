// Interface to the search for places: one try at a place for a body, and its result.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/model/object.h"
#include "mjforge/model/region.h"

namespace mjforge::model {

/// A side of a body, as seen by somebody who looks the way the body's front looks: if its front is
/// -y, right is -x.
enum class Side { kLeft, kRight, kFront, kBack };

/// A neighbour that a body stands next to.
struct Beside {
  int body = -1;  // index in Object::bodies
  Side side = Side::kRight;
  double front = 0;  // angle of the neighbour's front about z, from its -y axis, rad
  double gap = 0;    // distance of the two bounding boxes along the side's direction, m
};

/// Try to place a body, as drawn from `place:` of its spec. Points and directions are in the
/// frame of the object.
struct PlaceTry {
  int support = -1;                // index of the body that has the region or the site
  const Region* region = nullptr;  // null: the body is placed by a site of the support
  /// Pose of the support's site, in the support, and of the body's own site, in the body: the
  /// frames of both sites will coincide, except for the yaw. Used only if `region` is null; the
  /// body may then overlap the support.
  Pose X_SupportSite;
  Pose X_BodySite;
  /// Position of the footprint within its free play: numbers from -1 to 1; in a disc, a point of
  /// the unit disc. With `beside`, offset along the neighbour's side: 0 aligns the centres of the
  /// bounding boxes, -1 and 1 their ends. Left and right use the second number, front and back the
  /// first.
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  std::optional<Beside> beside;
  /// Turn about the vertical, rad. The body is turned first so that its front faces `facing` or
  /// looks along `direction`, or has the direction of the neighbour's front; without any of them,
  /// its axes are parallel to the axes of the region.
  double yaw = 0;
  std::optional<Eigen::Vector2d> facing;     // a point, m
  std::optional<Eigen::Vector2d> direction;  // horizontal, of any length but 0
  double front = 0;                          // angle of the body's front, from its -y axis, rad
  /// Rotation of the body before the yaw; nullopt: as modelled or, if the body would tip over, as
  /// in the stable pose with the least rotation.
  std::optional<Eigen::Quaterniond> lying;
  /// Least distance to all other bodies, m. The support, and bodies whose parts are all below the
  /// region, may be closer, but must not overlap the body.
  double clear = 0;
  double overhang = 0;  // share of the footprint that may lie outside, 0 .. 1
};

enum class PlaceVerdict {
  kStands,
  kTooLarge,  // the footprint does not fit into the region, wherever it is
  kTooHigh,   // higher than the free height above the region
  kOutside,   // the place that `beside` demands is outside of the region
  kBlocked,   // too near to `blocker`
};

struct PlaceResult {
  PlaceVerdict verdict = PlaceVerdict::kStands;
  Pose X_SupportBody;   // pose of the body in its support; set for kStands
  int blocker = -1;     // index of the body that is too near
  double distance = 0;  // from the body to the blocker, m; 0 if both overlap
  Eigen::Vector2d footprint = Eigen::Vector2d::Zero();  // sides of its bounding rectangle, m
};

/// An orientation in which a body is at rest on a level plane.
struct StablePose {
  std::string name;  // upright, upside_down, on_front, on_back, on_left, on_right, on_left_2, ...
  Eigen::Quaterniond rotation;  // for PlaceTry::lying
  double margin = 0;            // smallest tilt that makes the body tip over, rad
  double probability = 0;       // probability that a random throw ends in this pose
};

/// Searches places for bodies of one object. A body is "below" another body if it is a descendant
/// of that body. Bodies and their joints are at the start state.
class Placer {
 public:
  Placer() = default;
  Placer(const Placer&) = delete;
  Placer& operator=(const Placer&) = delete;
  virtual ~Placer() = default;

  /// Forgets all obstacles, and begins with another object, which must outlive the next calls.
  /// Bodies may be added and moved between calls, but the parts of obstacles and of tried bodies
  /// must not change.
  virtual void Begin(const Object& object) = 0;

  /// Makes the body, and all bodies below it, an obstacle at its present pose. Bodies that are
  /// placed later must have at least the distance `clear`, m, to this obstacle.
  virtual void Stand(int body, double clear = 0) = 0;

  /// Tries a place for a body that is not an obstacle yet, with all bodies below this body.
  virtual PlaceResult Try(int body, const PlaceTry& where) = 0;

  /// Returns the diameter of the largest upright cylinder that is as high as the body and fits into
  /// the region of `where` among the obstacles, m.
  virtual double WidestGap(int body, const PlaceTry& where) = 0;

  /// Returns the stable poses of a body, with all bodies below it; the most probable first. `front`
  /// is the angle of its front, from its -y axis, rad.
  virtual std::vector<StablePose> StablePoses(int body, double front) = 0;
};

}  // namespace mjforge::model
