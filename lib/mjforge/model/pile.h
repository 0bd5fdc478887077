// Piles: bodies that are released above a region and come to rest on each other.

#pragma once

#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/model/region.h"

namespace mjforge::model {

/// Bodies that fall into a region in a simulation with MuJoCo. Their poses when they come to rest
/// become their start poses.
struct Pile {
  /// Largest penetration depth at rest, m. The depth is not 0, because MuJoCo's contacts are soft.
  static constexpr double kMostDepth = 0.002;

  struct Item {
    int body = -1;  // index in Object::bodies of a free body
    /// Orientation of the body at its release, in the object's frame.
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    /// Position of the body's centre of mass at its release: two numbers from -1 to 1, which span
    /// the positions at which the body's bounding sphere is inside the region. In a disc, a point
    /// of the unit disc.
    Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  };
  std::string at;    // name of the region in the spec: "crate.inside"
  int support = -1;  // index of the body to which the region belongs
  Region region;
  // True: bodies are released by decreasing size; false: in the order of `items`.
  bool is_big_first = true;
  double time = 3;  // s, time limit for coming to rest after the last release
  std::vector<Item> items;
  diag::SourceMark mark;
};

}  // namespace mjforge::model
