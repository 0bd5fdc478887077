// Table of MJCF attributes and of the arrays of mjModel that contain them, for reading and
// comparing compiled models.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <variant>

#include <mujoco/mujoco.h>

#include "mjforge/engine/engine.h"
#include "mjforge/model/model.h"
#include "mjforge/sample/sample.h"

namespace mjforge::compiled {

/// Attribute of an element kind, and the array of mjModel that contains its values.
struct ArrayField {
  using Flags = engine::Flag* mjModel::*;
  /// Row of the array: the element's id, the first degree of freedom of a joint, or the first
  /// number of a joint in qpos. kQpos is for hinges and slides only.
  enum class Rows { kElement, kDof, kQpos };

  std::string_view attribute;
  std::variant<mjtNum * mjModel::*, float * mjModel::*, int * mjModel::*, Flags> array;
  int count = 1;  // numbers per element
  /// MuJoCo's default; nullopt if the attribute has no default.
  std::optional<std::array<double, 6>> usual = std::array<double, 6>{};
  Rows rows = Rows::kElement;
  Flags needs = nullptr;  // array of flags that enable the attribute; null: none
  // Member with the number of user values (nuser_geom, ...), instead of `count`; null: none.
  engine::Count mjModel::*variable = nullptr;

  /// Returns true for attributes with the values true and false. `directional` of lights is
  /// included, although it is a number in mjModel since 3.3.3.
  bool IsFlag() const { return std::holds_alternative<Flags>(array) || attribute == "directional"; }
  bool IsFloat() const { return std::holds_alternative<float * mjModel::*>(array); }
};

/// Returns the attributes of geoms, joints, sites, cameras, lights, tendons, actuators, pairs,
/// equalities, sensors, materials or bodies, in the order of the table; empty for other kinds of
/// elements.
std::span<const ArrayField> ArrayFields(mjtObj kind);

/// Returns the numbers of an attribute; empty if the attribute does not apply to this element. A
/// float becomes the shortest decimal that reads back as this float (0.1, not 0.100000001).
/// Trailing zeros of user data are left out.
sample::Numbers NumbersOf(const mjModel& m, const ArrayField& field, int id);

/// Attributes with which an actuator refers to its elements; kTransmissions is in the order of
/// mjtTrn.
struct Transmission {
  mjtObj kind;
  std::string_view first;
  std::string_view second;  // reference to a second site; empty: none
};
inline constexpr Transmission kTransmissions[] = {{mjOBJ_JOINT, "joint", ""},
                                                  {mjOBJ_JOINT, "jointinparent", ""},
                                                  {mjOBJ_SITE, "cranksite", "slidersite"},
                                                  {mjOBJ_TENDON, "tendon", ""},
                                                  {mjOBJ_SITE, "site", "refsite"},
                                                  {mjOBJ_BODY, "body", ""}};

/// Attributes with which an equality refers to its elements; kEqualities is in the order of mjtEq.
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

/// Element of a tendon's path.
struct Wrap {
  std::string_view tag;  // joint, pulley, site or geom
  mjtObj kind = mjOBJ_UNKNOWN;
  int object = -1;  // id of the element; -1 for a pulley
  int side = -1;    // id of the side site; -1: none
};
Wrap WrapAt(const mjModel& m, int wrap);

}  // namespace mjforge::compiled
