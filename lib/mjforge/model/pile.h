// Piles: bodies that are released above a region and come to rest on each other.

#pragma once

#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/model/region.h"

namespace mjforge::model {

/// Bodies that a simulation of MuJoCo brings to rest in a region. Their rest is their start.
struct Pile {
  /// Greatest depth of contacts at rest, m: MuJoCo's contacts are soft.
  static constexpr double kMostDepth = 0.002;

  struct Item {
    int body = -1;  // index in Object::bodies; a free body
    /// Orientation at its release, in the object's frame.
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    /// Position of its centre of mass at its release, from -1 to 1, within the free play of its
    /// bounding sphere in the region; in a disc, within the unit disc.
    Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  };
  std::string at;    // the region, as in the spec: "crate.inside"
  int support = -1;  // index of the body that has the region
  Region region;
  bool is_big_first = true;  // sorted by size; otherwise in the order of `items`
  double time = 3;           // s, that the bodies may take to come to rest after the last release
  std::vector<Item> items;
  diag::SourceMark mark;
};

}  // namespace mjforge::model
