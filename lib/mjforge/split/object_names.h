// Names of the elements of an object that is taken out of a scene.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::split {

/// Replaces the prefix that names have in a scene, `mug_1_`, by the prefix that they have in the
/// object's own file.
class ObjectNames {
 public:
  /// `objects` are the names of all objects of the scene, `own` is the one whose elements get new
  /// names. `root` is the new name of its root body.
  ObjectNames(const std::vector<std::string>& objects, std::string own, std::string prefix,
              std::string root)
      : objects_(objects),
        own_(std::move(own)),
        prefix_(std::move(prefix)),
        root_(std::move(root)) {}

  /// Returns the new name of an element that is not an asset; none for an element without a name.
  std::string Of(std::string_view kind, const std::string& name) const;
  /// Returns the new name of an asset, which may have the prefix of any object that shares it.
  std::string OfAsset(std::string_view kind, const std::string& name);
  /// Renames an element, its children, and all elements that they refer to.
  void Rename(model::Element& element) const;
  /// Renames everything in a body except for its assets.
  void Rename(model::Body& body) const;

 private:
  const std::vector<std::string>& objects_;
  std::string own_;
  std::string prefix_;
  std::string root_;
  std::map<std::pair<std::string, std::string>, std::string> assets_;  // new names
  std::set<std::pair<std::string, std::string>> taken_;                // by kind and new name
};

/// Returns false, after adding a finding, if two elements of a kind have the same name.
bool HasUniqueNames(const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::split
