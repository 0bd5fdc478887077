// Contacts that MuJoCo finds between the bodies of a compiled model.
#pragma once

#include <span>
#include <vector>

#include "mjforge/compiled/compiled.h"

namespace mjforge::validate {

/// The deepest contact of two bodies. Ids are those of MuJoCo.
struct BodyContact {
  int body1 = 0;  // less than body2
  int body2 = 0;
  int geom1 = 0;  // geom of body1
  int geom2 = 0;
  double distance = 0;  // m; negative: penetration depth
  double margin = 0;    // m; contact forces begin at this distance
};

/// Computes poses of bodies, and contacts between bodies. MuJoCo decides which bodies can touch: it
/// filters parents with their children, and welded bodies, and applies `<exclude>`, `<pair>` and
/// contact bits. The functions throw std::exception if MuJoCo fails.
class ContactFinder {
 public:
  /// Changes the size of the model's contact buffer. Joints start at qpos0. The model must outlive
  /// this object.
  explicit ContactFinder(mjModel& model);

  /// The positions of the joints, mjData::qpos. Call Move() after a change.
  std::span<mjtNum> qpos() { return {data_->qpos, static_cast<std::size_t>(model_.nq)}; }
  /// Computes the poses of the bodies from qpos.
  void Move();
  const mjData& data() const { return *data_; }

  /// Returns the deepest contact of each pair of bodies that touch, in the order of the bodies'
  /// ids. Bodies touch if they penetrate, are at distance 0, or are within a margin in which MuJoCo
  /// applies forces. Contacts with the world are left out. The result is valid until the next call.
  const std::vector<BodyContact>& Find();

 private:
  void Collide();

  mjModel& model_;
  int room_ = 25;  // number of contacts in the buffer; grows when needed
  compiled::Data data_;
  std::vector<BodyContact> contacts_;
};

}  // namespace mjforge::validate
