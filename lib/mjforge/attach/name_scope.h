// Contents of an attachment, a body of an MJCF file for use in a spec: bodies, elements and assets,
// and their names in the attachment.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/attach/compiled_file.h"

namespace mjforge::attach {

/// The set of elements that one attachment (a body of an MJCF file, for use in a spec) contains,
/// and their names: the body, all bodies and elements below the body and, once added, assets and
/// elements of sections. `kind` and `id` are MuJoCo's.
class NameScope {
 public:
  /// Adds the body `root` with all bodies and elements below. Reports names that become equal when
  /// invalid characters are replaced.
  NameScope(const CompiledFile& file, int root, diag::Findings& findings);

  bool Contains(mjtObj kind, int id) const { return names_.contains({kind, id}); }
  /// Returns the name in the attachment; an empty text for an element of a section without a name.
  const std::string& Name(mjtObj kind, int id) const { return names_.at({kind, id}); }
  /// Sets the name of `thing`, an element of the attachment, and its position in the MJCF file.
  template <typename Thing>
  void Label(mjtObj kind, int id, Thing& thing) const {
    thing.name = Name(kind, id);
    thing.mark = file_.MarkOf(kind, id);
  }
  /// Ids of the attached bodies, parents before children.
  const std::vector<int>& bodies() const { return bodies_; }
  /// Returns the index of a body in bodies().
  int Position(int body) const { return positions_.at(body); }

  /// Adds an asset or an element of a section to the attachment.
  void Add(mjtObj kind, int id);

  /// Removes an element that refers to elements outside the attachment.
  void Drop(mjtObj kind, int id);
  bool IsDropped(mjtObj kind, int id) const { return dropped_.contains({kind, id}); }

 private:
  using Id = std::pair<int, int>;  // kind, id

  void AddAll(mjtObj kind, int count, const int* bodies);
  void NameUnnamed();

  const CompiledFile& file_;
  diag::Findings& findings_;
  std::vector<int> bodies_;
  std::map<int, int> positions_;
  std::map<Id, std::string> names_;
  std::map<std::pair<int, std::string>, int> used_;
  struct Unnamed {
    mjtObj kind;
    int id;
    int body;
    int number;  // index among elements of this kind in their body
  };
  std::vector<Unnamed> unnamed_;
  std::set<Id> dropped_;
};

/// Returns a valid name: replaces all characters that names cannot have by `_`, and adds an `x` in
/// front if the name begins with another character than a letter. An empty name remains empty.
std::string MakeName(std::string_view name);

}  // namespace mjforge::attach
