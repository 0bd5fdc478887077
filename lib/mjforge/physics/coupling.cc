#include "mjforge/physics/coupling.h"

#include <algorithm>

#include "mjforge/engine/engine.h"

namespace mjforge::physics {

bool Couplings::Equality::IsLinear() const {
  return poly[1] != 0 && poly[2] == 0 && poly[3] == 0 && poly[4] == 0;
}

double Couplings::Equality::At(double value) const {
  return poly[0] + value * (poly[1] + value * (poly[2] + value * (poly[3] + value * poly[4])));
}

double Couplings::Equality::SlopeAt(double value) const {
  return poly[1] + value * (2 * poly[2] + value * (3 * poly[3] + value * 4 * poly[4]));
}

Couplings::Couplings(const mjModel& m) : coupled_(static_cast<std::size_t>(m.njnt)) {
  const auto couple = [&](int joint) {
    if (joint >= 0) coupled_[static_cast<std::size_t>(joint)] = true;
  };
  const auto couple_all = [&] { std::fill(coupled_.begin(), coupled_.end(), true); };
  for (int i = 0; i < m.neq; ++i) {
    if (m.eq_type[i] != mjEQ_JOINT) {
      couple_all();  // a weld, a loop: anything may have to move along
      break;
    }
    couple(m.eq_obj1id[i]);
    couple(m.eq_obj2id[i]);
    if (m.eq_obj2id[i] >= 0 && (m.*engine::kEqualityActive)[i] != 0)
      equalities_.push_back({m.eq_obj1id[i], m.eq_obj2id[i], m.eq_data + mjNEQDATA * i});
  }
  for (int i = 0; i < m.nwrap; ++i) {
    if (m.wrap_type[i] == mjWRAP_JOINT) couple(m.wrap_objid[i]);
    if (m.wrap_type[i] == mjWRAP_SITE) couple_all();
  }
}

std::optional<Move> Couplings::MoveOf(int joint, int driven, const Move& target) const {
  for (const Equality& equality : equalities_) {
    if (equality.x == driven && equality.y == joint) {
      const double slope = equality.SlopeAt(target.at);
      return Move{equality.At(target.at), slope * target.speed, slope * target.acceleration};
    }
    if (equality.y == driven && equality.x == joint && equality.IsLinear()) {
      const double slope = 1 / equality.poly[1];
      return Move{slope * (target.at - equality.poly[0]), slope * target.speed,
                  slope * target.acceleration};
    }
  }
  return std::nullopt;
}

}  // namespace mjforge::physics
