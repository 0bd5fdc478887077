#pragma once

// MJCF's attributes and where mjModel keeps them: one table for who reads a compiled model and for
// who compares it.

#include <array>
#include <span>
#include <string_view>
#include <variant>

#include <mujoco/mujoco.h>

#include "mjforge/engine/engine.h"
#include "mjforge/model/model.h"
#include "mjforge/sample/sample.h"

namespace mjforge::compiled {

/// One attribute of a kind of element.
struct ArrayField {
  using Flags = engine::Flag* mjModel::*;
  enum class Rows { kElement, kDof, kQpos };  // of a joint: its first one; kQpos: of a scalar one

  std::string_view attribute;
  std::variant<mjtNum * mjModel::*, float * mjModel::*, int * mjModel::*, Flags> array;
  int count = 1;  // numbers of an element
  /// What MuJoCo takes where nothing is said; nothing: there is no such number.
  std::optional<std::array<double, 6>> usual = std::array<double, 6>{};
  Rows rows = Rows::kElement;
  Flags needs = nullptr;                       // without this flag the attribute says nothing
  engine::Count mjModel::*variable = nullptr;  // in place of `count`: user data

  /// A light's kind is a number from MuJoCo 3.3.3 on.
  bool IsFlag() const { return std::holds_alternative<Flags>(array) || attribute == "directional"; }
  bool IsFloat() const { return std::holds_alternative<float * mjModel::*>(array); }
};

/// In the order in which files have them: of geoms, joints, sites, cameras, lights, tendons,
/// actuators, pairs, equalities, sensors, materials and bodies; none of other kinds.
std::span<const ArrayField> ArrayFields(mjtObj kind);

/// Floats as the shortest numbers that give them; user data without the zeros at the end. None, if
/// the attribute says nothing of this element.
sample::Numbers NumbersOf(const mjModel& m, const ArrayField& field, int id);

/// What an actuator acts on, in the order of mjtTrn.
struct Transmission {
  mjtObj kind;
  std::string_view first;
  std::string_view second;  // a site; empty: there is none
};
inline constexpr Transmission kTransmissions[] = {{mjOBJ_JOINT, "joint", ""},
                                                  {mjOBJ_JOINT, "jointinparent", ""},
                                                  {mjOBJ_SITE, "cranksite", "slidersite"},
                                                  {mjOBJ_TENDON, "tendon", ""},
                                                  {mjOBJ_SITE, "site", "refsite"},
                                                  {mjOBJ_BODY, "body", ""}};

/// What an equality makes equal, in the order of mjtEq.
struct Equality {
  std::string_view tag;
  mjtObj kind;
  std::string_view first;
  std::string_view second;
};
inline constexpr Equality kEqualities[] = {{"connect", mjOBJ_BODY, "body1", "body2"},
                                           {"weld", mjOBJ_BODY, "body1", "body2"},
                                           {"joint", mjOBJ_JOINT, "joint1", "joint2"},
                                           {"tendon", mjOBJ_TENDON, "tendon1", "tendon2"}};

/// One piece of a tendon's path.
struct Wrap {
  std::string_view tag;  // joint pulley site geom
  mjtObj kind = mjOBJ_UNKNOWN;
  int object = -1;  // a pulley has none
  int side = -1;    // a site
};
Wrap WrapAt(const mjModel& m, int wrap);

}  // namespace mjforge::compiled
