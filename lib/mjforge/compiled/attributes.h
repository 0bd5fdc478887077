// Access to the values of MJCF attributes in mjModel, and tables of the elements to which
// actuators, equalities and tendon paths refer.
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

/// MJCF attribute of one kind of elements, and the array of mjModel that contains the values of
/// this attribute.
struct ArrayField {
  using Flags = engine::Flag* mjModel::*;
  /// Row of the array for an element: the element's id (kElement) or, for a joint, jnt_dofadr
  /// (kDof) or jnt_qposadr (kQpos). kQpos applies only to hinges and slides.
  enum class Rows { kElement, kDof, kQpos };

  std::string_view attribute;
  std::variant<mjtNum * mjModel::*, float * mjModel::*, int * mjModel::*, Flags> array;
  int count = 1;  // numbers per row
  /// MuJoCo's default, `count` numbers; nullopt if the attribute has no fixed default.
  std::optional<std::array<double, 6>> usual = std::array<double, 6>{};
  Rows rows = Rows::kElement;
  Flags needs = nullptr;  // array of flags; the attribute applies where 1; null: always
  // Member of mjModel with the number of user values (nuser_geom, ...), which replaces `count`;
  // null if `count` applies.
  engine::Count mjModel::*variable = nullptr;

  /// Returns true if the values of the attribute in MJCF are true and false. Includes `directional`
  /// of lights, although mjModel stores a number for it since 3.3.3.
  bool IsFlag() const { return std::holds_alternative<Flags>(array) || attribute == "directional"; }
  bool IsFloat() const { return std::holds_alternative<float * mjModel::*>(array); }
};

/// Returns the attributes of an element kind (geoms, joints, sites, cameras, lights, tendons,
/// actuators, pairs, equalities, sensors, materials or bodies), in the order of the table; empty
/// for other kinds.
std::span<const ArrayField> ArrayFields(mjtObj kind);

/// Returns the values of an attribute of the element `id`; empty if the attribute does not apply to
/// this element. A float becomes the shortest decimal that reads back as this float (0.1, not
/// 0.100000001). Trailing zeros of user data are left out.
sample::Numbers NumbersOf(const mjModel& m, const ArrayField& field, int id);

/// MJCF attributes by which an actuator names the elements that it acts on, for one transmission
/// type. The order of kTransmissions is that of mjtTrn.
struct Transmission {
  mjtObj kind;
  std::string_view first;
  std::string_view second;  // attribute for a second site; empty: none
};
inline constexpr Transmission kTransmissions[] = {{mjOBJ_JOINT, "joint", ""},
                                                  {mjOBJ_JOINT, "jointinparent", ""},
                                                  {mjOBJ_SITE, "cranksite", "slidersite"},
                                                  {mjOBJ_TENDON, "tendon", ""},
                                                  {mjOBJ_SITE, "site", "refsite"},
                                                  {mjOBJ_BODY, "body", ""}};

/// MJCF attributes by which an equality of one type names its two elements. The order of
/// kEqualities is that of mjtEq.
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

/// Element of a tendon's path, as in mjModel::wrap_type, wrap_objid and wrap_prm.
struct Wrap {
  std::string_view tag;  // joint, pulley, site or geom
  mjtObj kind = mjOBJ_UNKNOWN;
  int object = -1;  // id of the element; -1 for a pulley
  int side = -1;    // id of the side site; -1: none
};
/// Returns the element at the index `wrap` of the arrays mjModel::wrap_*.
Wrap WrapAt(const mjModel& m, int wrap);

}  // namespace mjforge::compiled
