// Owners of the elements of a scene: the object that each body and each element belongs to.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::split {

/// Indices of objects, and what is none.
inline constexpr int kNoOwner = -1;   // the empty root, or elements of several objects
inline constexpr int kAnyOwner = -2;  // the element refers to nothing that an object has

/// The objects of a scene; see Split() for the rule where one begins.
class Owners {
 public:
  explicit Owners(const model::Object& scene);

  /// Index of the root body of each object.
  const std::vector<int>& roots() const { return roots_; }
  /// Returns the object of a body, by their indices.
  int OfBody(std::size_t body) const { return bodies_[body]; }
  /// Returns the object of everything that an element, with its children, refers to.
  int Of(const model::Element& element) const;

 private:
  void AddRoots();
  void AddNames();
  /// Returns the object that has the element of this kind and name.
  int Find(std::string_view kind, const std::string& name) const;

  const model::Object& scene_;
  std::vector<int> roots_;
  std::vector<int> bodies_;
  std::map<std::pair<std::string, std::string>, int> named_;  // by kind and name
};

}  // namespace mjforge::split
