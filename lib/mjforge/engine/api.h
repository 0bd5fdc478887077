#pragma once

// MuJoCo's programming interface, as one for its releases 2.2 to 4.0: what differs between them has
// a name here, and no other file asks which release it is compiled with.
//
// Releases are compared by MuJoCo's own mjVERSION_HEADER: 222 is 2.2.2, 337 is 3.3.7 and, with
// seven digits from 3.5 on, 3005000 is 3.5.0, so that a later release always has the larger number.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <mujoco/mujoco.h>

namespace mjforge::engine {

/// Of the library that runs: "3.3.7".
inline std::string Version() { return mj_versionString(); }

using Flag = std::remove_pointer_t<decltype(mjModel::jnt_limited)>;  // mjtByte; from 3.7 mjtBool
using Count = decltype(mjModel::ngeom);                              // int; from 3.4 mjtSize

#if mjVERSION_HEADER >= 300
/// Of each equality: whether it holds at the start.
inline constexpr auto kEqualityActive = &mjModel::eq_active0;
#else
inline constexpr auto kEqualityActive = &mjModel::eq_active;
#endif

/// Of each light: 1 if it is directional.
#if mjVERSION_HEADER >= 333
inline constexpr auto kLightDirectional = &mjModel::light_type;
inline void MakeDirectional(mjvLight& light) { light.type = mjLIGHT_DIRECTIONAL; }
#else
inline constexpr auto kLightDirectional = &mjModel::light_directional;
inline void MakeDirectional(mjvLight& light) { light.directional = 1; }
#endif

/// The texture of a material's colour; -1: it has none.
inline int TextureOf(const mjModel& m, int material) {
#if mjVERSION_HEADER >= 321
  return m.mat_texid[mjNTEXROLE * material + mjTEXROLE_RGB];
#else
  return m.mat_texid[material];
#endif
}

/// The bytes of a texture, row by row.
inline std::span<const mjtByte> PixelsOf(const mjModel& m, int texture) {
#if mjVERSION_HEADER >= 321
  const mjtByte* data = m.tex_data;
  const int channels = m.tex_nchannel[texture];
#else
  const mjtByte* data = m.tex_rgb;
  constexpr int channels = 3;
#endif
  const int pixels = m.tex_width[texture] * m.tex_height[texture];
  return {data + m.tex_adr[texture], static_cast<std::size_t>(channels * pixels)};
}

/// Leaves a geom its colour alone.
inline void TakeTexture(mjvGeom& geom) {
#if mjVERSION_HEADER >= 320
  geom.matid = -1;
#else
  geom.texid = -1;
#endif
}

/// MJCF's word for a number of mjtDyn, mjtGain or mjtBias.
std::string_view WordOf(mjtDyn dynamics);
std::string_view WordOf(mjtGain gain);
std::string_view WordOf(mjtBias bias);

/// The bits of mjOption::disableflags that switch springs and dampers off.
#if mjVERSION_HEADER >= 336
inline constexpr int kDisablePassive = mjDSBL_SPRING | mjDSBL_DAMPER;
#else
inline constexpr int kDisablePassive = mjDSBL_PASSIVE;
#endif

/// For after a geom was moved or may collide with more than when it was compiled: later releases
/// keep where a body's geoms are, and what they collide with.
inline void TellBody([[maybe_unused]] mjModel& m, [[maybe_unused]] int geom) {
#if mjVERSION_HEADER >= 233
  m.opt.disableflags |= mjDSBL_MIDPHASE;
#endif
#if mjVERSION_HEADER >= 300
  m.body_contype[m.geom_bodyid[geom]] |= m.geom_contype[geom];
  m.body_conaffinity[m.geom_bodyid[geom]] |= m.geom_conaffinity[geom];
#endif
}

/// Several contact points where convex surfaces meet; from 3.8 on MuJoCo finds them unless told not
/// to.
inline void EnableMultipleContacts(mjOption& option) {
#if mjVERSION_HEADER >= 3008000
  option.disableflags &= ~mjDSBL_MULTICCD;
#else
  option.enableflags |= mjENBL_MULTICCD;
#endif
}

/// Forces that fit to the last digits. From 3.0 on the solver stops too early where light bodies
/// are pressed between heavy ones, which then shake.
inline void SolveClosely([[maybe_unused]] mjOption& option) {
#if mjVERSION_HEADER >= 300
  option.tolerance = 1e-14;
#endif
}

/// The two bodies of an <exclude>; until 2.3 each is kept plus one.
inline std::pair<int, int> ExcludedBodies(const mjModel& m, int exclude) {
  constexpr int kFirst = mjVERSION_HEADER >= 300 ? 0 : 1;
  const int signature = m.exclude_signature[exclude];
  return {(signature >> 16) - kFirst, (signature & 0xFFFF) - kFirst};
}

/// The diagonal of the joint space's inertia at a degree of freedom, kg or kg m^2.
inline mjtNum DofInertia([[maybe_unused]] const mjModel& m, const mjData& d, int dof) {
#if mjVERSION_HEADER >= 3011000
  return d.M[m.M_rowadr[dof] + m.M_rownnz[dof] - 1];  // a row ends at its diagonal
#else
  return d.qM[m.dof_Madr[dof]];
#endif
}

/// The dense inertia, nv x nv.
template <class Model, class Data>
void FullInertia(const Model& m, const Data& d, mjtNum* inertia) {
  if constexpr (requires { mj_fullM(&m, &d, inertia); }) {
    mj_fullM(&m, &d, inertia);
  } else {
    mj_fullM(&m, inertia, d.qM);
  }
}

/// mj_rayMesh and mju_rayGeom, which from 3.5 can tell the normal, too.
template <class... Arguments>
mjtNum RayMesh(Arguments... arguments) {
  if constexpr (requires { mj_rayMesh(arguments...); }) {
    return mj_rayMesh(arguments...);
  } else {
    return mj_rayMesh(arguments..., nullptr);
  }
}
template <class... Arguments>
mjtNum RayGeom(Arguments... arguments) {
  if constexpr (requires { mju_rayGeom(arguments...); }) {
    return mju_rayGeom(arguments...);
  } else {
    return mju_rayGeom(arguments..., nullptr);
  }
}

/// What mj_makeData makes room for.
struct Room {
  int contacts = 0;    // -1: as many as the memory holds
  int rows = 0;        // of constraints
  double numbers = 0;  // on the stack
};
Room RoomOf(const mjModel& m);
/// From 2.3 on, contacts, rows and stack share one memory, an arena.
void SetRoom(mjModel& m, const Room& room);

}  // namespace mjforge::engine
