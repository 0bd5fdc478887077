// Finds contacts between bodies, and enlarges the contact buffer of the model when the buffer is
// full.
#include "mjforge/validate/contact_finder.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mjforge/engine/engine.h"

namespace mjforge::validate {
namespace {

// Largest number of contacts in the buffer: about 120 MB, because a contact has about 600 bytes.
constexpr int kMostContacts = 200'000;

/// Returns the stack size, in mjtNum, that mj_kinematics, mj_comPos and mj_collision (2.2.2) need
/// at most: three lists with a number for each pair of bodies, and some numbers per body.
double StackSize(const mjModel& m) {
  const auto bodies = static_cast<double>(m.nbody);
  return 1.5 * bodies * bodies + 200 * bodies + 20'000;
}

}  // namespace

ContactFinder::ContactFinder(mjModel& model) : model_(model) {
  // Reserves no constraint rows, because they need most memory, and collision detection does not
  // use them.
  engine::SetBufferSizes(model_, {.contacts = room_, .rows = 0, .numbers = StackSize(model)});
  data_ = compiled::MakeData(model_);
  Move();
}

void ContactFinder::Move() {
  mj_kinematics(&model_, data_.get());
  mj_comPos(&model_, data_.get());
}

void ContactFinder::Collide() {
  mj_collision(&model_, data_.get());
  while (data_->warning[mjWARN_CONTACTFULL].number > 0 && room_ < kMostContacts) {
    const std::vector<mjtNum> here(qpos().begin(), qpos().end());
    room_ = std::min(8 * room_, kMostContacts);
    engine::SetBufferSizes(model_, {.contacts = room_, .rows = 0, .numbers = StackSize(model_)});
    data_ = compiled::MakeData(model_);
    std::ranges::copy(here, qpos().begin());
    Move();
    mj_collision(&model_, data_.get());
  }
}

const std::vector<BodyContact>& ContactFinder::Find() {
  contacts_.clear();
  // Skips models with a single body, because all contacts of this body are with the world.
  if (model_.nbody <= 2) return contacts_;
  Collide();
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    // Skips contacts at a positive distance to which MuJoCo applies no force, for example within
    // the gap. Keeps contacts at distance 0, although MuJoCo may apply no force to them, either.
    if (contact.dist > 0 && contact.exclude != 0) continue;
    BodyContact found = {model_.geom_bodyid[contact.geom1],
                         model_.geom_bodyid[contact.geom2],
                         contact.geom1,
                         contact.geom2,
                         contact.dist,
                         contact.includemargin};
    if (found.body1 == 0 || found.body2 == 0) continue;
    if (found.body1 > found.body2) {
      std::swap(found.body1, found.body2);
      std::swap(found.geom1, found.geom2);
    }
    contacts_.push_back(found);
  }
  std::ranges::sort(contacts_, [](const BodyContact& a, const BodyContact& b) {
    return std::tie(a.body1, a.body2, a.distance, a.geom1, a.geom2) <
           std::tie(b.body1, b.body2, b.distance, b.geom1, b.geom2);
  });
  const auto same_bodies = [](const BodyContact& a, const BodyContact& b) {
    return a.body1 == b.body1 && a.body2 == b.body2;
  };
  contacts_.erase(std::unique(contacts_.begin(), contacts_.end(), same_bodies), contacts_.end());
  return contacts_;
}

}  // namespace mjforge::validate
