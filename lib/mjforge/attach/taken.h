#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/attach/compiled_file.h"

namespace mjforge::attach {

/// What one attachment takes from a file: a body with everything below it and, once added, assets
/// and elements of sections; and the names they are given.
class Taken {
 public:
  /// Reports names that become equal when they are made valid.
  Taken(const CompiledFile& file, int root, diag::Findings& findings);

  bool Has(mjtObj kind, int id) const { return names_.contains({kind, id}); }
  /// The name it is given; empty for an element of a section without one.
  const std::string& Name(mjtObj kind, int id) const { return names_.at({kind, id}); }
  /// Gives it its name and its place.
  template <typename Thing>
  void Label(mjtObj kind, int id, Thing& thing) const {
    thing.name = Name(kind, id);
    thing.mark = file_.MarkOf(kind, id);
  }
  /// Ids of the bodies, parents before children.
  const std::vector<int>& bodies() const { return bodies_; }
  /// The index of a body in bodies().
  int Position(int body) const { return positions_.at(body); }

  /// Takes one more thing.
  void Add(mjtObj kind, int id);

  /// Leaves out something that refers to things outside the attachment.
  void LeaveBehind(mjtObj kind, int id);
  bool IsLeftBehind(mjtObj kind, int id) const { return left_behind_.contains({kind, id}); }

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
    int number;  // in the body
  };
  std::vector<Unnamed> unnamed_;
  std::set<Id> left_behind_;
};

/// The name, with all characters replaced that names cannot have.
std::string MakeName(std::string_view name);

}  // namespace mjforge::attach
