#pragma once

#include <string>
#include <unordered_map>

#include "mjforge/model/assets.h"
#include "mjforge/model/scope.h"

namespace mjforge::model {

/// The materials of one object; equal ones are shared.
class Materials {
 public:
  Materials(Object& object, Assets& assets, diag::Findings& findings)
      : object_(object), assets_(assets), findings_(findings) {}

  /// The state of the material that a field names, or of the one in its place, evaluated; null
  /// after a finding.
  const MaterialState* Use(Scope& scope, FieldReader& reader, const spec::Field& field);
  /// The index of an equal material with that own name; otherwise adds this one and returns its
  /// index.
  int Share(const std::string& own_name, Material material);

 private:
  const MaterialState* Find(Scope& scope, const std::string& name, diag::SourceMark mark);
  void Evaluate(Scope& scope, const spec::Material& material, MaterialState& state);

  Object& object_;
  Assets& assets_;
  diag::Findings& findings_;
  std::unordered_multimap<std::string, int> by_name_;  // own names
};

}  // namespace mjforge::model
