#pragma once

// The contacts that MuJoCo finds between the bodies of a compiled model.

#include <span>
#include <vector>

#include "mjforge/compiled/compiled.h"

namespace mjforge::validate {

/// The deepest contact of two bodies, by MuJoCo's numbers.
struct BodyContact {
  int body1 = 0;  // below body2
  int body2 = 0;
  int geom1 = 0;  // of body1
  int geom2 = 0;
  double distance = 0;  // m; below 0: they are that deep in each other
  double margin = 0;    // m; MuJoCo pushes below this distance
};

/// Places a model's bodies and finds what touches. MuJoCo decides which bodies can touch, by its
/// filters for parents and welded bodies, excludes, pairs, contact bits. Its functions throw
/// std::exception where MuJoCo gives up.
class ContactFinder {
 public:
  /// The model must outlive the finder, which changes how much room the model has for contacts. The
  /// joints start at zero.
  explicit ContactFinder(mjModel& model);

  /// The joint positions as MuJoCo stores them. Call Move() after a change.
  std::span<mjtNum> qpos() { return {data_->qpos, static_cast<std::size_t>(model_.nq)}; }
  /// Takes the bodies to where qpos says.
  void Move();
  const mjData& data() const { return *data_; }

  /// The pairs of bodies that touch, the deepest contact of each, in the order of their numbers:
  /// penetrating, at distance 0, or within a margin where MuJoCo pushes already. Contacts with the
  /// world are left out. Valid until the next call.
  const std::vector<BodyContact>& Find();

 private:
  void Collide();

  mjModel& model_;
  int room_ = 25;  // for contacts, at first
  compiled::Data data_;
  std::vector<BodyContact> contacts_;
};

}  // namespace mjforge::validate
