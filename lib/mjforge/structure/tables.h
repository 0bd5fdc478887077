// Kinds of elements and fields of elements that make up the structure of a compiled model.
#pragma once

#include <span>
#include <string_view>

#include "mjforge/engine/engine.h"

namespace mjforge::structure {

/// Kind of element of mjModel.
struct Kind {
  mjtObj type;
  std::string_view word;                    // "geom"
  std::string_view number;                  // name of the kind's count: "ngeom"
  engine::Count mjModel::*count = nullptr;  // null: the model itself, one element
  /// Array of name addresses in mjModel. Null for kinds without names: the model itself, degrees of
  /// freedom (their number follows from the joints) and wraps (their number follows from the
  /// tendons).
  int* mjModel::*names = nullptr;
};
std::span<const Kind> Kinds();

/// A field of the structure: one integer for each element of a kind.
struct Field {
  std::string_view name;
  mjtObj kind;  // mjOBJ_UNKNOWN: the model itself
  int (*value)(const mjModel& m, int element);
  std::span<const std::string_view> words = {};  // names of the values 0, 1, ... for messages
  bool is_coincidence = false;
};
/// Returns all fields, grouped by kind in the order of Kinds().
std::span<const Field> Fields();

}  // namespace mjforge::structure
