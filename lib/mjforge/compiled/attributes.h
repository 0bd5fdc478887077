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

/// Attribute of an element kind.
struct ArrayField {
  using Flags = engine::Flag* mjModel::*;
  /// Row of the array: the element's id, or the first degree of freedom or position of a joint.
  /// kQpos is for hinges and slides only.
  enum class Rows { kElement, kDof, kQpos };

  std::string_view attribute;
  std::variant<mjtNum * mjModel::*, float * mjModel::*, int * mjModel::*, Flags> array;
  int count = 1;  // numbers per element
  /// Default of MuJoCo; nothing if the attribute has none.
  std::optional<std::array<double, 6>> usual = std::array<double, 6>{};
  Rows rows = Rows::kElement;
  Flags needs = nullptr;                       // the attribute applies only with this flag
  engine::Count mjModel::*variable = nullptr;  // count of user data, instead of `count`

  /// `directional` of lights is a flag too, although it is a number since MuJoCo 3.3.3.
  bool IsFlag() const { return std::holds_alternative<Flags>(array) || attribute == "directional"; }
  bool IsFloat() const { return std::holds_alternative<float * mjModel::*>(array); }
};

/// Returns the attributes of an element kind, in file order: of geoms, joints, sites, cameras,
/// lights, tendons, actuators, pairs, equalities, sensors, materials and bodies; none of other
/// kinds.
std::span<const ArrayField> ArrayFields(mjtObj kind);

/// Returns the numbers of an attribute; none if it does not apply to this element. Numbers in
/// single precision are the shortest that read back as the same value. User data is without
/// trailing zeros.
sample::Numbers NumbersOf(const mjModel& m, const ArrayField& field, int id);

/// Reference of an actuator to the element it acts on, in the order of mjtTrn.
struct Transmission {
  mjtObj kind;
  std::string_view first;
  std::string_view second;  // to a site; empty: none
};
inline constexpr Transmission kTransmissions[] = {{mjOBJ_JOINT, "joint", ""},
                                                  {mjOBJ_JOINT, "jointinparent", ""},
                                                  {mjOBJ_SITE, "cranksite", "slidersite"},
                                                  {mjOBJ_TENDON, "tendon", ""},
                                                  {mjOBJ_SITE, "site", "refsite"},
                                                  {mjOBJ_BODY, "body", ""}};

/// References of an equality to two elements, in the order of mjtEq.
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
  std::string_view tag;  // joint pulley site geom
  mjtObj kind = mjOBJ_UNKNOWN;
  int object = -1;  // id; -1 for a pulley
  int side = -1;    // id of the side site; -1: none
};
Wrap WrapAt(const mjModel& m, int wrap);

}  // namespace mjforge::compiled
