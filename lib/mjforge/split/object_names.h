// Names of the elements of an object that is copied from a scene into a file of its own.
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

/// Renaming of an object's elements: replaces the prefix that their names have in a scene, such as
/// `mug_1_`, by the prefix that they get in the object's own file.
class ObjectNames {
 public:
  /// `objects` are the names of all objects of the scene; the list must outlive this object. `own`
  /// is the name of the object whose elements are renamed. New names begin with `prefix`; the root
  /// body of the object becomes `root`.
  ObjectNames(const std::vector<std::string>& objects, std::string own, std::string prefix,
              std::string root)
      : objects_(objects),
        own_(std::move(own)),
        prefix_(std::move(prefix)),
        root_(std::move(root)) {}

  /// Returns the new name of an element that is not an asset; empty for an element without a name.
  std::string Of(std::string_view kind, const std::string& name) const;
  /// Returns the new name of an asset, whose old name may have the prefix of any object that shares
  /// the asset.
  std::string OfAsset(std::string_view kind, const std::string& name);
  /// Renames an element and its children, and updates their references to other elements. Assets
  /// to which they refer must have been renamed before, by OfAsset().
  void Rename(model::Element& element) const;
  /// Renames a body with its joints, sites, regions, parts, cameras and lights.
  void Rename(model::Body& body) const;

 private:
  const std::vector<std::string>& objects_;
  std::string own_;
  std::string prefix_;
  std::string root_;
  // New name of each asset, by kind and old name.
  std::map<std::pair<std::string, std::string>, std::string> assets_;
  std::set<std::pair<std::string, std::string>> taken_;  // kind and new name of each asset
};

/// Returns true if no two elements of a kind have the same name. Otherwise adds a finding for each
/// duplicate.
bool HasUniqueNames(const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::split
