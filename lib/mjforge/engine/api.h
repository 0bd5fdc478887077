// Compatibility layer over MuJoCo's C API for releases 2.2 to 4.0: one name for each function,
// member, type or constant that differs between releases.
//
// Releases are compared by MuJoCo's own mjVERSION_HEADER: 222 is 2.2.2, 337 is 3.3.7 and, with
// seven digits from 3.5 on, 3005000 is 3.5.0, so that a later release always has the larger number.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <mujoco/mujoco.h>

namespace mjforge::engine {

/// Returns the version of the MuJoCo library in use: "3.3.7".
inline std::string Version() { return mj_versionString(); }

using Flag = std::remove_pointer_t<decltype(mjModel::jnt_limited)>;  // mjtByte; from 3.7 mjtBool
using Count = decltype(mjModel::ngeom);                              // int; from 3.4 mjtSize

#if mjVERSION_HEADER >= 300
/// Array of mjModel with a flag for each equality: 1 if the equality is active at the start.
inline constexpr auto kEqualityActive = &mjModel::eq_active0;
#else
inline constexpr auto kEqualityActive = &mjModel::eq_active;
#endif

/// Returns the bodies of a connect or weld or, from 3.2.3 on, of the two sites that it connects.
inline std::pair<int, int> BodiesOfEquality(const mjModel& m, int equality) {
  const int first = m.eq_obj1id[equality];
  const int second = m.eq_obj2id[equality];
#if mjVERSION_HEADER >= 323
  if (m.eq_objtype[equality] == mjOBJ_SITE) return {m.site_bodyid[first], m.site_bodyid[second]};
#endif
  return {first, second};
}

/// Array of mjModel with a number for each light: 1 if the light is directional.
#if mjVERSION_HEADER >= 333
inline constexpr auto kLightDirectional = &mjModel::light_type;
inline void MakeDirectional(mjvLight& light) { light.type = mjLIGHT_DIRECTIONAL; }
#else
inline constexpr auto kLightDirectional = &mjModel::light_directional;
inline void MakeDirectional(mjvLight& light) { light.directional = 1; }
#endif

/// Returns the id of a material's colour texture; -1 if it has none.
inline int TextureOf(const mjModel& m, int material) {
#if mjVERSION_HEADER >= 321
  return m.mat_texid[mjNTEXROLE * material + mjTEXROLE_RGB];
#else
  return m.mat_texid[material];
#endif
}

/// Returns the pixels of a texture, row by row, in tex_nchannel bytes each (3 before 3.2.1).
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

/// Removes the texture of a geom in an abstract scene (mjvScene), but keeps the colour of the geom.
inline void RemoveTexture(mjvGeom& geom) {
#if mjVERSION_HEADER >= 320
  geom.matid = -1;
#else
  geom.texid = -1;
#endif
}

/// Calls mj_ray, mj_rayMesh or mju_rayGeom, which from 3.5 on have one more output (normal).
template <class Ray, class... Arguments>
mjtNum CastRay(Ray ray, Arguments... arguments) {
  if constexpr (std::is_invocable_v<Ray, Arguments...>) {
    return ray(arguments...);
  } else {
    return ray(arguments..., nullptr);
  }
}

/// Returns the MJCF keyword of an mjtDyn, mjtGain or mjtBias; "user" for types without a keyword
/// here.
std::string_view WordOf(mjtDyn dynamics);
std::string_view WordOf(mjtGain gain);
std::string_view WordOf(mjtBias bias);

/// Bits of mjOption::disableflags that disable springs and dampers.
#if mjVERSION_HEADER >= 336
inline constexpr int kDisablePassive = mjDSBL_SPRING | mjDSBL_DAMPER;
#else
inline constexpr int kDisablePassive = mjDSBL_PASSIVE;
#endif

/// Prepares collision detection for a geom that was moved, or whose contype or conaffinity gained
/// bits. From 2.3.3 on, disables the mid-phase, because its bounding volume hierarchies are
/// outdated. From 3.0 on, also adds the bits to those that MuJoCo stores for the body of the geom.
inline void UpdateCollisionData([[maybe_unused]] mjModel& m, [[maybe_unused]] int geom) {
#if mjVERSION_HEADER >= 233
  m.opt.disableflags |= mjDSBL_MIDPHASE;
#endif
#if mjVERSION_HEADER >= 300
  m.body_contype[m.geom_bodyid[geom]] |= m.geom_contype[geom];
  m.body_conaffinity[m.geom_bodyid[geom]] |= m.geom_conaffinity[geom];
#endif
}

/// Enables several contact points between two convex geoms (MULTICCD), which is the default from
/// 3.8 on.
inline void EnableMultipleContacts(mjOption& option) {
#if mjVERSION_HEADER >= 3008000
  option.disableflags &= ~mjDSBL_MULTICCD;
#else
  option.enableflags |= mjENBL_MULTICCD;
#endif
}

/// Returns mjOption::enableflags without mjENBL_MULTICCD, a bit that releases from 3.8 on do not
/// have.
inline int EnableFlags(const mjOption& option) {
#if mjVERSION_HEADER >= 3008000
  return option.enableflags;
#else
  return option.enableflags & ~mjENBL_MULTICCD;
#endif
}

/// Lowers the tolerance of the constraint solver from 3.0 on, because the default tolerance of
/// these releases is so large that light bodies shake if they are pressed between heavy bodies.
inline void TightenTolerance([[maybe_unused]] mjOption& option) {
#if mjVERSION_HEADER >= 300
  option.tolerance = 1e-14;
#endif
}

/// Returns the two bodies of an `<exclude>`. Up to 2.3, MuJoCo stores the ids plus one.
inline std::pair<int, int> ExcludedBodies(const mjModel& m, int exclude) {
  constexpr int kFirst = mjVERSION_HEADER >= 300 ? 0 : 1;
  const int signature = m.exclude_signature[exclude];
  return {(signature >> 16) - kFirst, (signature & 0xFFFF) - kFirst};
}

/// Returns the diagonal element of the joint-space inertia matrix for a degree of freedom, kg or
/// kg m^2.
inline mjtNum DofInertia([[maybe_unused]] const mjModel& m, const mjData& d, int dof) {
#if mjVERSION_HEADER >= 3011000
  return d.M[m.M_rowadr[dof] + m.M_rownnz[dof] - 1];  // a row ends at its diagonal
#else
  return d.qM[m.dof_Madr[dof]];
#endif
}

/// True if mjData has separate buffers of fixed sizes for contacts, constraint rows and the stack,
/// as in 2.2; from 2.3 on, all share one arena.
inline constexpr bool kHasFixedBuffers = mjVERSION_HEADER < 230;

/// Sizes of the buffers that mj_makeData allocates.
struct BufferSizes {
  int contacts = 0;    // largest number; -1: limited only by the memory
  int rows = 0;        // constraint rows
  double numbers = 0;  // size of the stack (from 3.0 on, of the arena) in units of mjtNum
};
BufferSizes BufferSizesOf(const mjModel& m);
/// Sets the sizes for the next call of mj_makeData.
void SetBufferSizes(mjModel& m, const BufferSizes& sizes);

}  // namespace mjforge::engine
