// Allocates mjData, enlarges the buffers for contacts, and measures the state of a simulation.
#include "mjforge/physics/simulation.h"

#include <algorithm>
#include <span>

#include "mjforge/engine/engine.h"

namespace mjforge::physics {
namespace {

constexpr int kMostContacts = 10'000;  // largest size of the contact buffer; 600 bytes per contact
// Largest size, bytes, of the constraint matrices, because MuJoCo clears them in each reset.
constexpr double kMostBytes = 1e9;

}  // namespace

mjData& Workspace::For(const mjModel& m) {
  // Compares the numbers that mjModel declares before nbuffer, because the sizes of mjData depend
  // only on these numbers.
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

bool IsCrowded(const mjData& d) {
  return d.warning[mjWARN_CONTACTFULL].number > 0 || d.warning[mjWARN_CNSTRFULL].number > 0;
}

void MakeRoom(mjModel& m) {
  engine::BufferSizes room = engine::BufferSizesOf(m);
  room.contacts = 2 * std::max(room.contacts, 100);
  room.rows = 2 * std::max(room.rows, 500);  // four rows per contact of condim 3, and some more
  // MuJoCo 2.2 stores a square matrix of the constraint rows, and the Jacobian with its transpose,
  // each number (8 bytes) with an index (4 bytes).
  const double bytes = engine::kHasFixedBuffers ? 12.0 * room.rows * (room.rows + 2.0 * m.nv) : 0;
  if (room.contacts > kMostContacts || bytes > kMostBytes)
    throw BuffersTooLarge("too many contacts");
  // Stack size, in mjtNum: linear in the number of contacts if the model has few degrees of
  // freedom, by the rule of mjcf/size_element.cc.
  room.numbers += 4000.0 * room.contacts * std::max(1.0, static_cast<double>(m.nv) / 24.0);
  engine::SetBufferSizes(m, room);
}

FastestBody FindFastestBody(const mjModel& m, const mjData& d) {
  FastestBody fastest;
  for (int i = 0; i < m.ngeom; ++i) {
    const int body = m.geom_bodyid[i];
    if (m.body_weldid[body] == 0) continue;
    // MuJoCo's cvel is a body's velocity at the centre of mass of its whole tree, angular part
    // first.
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

std::vector<int> FreeBodies(const mjModel& m) {
  std::vector<int> bodies;
  for (int joint = 0; joint < m.njnt; ++joint) {
    if (m.jnt_type[joint] == mjJNT_FREE) bodies.push_back(m.jnt_bodyid[joint]);
  }
  return bodies;
}

model::Box3 CollidingBox(const mjModel& m, const mjData& d, const std::vector<int>& roots) {
  model::Box3 all;
  for (const int root : roots) {
    all.Add(compiled::CollidingBox(m, d, root));
  }
  return all;
}

double DeepestContact(const mjData& d) {
  double deepest = 0;
  for (const mjContact& contact : ContactsOf(d)) deepest = std::max(deepest, -contact.dist);
  return deepest;
}

bool HasDiverged(const mjData& d) {
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
