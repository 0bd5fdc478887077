// Bodies that stand already: distances to them, and how far an object can be lowered onto them.

#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/distance/distance.h"
#include "mjforge/placing/body_shapes.h"

namespace mjforge::placing {

/// The shapes of an object at a pose in the frame W.
using PlacedShapes = std::vector<distance::PlacedShape>;

/// Returns shapes of a body A at the pose X_WA.
PlacedShapes ShapesAt(std::span<const BodyShape> shapes, const model::Pose& X_WA);

/// A plane on which an object is put, and the body that has it.
struct Support {
  int body = -1;
  Eigen::Vector3d p_W;      // a point of the plane
  Eigen::Vector3d up_W;     // its normal
  bool is_ignored = false;  // the body may overlap
  /// Placed bodies that the body stands on, directly or not, such as the lower bowls of a stack.
  std::vector<int> below = {};
};

/// An obstacle that is too near.
struct Blocker {
  int body = -1;
  double distance = 0;  // m
};

class Obstacles {
 public:
  void Clear() { groups_.clear(); }

  /// Adds a body and all bodies below it, to which others must keep the distance `clear`.
  void Add(const model::Object& object, int body, double clear);

  /// Returns the first obstacle that overlaps the shapes, or is nearer than `clear` or its own
  /// distance. The supporting body, and what is wholly below the support, must only not overlap.
  std::optional<Blocker> FindBlocker(std::span<const distance::PlacedShape> shapes, double clear,
                                     const Support& support) const;

  /// Returns the radius to which a cylinder can be widened until it touches an obstacle, at most
  /// `most`, m; 0 if one is nearer than 1 mm to its axis. The supporting body, and what is wholly
  /// below the support, are no obstacles.
  double FreeRadius(const model::Pose& X_WCylinder, double half_height, double most,
                    const Support& support) const;

  /// Returns how far the shapes can be moved against `up_W` until they touch an obstacle, at most
  /// `most`, m; 0 if they overlap one.
  double Drop(PlacedShapes shapes, const Eigen::Vector3d& up_W, double most) const;

  /// Returns the heights of a body's lowest and highest point above a support, m; 0 and 0 if the
  /// body is no obstacle.
  std::pair<double, double> HeightsOf(int body, const Support& support) const;

 private:
  struct Obstacle {
    int body;
    distance::PlacedShape shape;
  };
  // A body and the bodies below it.
  struct Group {
    double clear;
    Eigen::AlignedBox3d box_W;
    std::vector<Obstacle> obstacles;
  };

  std::vector<Group> groups_;
};

}  // namespace mjforge::placing
