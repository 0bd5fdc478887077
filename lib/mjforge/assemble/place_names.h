// Names in `place:`: bodies, regions and sites of the spec that places.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// A region or a site, and the body that has it.
struct PlaceTarget {
  int body = -1;  // index in Object::bodies
  const model::Region* region = nullptr;
  const model::Site* site = nullptr;

  const model::Pose& X_BT() const { return region != nullptr ? region->X_BR : site->X_BS; }
  diag::SourceMark mark() const { return region != nullptr ? region->mark : site->mark; }
};

/// Finds elements of an object by the names that the spec of a scope has for them: NAME of the root
/// body, BODY.NAME, or BODY.INNER.NAME for a body inside the spec or file of BODY.
class PlaceNames {
 public:
  /// `bodies` has the indices of all bodies by full name.
  PlaceNames(const model::Object& object, const std::unordered_map<std::string, int>& bodies,
             const Scope& scope)
      : object_(object), bodies_(bodies), scope_(scope) {}

  /// Returns the index of the body BODY or BODY.INNER.
  std::optional<int> FindBody(std::string_view name) const;
  /// Returns the region or the site, regions first.
  std::optional<PlaceTarget> Find(std::string_view name) const;
  /// Returns the full name of a body.
  std::string FullName(std::string_view body) const;
  /// Returns the name that the spec has for a body: that of its entry, or of the spec itself.
  std::string NameOf(int body) const;

  /// Adds a finding about a name that no body has; `owner` has the place.
  void ReportBody(std::string_view owner, std::string_view name, diag::SourceMark mark,
                  diag::Findings& findings) const;
  /// Adds a finding about a name that no region and no site has.
  void ReportTarget(std::string_view owner, std::string_view name, diag::SourceMark mark,
                    diag::Findings& findings) const;

 private:
  /// Returns the names of the regions and sites of a body, without its own name.
  std::vector<std::string_view> TargetsOn(int index) const;

  /// Returns the names between dots, without that of the spec itself in front.
  std::vector<std::string_view> PathOf(std::string_view name) const;

  const model::Object& object_;
  const std::unordered_map<std::string, int>& bodies_;
  const Scope& scope_;
};

}  // namespace mjforge::assemble
