// Placed bodies as obstacles: distances to them, and lowering of objects onto them.

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

/// Shapes that are given in a frame L, and boxes around them in a frame W. At() computes the pose
/// of a single shape in W on demand, because only shapes near an obstacle are needed. The shapes in
/// L must outlive this object.
class MovedShapes {
 public:
  MovedShapes(std::span<const distance::PlacedShape> shapes_L, const model::Pose& X_WL);

  std::size_t size() const { return shapes_L_.size(); }
  /// Returns a box that contains all shapes, and may be larger than their bounding box.
  const Eigen::AlignedBox3d& box_W() const { return box_W_; }
  /// Returns a box that contains a shape, and may be larger than its bounding box.
  const Eigen::AlignedBox3d& box_W(std::size_t index) const { return boxes_W_[index]; }
  /// Returns a shape with its pose in W.
  distance::PlacedShape At(std::size_t index) const;

 private:
  std::span<const distance::PlacedShape> shapes_L_;
  model::Pose X_WL_;
  Eigen::AlignedBox3d box_W_;
  std::vector<Eigen::AlignedBox3d> boxes_W_;
};

/// A plane on which a body is placed, and the supporting body, to which the plane belongs.
struct Support {
  int body = -1;
  Eigen::Vector3d p_W;      // a point of the plane
  Eigen::Vector3d up_W;     // normal of the plane
  bool is_ignored = false;  // true: the supporting body is no obstacle
  /// The supporting body if it was placed itself, and the placed bodies that carry it, such as the
  /// lower bowls of a stack.
  std::vector<int> below = {};
};

/// An obstacle that is too near to a body.
struct Blocker {
  int body = -1;
  double distance = 0;  // m
};

/// A contact of a shape with an obstacle.
struct Contact {
  int body = -1;                                    // body of the obstacle
  const distance::PlacedShape* obstacle = nullptr;  // valid until obstacles are added or cleared
  std::size_t shape = 0;                            // index of the shape
  bool of_boxes = false;                            // true: both shapes are boxes
  Eigen::Vector3d normal_W;                         // unit vector from the obstacle to the shape
};

/// The bodies that have places already, with the bodies below them.
class Obstacles {
 public:
  void Clear() { groups_.clear(); }

  /// Adds a body and its subtree, to which bodies placed later must keep the distance `clear`, m.
  void Add(const model::Object& object, int body, double clear);

  /// Returns the first obstacle that overlaps the shapes, or is nearer than `clear` or than the
  /// obstacle's own `clear`; nullopt if there is none. The supporting body, the bodies in
  /// Support::below, and shapes wholly below the supporting plane may be at any distance, but must
  /// not overlap the shapes. With Support::is_ignored, the supporting body may also overlap the
  /// shapes.
  std::optional<Blocker> FindBlocker(const MovedShapes& shapes, double clear,
                                     const Support& support) const;

  /// Returns the first body among `bodies`, which were passed to Add(), whose subtree overlaps the
  /// shapes; -1 if there is none.
  int FindOverlap(std::span<const distance::PlacedShape> shapes, std::span<const int> bodies) const;

  /// Returns the radius to which a cylinder can be widened until it touches an obstacle, at most
  /// `most`, m; 0 if an obstacle is nearer than 1 mm to the axis. The axis is the z axis of
  /// X_WCylinder; half_height is in m. The supporting body, and shapes wholly below the support,
  /// are no obstacles.
  double FreeRadius(const model::Pose& X_WCylinder, double half_height, double most,
                    const Support& support) const;

  /// Returns the distance by which the shapes can be moved in the direction -up_W until they touch
  /// an obstacle, at most `most`, m; 0 if they overlap an obstacle.
  double Drop(PlacedShapes shapes, const Eigen::Vector3d& up_W, double most) const;

  /// Returns all pairs of a shape and an obstacle that are at most `within` apart, m, but do not
  /// overlap.
  std::vector<Contact> FindContacts(std::span<const distance::PlacedShape> shapes,
                                    double within) const;

  /// Returns the heights of a body's lowest and highest point above a support, m. The first is at
  /// most 0 and the second at least 0, even if the body does not reach the plane of the support.
  /// Returns 0 and 0 if the body is no obstacle.
  std::pair<double, double> HeightsOf(int body, const Support& support) const;

 private:
  struct Obstacle {
    int body;
    distance::PlacedShape shape;
  };
  // A body and the bodies below it in the tree.
  struct Group {
    int body;
    double clear;
    Eigen::AlignedBox3d box_W;
    std::vector<Obstacle> obstacles;
  };

  std::vector<Group> groups_;
};

}  // namespace mjforge::placing
