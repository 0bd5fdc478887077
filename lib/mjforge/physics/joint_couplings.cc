// Finds the joints that equalities and tendons couple, and the motions that equalities of joints
// require.
#include "mjforge/physics/joint_couplings.h"

#include <algorithm>

#include "mjforge/engine/engine.h"

namespace mjforge::physics {

bool JointEquality::IsLinear() const {
  return poly[1] != 0 && poly[2] == 0 && poly[3] == 0 && poly[4] == 0;
}

double JointEquality::At(double value) const {
  return poly[0] + value * (poly[1] + value * (poly[2] + value * (poly[3] + value * poly[4])));
}

double JointEquality::SlopeAt(double value) const {
  return poly[1] + value * (2 * poly[2] + value * (3 * poly[3] + value * 4 * poly[4]));
}

JointEquality JointEqualityAt(const mjModel& m, int equality) {
  return {m.eq_obj1id[equality], m.eq_obj2id[equality], m.eq_data + mjNEQDATA * equality};
}

JointCouplings::JointCouplings(const mjModel& m) : coupled_(static_cast<std::size_t>(m.njnt)) {
  const auto couple = [&](int joint) {
    if (joint >= 0) coupled_[static_cast<std::size_t>(joint)] = true;
  };
  const auto couple_all = [&] { std::fill(coupled_.begin(), coupled_.end(), true); };
  for (int i = 0; i < m.neq; ++i) {
    if (m.eq_type[i] != mjEQ_JOINT) {
      couple_all();  // an equality of bodies or tendons may couple any joints
      continue;
    }
    couple(m.eq_obj1id[i]);
    couple(m.eq_obj2id[i]);
    if (m.eq_obj2id[i] >= 0 && (m.*engine::kEqualityActive)[i] != 0)
      equalities_.push_back(JointEqualityAt(m, i));
  }
  for (int i = 0; i < m.nwrap; ++i) {
    if (m.wrap_type[i] == mjWRAP_JOINT) couple(m.wrap_objid[i]);
    if (m.wrap_type[i] == mjWRAP_SITE) couple_all();
  }
}

std::optional<Setpoint> JointCouplings::SetpointOf(int joint, int driven,
                                                   const Setpoint& target) const {
  for (const JointEquality& equality : equalities_) {
    if (equality.x == driven && equality.y == joint) {
      const double slope = equality.SlopeAt(target.position);
      return Setpoint{equality.At(target.position), slope * target.speed,
                      slope * target.acceleration};
    }
    if (equality.y == driven && equality.x == joint && equality.IsLinear()) {
      const double slope = 1 / equality.poly[1];
      return Setpoint{slope * (target.position - equality.poly[0]), slope * target.speed,
                      slope * target.acceleration};
    }
  }
  return std::nullopt;
}

}  // namespace mjforge::physics
