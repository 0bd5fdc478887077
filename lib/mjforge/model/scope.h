#pragma once

// What the readers of an object's elements share.

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/model/field_reader.h"
#include "mjforge/model/model.h"

namespace mjforge::model {

/// A material of a spec, evaluated when the first part asks for it.
struct MaterialState {
  bool ready = false;
  int index = -1;  // in Object::materials; -1: it has no look
  std::optional<double> density;
  const spec::Field* density_field = nullptr;
  std::vector<Attribute> contact;
};

/// One spec in the object: its own, one welded into a body, or one that is a body.
struct Scope {
  Scope(sample::Evaluator& evaluator, std::string name_prefix, int root, const Pose& X_BodyS);

  sample::Evaluator& values;
  std::string prefix;  // of its elements' names
  int body;            // in Object::bodies, that holds the spec's root
  Pose X_BS;           // of the spec's root S in the body B at hand
  sample::StreamId parts;
  std::vector<MaterialState> materials;  // as spec.materials
  /// The spec that brings this one, and which of its materials are used in place of this one's: by
  /// name, of this spec and of that one.
  Scope* outer = nullptr;
  std::vector<std::pair<std::string, std::string>> substitutes;
  std::optional<Eigen::Vector3d> total_size;
  /// The slot and the value, kg, of NAME.mass of each body, which the spec's own `mass:` scales.
  std::vector<std::pair<int, double>> body_masses;

  /// placement: corner, in a declared box.
  bool places_corners() const {
    return total_size && values.spec().placement == spec::Placement::kCorner;
  }
};

/// Hands materials of a scope to that of the spec that an entry brings.
void HandIn(Scope& scope, const spec::Entry& entry, sample::StreamId path, Scope& inner);

/// The entry's own name, checked; nothing after a finding.
std::optional<std::string> ReadName(Scope& scope, const spec::Entry& entry, sample::StreamId list,
                                    diag::Findings& findings);

/// Reads an element's own attributes into `out`, then adds those of its material and of the
/// defaults that it lacks; false after a finding.
bool ReadAttributes(FieldReader& reader, const spec::Entry& entry, std::vector<Attribute>& out,
                    std::span<const Attribute> of_material = {});

/// placement: corner. `p` is where the lower corner of something should be, counted from that of
/// the declared box, with half sizes `total_size`; `lower` is the corner seen from the thing's
/// origin. Where the origin is then.
Eigen::Vector3d FromCorner(const Eigen::Vector3d& p, const Eigen::Vector3d& total_size,
                           const Eigen::Vector3d& lower);

bool HasErrorsSince(const diag::Findings& findings, std::size_t first);

}  // namespace mjforge::model
