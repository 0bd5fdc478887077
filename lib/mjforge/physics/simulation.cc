#include "mjforge/physics/simulation.h"

#include <algorithm>
#include <span>

#include "mjforge/engine/engine.h"

namespace mjforge::physics {
namespace {

constexpr int kMostContacts = 10'000;  // of 600 bytes

}  // namespace

mjData& Workspace::For(const mjModel& m) {
  // All numbers of mjModel that mjData's arrays depend on stand before nbuffer.
  const auto sizes = std::as_bytes(std::span(&m, 1)).first(offsetof(mjModel, nbuffer));
  if (data_ && std::ranges::equal(sizes, sizes_)) {
    mj_resetData(&m, data_.get());
    return *data_;
  }
  data_.reset();
  data_ = compiled::MakeData(m);
  sizes_.assign(sizes.begin(), sizes.end());
  return *data_;
}

bool MakeRoom(mjModel& m, const mjData& d) {
  const bool crowded =
      d.warning[mjWARN_CONTACTFULL].number > 0 || d.warning[mjWARN_CNSTRFULL].number > 0;
  engine::BufferSizes room = engine::BufferSizesOf(m);
  if (!crowded || room.contacts >= kMostContacts) return false;
  room.contacts = std::min(4 * std::max(room.contacts, 100), kMostContacts);
  room.rows = std::max(room.rows, 500) + 4 * room.contacts;  // pyramids of condim 3
  // As for mjcf's sizes: linear in the contacts for a body or a few.
  room.numbers += 4000.0 * room.contacts * std::max(1.0, static_cast<double>(m.nv) / 24.0);
  engine::SetBufferSizes(m, room);
  return true;
}

Fastest FastestPoint(const mjModel& m, const mjData& d) {
  Fastest fastest;
  for (int i = 0; i < m.ngeom; ++i) {
    const int body = m.geom_bodyid[i];
    if (m.body_weldid[body] == 0) continue;
    // MuJoCo's cvel is about the centre of mass of the whole tree, rotation first.
    const mjtNum* cvel = d.cvel + 6 * body;
    const Eigen::Map<const Eigen::Vector3d> turn(cvel);
    const Eigen::Map<const Eigen::Vector3d> move(cvel + 3);
    const Eigen::Vector3d arm =
        compiled::VectorAt(d.geom_xpos, i) - compiled::VectorAt(d.subtree_com, m.body_rootid[body]);
    const double speed = (move + turn.cross(arm)).norm() + turn.norm() * m.geom_rbound[i];
    if (speed > fastest.speed) fastest = {speed, body};
  }
  return fastest;
}

double DeepestContact(const mjData& d) {
  double deepest = 0;
  for (int i = 0; i < d.ncon; ++i) deepest = std::max(deepest, -d.contact[i].dist);
  return deepest;
}

bool HasBlownUp(const mjData& d) {
  return d.warning[mjWARN_BADQPOS].number > 0 || d.warning[mjWARN_BADQVEL].number > 0 ||
         d.warning[mjWARN_BADQACC].number > 0;
}

std::vector<std::string> WarningsOf(const mjData& d) {
  std::vector<std::string> warnings;
  for (int i = 0; i < mjNWARNING; ++i) {
    if (d.warning[i].number > 0) warnings.emplace_back(mju_warningText(i, d.warning[i].lastinfo));
  }
  return warnings;
}

}  // namespace mjforge::physics
