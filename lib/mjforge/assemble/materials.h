// Materials of an object, which are evaluated on first use; equal materials are shared.

#pragma once

#include <string>
#include <unordered_map>

#include "mjforge/assemble/assets.h"
#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Adds materials to one object. Equal materials are added only once.
class Materials {
 public:
  Materials(model::Object& object, Assets& assets, diag::Findings& findings)
      : object_(object), assets_(assets), findings_(findings) {}

  /// Sets `material` to the evaluated material that an entry names, or to the material of the outer
  /// spec that replaces it. Leaves `material` unchanged if the entry names none. Returns false, and
  /// adds a finding, if the material does not exist.
  bool Read(Scope& scope, FieldReader& reader, const spec::Entry& entry,
            const MaterialState*& material);
  /// Returns the index of a material that equals `material` and is named `own_name` in its spec or
  /// file. Adds the material if there is none.
  int Share(const std::string& own_name, model::Material material);

 private:
  const MaterialState* Find(Scope& scope, const std::string& name, diag::SourceMark mark);
  void Evaluate(Scope& scope, const spec::Material& material, MaterialState& state);

  model::Object& object_;
  Assets& assets_;
  diag::Findings& findings_;
  // Indices in Object::materials by name in the spec or file.
  std::unordered_multimap<std::string, int> by_name_;
};

}  // namespace mjforge::assemble
