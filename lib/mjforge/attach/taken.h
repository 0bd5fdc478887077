#ifndef MJFORGE_ATTACH_TAKEN_H_
#define MJFORGE_ATTACH_TAKEN_H_

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/attach/compiled_file.h"

namespace mjforge::attach {

/// What one attachment takes of a file: a body with all below it and, once
/// added, assets and elements of sections; and the names all that gets.
class Taken {
 public:
  /// Reports names that are made equal.
  Taken(const CompiledFile& file, int root, diag::Findings& findings);

  bool Has(mjtObj kind, int id) const { return names_.contains({kind, id}); }
  /// The made name; empty for an element of a section without one.
  const std::string& Name(mjtObj kind, int id) const { return names_.at({kind, id}); }
  /// Ids of the bodies, parents before children.
  const std::vector<int>& bodies() const { return bodies_; }
  /// The number of a body among them.
  int Position(int body) const { return positions_.at(body); }

  /// Takes something more.
  void Add(mjtObj kind, int id);

  /// Something reaches out of the attachment and so stays behind.
  void LeaveBehind(mjtObj kind, int id);
  bool IsLeftBehind(mjtObj kind, int id) const { return left_behind_.contains({kind, id}); }

 private:
  using Id = std::pair<int, int>;  // kind, id

  template <typename BodyOf>
  void AddAll(mjtObj kind, int count, BodyOf body_of);
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

/// The name with every character that names cannot have replaced.
std::string MakeName(std::string_view name);

}  // namespace mjforge::attach

#endif  // MJFORGE_ATTACH_TAKEN_H_
