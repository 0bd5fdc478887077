// Interface to the search for places: one try at a place for a body, and its result.

#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Dense>

#include "mjforge/model/object.h"
#include "mjforge/model/region.h"

namespace mjforge::model {

/// A side of a body, in its frame turned so that its front is -y.
enum class Side { kLeft, kRight, kFront, kBack };

/// A neighbour that a body stands next to.
struct Beside {
  int body = -1;             // index in Object::bodies
  Side side = Side::kRight;  // in the frame of that body
  double front = 0;          // angle of that body's front about z, from its -y axis, rad
  double gap = 0;            // distance of the two bounding boxes along the side's direction, m
};

/// One try at a place, as drawn from `place:`. Points and directions are in the root frame.
struct PlaceTry {
  int support = -1;                // index of the body that has the region or the site
  const Region* region = nullptr;  // null: the body is placed by a site of the support
  /// Pose of the support's site, in the support, and of the body's own site, in the body: both
  /// frames will coincide. Used only if `region` is null.
  Pose X_SupportSite;
  Pose X_BodySite;
  /// Position within the free play of the footprint, each from -1 to 1; in a disc, within the unit
  /// disc.
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  std::optional<Beside> beside;
  double yaw = 0;                           // about the vertical, rad; added to `facing`
  std::optional<Eigen::Vector2d> facing;    // point that the front of the body faces, m
  double front = 0;                         // angle of the body's front, from its -y axis, rad
  std::optional<Eigen::Quaterniond> lying;  // rotation of the body before the yaw; none: upright
  double clear = 0;                         // least distance to everything else, m
  double overhang = 0;                      // share of the footprint that may lie outside, 0 .. 1
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
  Pose X_SupportBody;   // pose of the body in its support, if it stands
  int blocker = -1;     // index of the body that is too near
  double distance = 0;  // to the blocker, m; negative if they overlap
  Eigen::Vector2d footprint = Eigen::Vector2d::Zero();  // lengths of its bounding box, m
};

/// Searches places for bodies of one object.
class Placer {
 public:
  Placer() = default;
  Placer(const Placer&) = delete;
  Placer& operator=(const Placer&) = delete;
  virtual ~Placer() = default;

  /// Forgets all bodies that stand. The object must outlive the next calls; bodies may be added.
  virtual void Begin(const Object& object) = 0;

  /// Makes the body, and all bodies below it, an obstacle at its present pose.
  virtual void Stand(int body) = 0;

  /// Tries a place for a body that does not stand yet, with all bodies below it.
  virtual PlaceResult Try(int body, const PlaceTry& where) = 0;
};

}  // namespace mjforge::model
