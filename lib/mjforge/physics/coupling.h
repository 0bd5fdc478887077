#pragma once

#include <optional>
#include <vector>

#include <mujoco/mujoco.h>

namespace mjforge::physics {

/// Where something is to be, how fast it is to move and by what acceleration.
struct Move {
  double at = 0;
  double speed = 0;         // 1/s
  double acceleration = 0;  // 1/s^2
};

/// What makes joints of a model move along with others: equalities and tendons. `m` must outlive
/// it.
class Couplings {
 public:
  explicit Couplings(const mjModel& m);

  /// Whether something may move the joint as others move, or others with it.
  bool IsCoupled(int joint) const { return coupled_[static_cast<std::size_t>(joint)]; }

  /// Where an equality has a joint go with one that is driven, both counted from the model's own
  /// pose; nothing if it leaves that open.
  std::optional<Move> MoveOf(int joint, int driven, const Move& target) const;

 private:
  /// Equality of two joints: y = poly(x).
  struct Equality {
    int y = 0;
    int x = 0;
    const mjtNum* poly = nullptr;

    bool IsLinear() const;
    double At(double value) const;
    double SlopeAt(double value) const;
  };

  std::vector<bool> coupled_;
  std::vector<Equality> equalities_;
};

}  // namespace mjforge::physics
