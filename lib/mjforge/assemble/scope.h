// State of a spec while its elements are added to an object, and readers for all kinds of elements.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// A material of a spec, which is evaluated when an element first uses it.
struct MaterialState {
  bool is_evaluated = false;
  int index = -1;  // index in Object::materials; -1 if it has only a density or contact attributes
  std::optional<double> density;  // kg/m^3
  const spec::Field* density_field = nullptr;
  std::vector<model::Attribute> contact;  // attributes of colliding geoms, such as friction
};

/// State of a spec while its elements are added to the object: names, frame, materials. The
/// outermost spec has a scope, and so has each spec that is used as a part (welded) or as a body.
struct Scope {
  Scope(sample::Evaluator& evaluator, std::string name_prefix, int root,
        const model::Pose& X_BodyS);

  sample::Evaluator& values;
  std::string prefix;  // prefix of the full names of all elements of the spec; ends with `link`
  std::string link;    // name of the current link of a chain, and "_"; otherwise empty
  int body;          // index in Object::bodies of the body to which the spec's root elements belong
  model::Pose X_BS;  // pose of the spec's frame S in the current body B
  sample::StreamId parts;                // random stream of the current list of parts
  std::vector<MaterialState> materials;  // parallel to values.spec().materials
  /// Scope of the spec that contains this spec; null for the outermost spec. `substitutes` contains
  /// pairs: the name of a material of this spec, and the name of the outer spec's material that
  /// replaces it.
  Scope* outer = nullptr;
  std::vector<std::pair<std::string, std::string>> substitutes;
  std::optional<Eigen::Vector3d> total_size;  // half sizes of the declared bounding box, m
  /// A body with a list of joints: its entry, its index, and the values of its entry's variables.
  struct Jointed {
    const spec::BodyEntry* entry;
    std::size_t body;
    sample::SavedVariables variables;
  };
  std::vector<Jointed> jointed = {};
  /// Index (slot) in the evaluator, and value (kg), of the variable NAME.mass of each body. The
  /// values are scaled if the spec has `mass:`.
  std::vector<std::pair<int, double>> body_masses;

  /// Returns the prefix without `link` at its end.
  std::string outer_prefix() const { return prefix.substr(0, prefix.size() - link.size()); }
  /// Returns true for a spec with `placement: corner` and `total_size:`.
  bool places_corners() const {
    return total_size && values.spec().placement == spec::Placement::kCorner;
  }
};

/// Reads `materials:` of the entry: the outer spec's materials that replace materials of the nested
/// spec `inner`.
void SetSubstitutes(Scope& scope, const spec::Entry& entry, sample::StreamId path, Scope& inner);

/// Returns the name of an entry's current instance, as in the spec; nullopt after adding a finding.
std::optional<std::string> ReadName(Scope& scope, const spec::Entry& entry, sample::StreamId list,
                                    diag::Findings& findings);

/// Reads an element's attributes into `out`, which must be empty: first the attributes of the
/// element's entry, then missing ones from `of_material`, then missing ones from the defaults.
/// Returns false after adding a finding.
bool ReadAttributes(FieldReader& reader, const spec::Entry& entry,
                    std::vector<model::Attribute>& out,
                    std::span<const model::Attribute> of_material = {});

/// Reads the type, the position and the axis of a joint. Returns false after adding a finding.
bool ReadJointGeometry(FieldReader& reader, const spec::Entry& entry, model::Joint& joint);

/// Returns the position of an element's origin for `placement: corner`. `p` is the required
/// position of the element's lower corner, relative to the lower corner of the declared box, whose
/// half sizes are `total_size`. `lower` is the element's lower corner relative to its origin.
Eigen::Vector3d FromCorner(const Eigen::Vector3d& p, const Eigen::Vector3d& total_size,
                           const Eigen::Vector3d& lower);

}  // namespace mjforge::assemble
