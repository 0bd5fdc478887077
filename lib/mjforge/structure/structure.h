// Structure of a compiled model: the integers that parallel worlds of one model share.
//
// MuJoCo Warp, MJX and other engines step many worlds of one mjModel. Real numbers may vary from
// world to world, integers are shared. Two variants have the same structure if these are equal:
// - the number and the names of bodies, joints, geoms, sites, cameras, lights, meshes, height
//   fields, contact pairs, excludes, equalities, tendons, actuators, sensors and keyframes;
// - types, parents, references between elements, collision masks, groups, flags of limits, and the
//   numbers of vertices and faces of each mesh;
// - integer options of the simulation, such as the integrator;
// - coincidences: flags that MuJoCo or an engine derives from numbers that are exactly zero or
//   equal (body_sameframe, body_simple, which degrees of freedom have friction loss).
// nq, nv, na, nmocap, addresses, dof_simplenum and the pattern of the mass matrix follow from
// these.
//
// Not included are the appearance (materials, textures, and which material a geom has: a family has
// the union of all materials) and the connectivity of meshes, which Qhull chooses: an engine whose
// worlds have different meshes exchanges whole meshes.
//
// The structure of a model is the same in all releases of MuJoCo that compile the model to the same
// meshes and inertia frames: enumerators are numbered as in 2.2.2, and frames are compared by the
// rule of 3.2 and later. In a structure, a geom of type mesh has no frame flag, because releases
// choose different frames for a mesh; an engine must derive that flag from its own poses.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/structure/frames.h"

struct mjModel_;

namespace mjforge::structure {

/// Structure of one compiled model. Empty for a variant that was not loaded in MuJoCo.
struct Structure {
  std::vector<int> integers;  // counts, then fields, in the order of the tables in tables.h
  std::string names;          // names of all elements, each with a final NUL

  bool operator==(const Structure&) const = default;
  bool empty() const { return integers.empty(); }
  /// Returns a hash of the structure: 12 hexadecimal digits; "" if the structure is empty.
  std::string Key() const;
  /// Returns a hash of the structure without coincidences, because variants of one family may
  /// differ in coincidences.
  std::string FamilyKey() const;
};

/// Reads the structure of a model. Names lose the prefix of the object's name, so that the name of
/// a variant (`--name`) does not matter: "hammer_handle" is "handle", and "hammer" is "".
Structure StructureOf(const mjModel_& m, std::string_view object_name);

/// A field that differs between two structures.
struct Difference {
  std::string field;                  // "geom_type"; a count: "ngeom"; names: "geom names"
  std::vector<std::string> elements;  // elements that differ, or that only one of the two has
  std::pair<std::string, std::string> values;  // values of the first element, or counts, in both
  /// Differing elements with their values in the second structure, as text. Two structures differ
  /// from a third one in the same way if these texts are equal.
  std::string contents;
  /// True if the field is a flag that depends on numbers being exactly zero or equal. A base model
  /// in which the flag is off is valid for every variant.
  bool is_coincidence = false;
};
/// Returns the differences. If the number or the names of the elements of a kind differ, compares
/// only elements with names that both structures have, and skips fields that contain ids of
/// elements.
std::vector<Difference> DifferencesOf(const Structure& a, const Structure& b);

/// Describes a difference for a message: "geom_type of 'handle' and 'neck' is box, not cylinder",
/// where box is the value in the second structure.
std::string Describe(const Difference& difference);

}  // namespace mjforge::structure
