// Names in `place:`: bodies, regions and sites of the spec that contains the entry.

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

  /// Returns the index of the body BODY or BODY.INNER; nullopt if it does not exist.
  std::optional<int> FindBody(std::string_view name) const;
  /// Returns the region or site with this name; nullopt if neither exists.
  std::optional<PlaceTarget> Find(std::string_view name) const;
  /// Returns the full name of a body.
  std::string FullName(std::string_view body) const;
  /// Returns the name of a body without the scope's prefix; for the root body, the spec's name.
  std::string NameOf(int body) const;

  /// Adds a finding about a name that no body has; `owner` is the element with the `place:`.
  void ReportBody(std::string_view owner, std::string_view name, diag::SourceMark mark,
                  diag::Findings& findings) const;
  /// Adds a finding about a name that no region and no site has.
  void ReportTarget(std::string_view owner, std::string_view name, diag::SourceMark mark,
                    diag::Findings& findings) const;

 private:
  /// Returns the names of the regions and sites of a body, without the body's name in front.
  std::vector<std::string_view> TargetsOn(int index) const;

  /// Splits the name at its dots, and removes the spec's own name from the front.
  std::vector<std::string_view> PathOf(std::string_view name) const;

  const model::Object& object_;
  const std::unordered_map<std::string, int>& bodies_;
  const Scope& scope_;
};

}  // namespace mjforge::assemble
