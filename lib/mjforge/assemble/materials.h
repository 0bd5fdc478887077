// Materials of an object: evaluation on first use, and sharing of equal materials.

#pragma once

#include <string>
#include <unordered_map>

#include "mjforge/assemble/assets.h"
#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Adds materials to one object. Equal materials are added once.
class Materials {
 public:
  Materials(model::Object& object, Assets& assets, diag::Findings& findings)
      : object_(object), assets_(assets), findings_(findings) {}

  /// Returns the evaluated material that a field names, or its substitute from the outer spec; null
  /// after a finding.
  const MaterialState* Use(Scope& scope, FieldReader& reader, const spec::Field& field);
  /// Returns the index of an equal material whose name in its spec or file is `own_name`. Adds the
  /// material if there is none.
  int Share(const std::string& own_name, model::Material material);

 private:
  const MaterialState* Find(Scope& scope, const std::string& name, diag::SourceMark mark);
  void Evaluate(Scope& scope, const spec::Material& material, MaterialState& state);

  model::Object& object_;
  Assets& assets_;
  diag::Findings& findings_;
  std::unordered_multimap<std::string, int> by_name_;  // indices by name in the spec or file
};

}  // namespace mjforge::assemble
