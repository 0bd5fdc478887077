// Owners of the elements of a scene: the object that each body and each element belongs to.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::split {

/// Values in place of an object's index for an element that does not belong to exactly one object.
inline constexpr int kNoOwner = -1;   // the empty root, or a reference to several objects
inline constexpr int kAnyOwner = -2;  // the element refers to no element of an object

/// Objects of a scene, and the bodies and elements that each owns. Split() defines where an object
/// begins.
class Owners {
 public:
  explicit Owners(const model::Object& scene);

  /// Returns the indices of the root bodies, one per object.
  const std::vector<int>& roots() const { return roots_; }
  /// Returns the index of the object that a body, given by its index, belongs to.
  int OfBody(std::size_t body) const { return bodies_[body]; }
  /// Returns the index of the object that has all elements to which `element` and its children
  /// refer; kNoOwner or kAnyOwner if there is no such object.
  int Of(const model::Element& element) const;

 private:
  void AddRoots();
  void AddNames();
  /// Returns the index of the object that has the element of this kind and name; kAnyOwner if no
  /// object has such an element. A tendon or actuator belongs to the objects to which it refers.
  int Find(std::string_view kind, const std::string& name) const;

  const model::Object& scene_;
  std::vector<int> roots_;
  std::vector<int> bodies_;
  std::map<std::pair<std::string, std::string>, int> named_;  // owners, by kind and name
};

}  // namespace mjforge::split
