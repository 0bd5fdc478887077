// Lookup of the names in `place:`: bodies, regions and sites of the spec that contains the entry.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// A region or a site, and the body to which it belongs.
struct PlaceTarget {
  int body = -1;  // index in Object::bodies
  const model::Region* region = nullptr;
  const model::Site* site = nullptr;

  /// Returns the pose of the region or site in its body's frame B.
  const model::Pose& X_BT() const { return region != nullptr ? region->X_BR : site->X_BS; }
  diag::SourceMark mark() const { return region != nullptr ? region->mark : site->mark; }
};

/// Finds elements of an object by the names that are valid in the spec of a scope: NAME for an
/// element of the root body, BODY.NAME, or BODY.INNER.NAME for an element of a body inside the spec
/// or MJCF file of BODY.
class PlaceNames {
 public:
  /// `bodies` contains the indices of all bodies by full name.
  PlaceNames(const model::Object& object, const std::unordered_map<std::string, int>& bodies,
             const Scope& scope)
      : object_(object), bodies_(bodies), scope_(scope) {}

  /// Returns the index of a body named BODY or BODY.INNER; nullopt if there is none.
  std::optional<int> FindBody(std::string_view name) const;
  /// Returns the region or site with this name; nullopt if there is none.
  std::optional<PlaceTarget> Find(std::string_view name) const;
  /// Returns the full name, as in the object, of a body named BODY or BODY.INNER.
  std::string FullName(std::string_view body) const;
  /// Returns the name of a region or site as the outermost spec would write it: if the scope's spec
  /// is the body `set` of the outermost spec, its "tray.surface" is "set.tray.surface" there.
  std::string OutermostName(std::string_view name) const;
  /// Returns the name of a body without the scope's prefix; for the root body, the spec's name.
  std::string NameOf(int body) const;

  /// Adds a finding about a name that no body has. `owner` is the element with `place:`.
  void ReportBody(std::string_view owner, std::string_view name, diag::SourceMark mark,
                  diag::Findings& findings) const;
  /// Adds a finding about a name that neither a region nor a site has. `owner` is the element with
  /// `place:`. `remedy` is the key that the hint suggests for declaring the missing element.
  void ReportTarget(std::string_view owner, std::string_view name, diag::SourceMark mark,
                    diag::Findings& findings, std::string_view remedy = "regions") const;

 private:
  /// Returns the entry in a spec that declares a region or site of a body; null if there is none.
  const spec::Entry* FindEntry(int body, std::string_view name) const;
  /// Explains why a variant lacks a region or site of a body that `entry` declares with `if` or
  /// `for`, or searches.
  void ExplainAbsence(const spec::Entry& entry, int body, std::string_view name,
                      diag::Finding& finding) const;

  /// Returns the names of the regions and sites of a body, without the name of the body.
  std::vector<std::string_view> TargetsOn(int index) const;

  /// Splits the name at its dots. Removes the first of several parts if it is the name of the
  /// scope's spec.
  std::vector<std::string_view> PathOf(std::string_view name) const;

  const model::Object& object_;
  const std::unordered_map<std::string, int>& bodies_;
  const Scope& scope_;
};

}  // namespace mjforge::assemble
