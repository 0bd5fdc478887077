// Scope of a spec during assembly, and readers that all kinds of elements share.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// A material of a spec, which is evaluated when it is first used.
struct MaterialState {
  bool is_evaluated = false;
  int index = -1;  // index in Object::materials; -1 if it has only a density or contact attributes
  std::optional<double> density;
  const spec::Field* density_field = nullptr;
  std::vector<model::Attribute> contact;
};

/// A spec in the object: the outermost one, one that is welded to a body, or one that is a body.
struct Scope {
  Scope(sample::Evaluator& evaluator, std::string name_prefix, int root,
        const model::Pose& X_BodyS);

  sample::Evaluator& values;
  std::string prefix;      // prefix of the full names of the spec's elements; ends with `link`
  std::string link;        // name of the current link of a chain and "_"; otherwise empty
  int body;                // index in Object::bodies of the body that contains the spec's root
  model::Pose X_BS;        // pose of the spec's root S in the current body B
  sample::StreamId parts;  // stream of the current list of parts
  std::vector<MaterialState> materials;  // parallel to values.spec().materials
  /// Scope of the spec that contains this one, or null; and pairs of names: a material of this
  /// spec, and the material of the outer spec that replaces it.
  Scope* outer = nullptr;
  std::vector<std::pair<std::string, std::string>> substitutes;
  std::optional<Eigen::Vector3d> total_size;
  /// A body with a list of joints: its entry, its index, and the variables of the instance.
  struct Jointed {
    const spec::BodyEntry* entry;
    std::size_t body;
    sample::SavedVariables variables;
  };
  std::vector<Jointed> jointed = {};
  /// Slots and values, kg, of the variables NAME.mass of all bodies, which the spec's `mass:`
  /// scales.
  std::vector<std::pair<int, double>> body_masses;

  /// Returns the prefix without `link`.
  std::string outer_prefix() const { return prefix.substr(0, prefix.size() - link.size()); }
  /// Returns true for `placement: corner` in a spec with `total_size:`.
  bool places_corners() const {
    return total_size && values.spec().placement == spec::Placement::kCorner;
  }
};

/// Sets the materials that replace materials of a nested spec (`materials:` of its entry).
void SetSubstitutes(Scope& scope, const spec::Entry& entry, sample::StreamId path, Scope& inner);

/// Returns the name of an entry's instance in its spec; nullopt after a finding.
std::optional<std::string> ReadName(Scope& scope, const spec::Entry& entry, sample::StreamId list,
                                    diag::Findings& findings);

/// Reads an element's attributes into `out`, which is empty: first those of the element's entry,
/// then missing ones from the material, then from the defaults. Returns false after a finding.
bool ReadAttributes(FieldReader& reader, const spec::Entry& entry,
                    std::vector<model::Attribute>& out,
                    std::span<const model::Attribute> of_material = {});

/// Reads the type, the position and the axis of a joint. Returns false after a finding.
bool ReadJointGeometry(FieldReader& reader, const spec::Entry& entry, model::Joint& joint);

/// Returns the position of an element's origin for `placement: corner`. `p` is the required
/// position of its lower corner, relative to the lower corner of the declared box, whose half sizes
/// are `total_size`; `lower` is the element's lower corner relative to its origin.
Eigen::Vector3d FromCorner(const Eigen::Vector3d& p, const Eigen::Vector3d& total_size,
                           const Eigen::Vector3d& lower);

}  // namespace mjforge::assemble
