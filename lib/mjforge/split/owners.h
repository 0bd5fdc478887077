// Division of a scene among its objects: the object to which each body and each MJCF element
// belongs.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::split {

/// Values in place of an object's index for a body or element that does not belong to one object.
inline constexpr int kNoOwner = -1;   // belongs to no object, or refers to several objects
inline constexpr int kAnyOwner = -2;  // refers to no element of any object

/// Objects of a scene, and the bodies and elements that belong to each. Split() in split.h defines
/// which bodies are the roots of objects.
class Owners {
 public:
  explicit Owners(const model::Object& scene);

  /// Returns the indices of the root bodies, one per object.
  const std::vector<int>& roots() const { return roots_; }
  /// Returns the index of the object that a body, given by its index, belongs to.
  int OfBody(std::size_t body) const { return bodies_[body]; }
  /// Returns the index of the object that has all elements to which `element` and its children
  /// refer; kNoOwner if several objects have them; kAnyOwner if no object has any of them.
  int Of(const model::Element& element) const;

 private:
  void AddRoots();
  void AddNames();
  /// Returns the index of the object that has the element of this kind and name; kAnyOwner if no
  /// object has such an element. For a tendon or actuator, returns Of() this element.
  int Find(std::string_view kind, const std::string& name) const;

  const model::Object& scene_;
  std::vector<int> roots_;
  std::vector<int> bodies_;
  std::map<std::pair<std::string, std::string>, int> named_;  // owners, by kind and name
};

}  // namespace mjforge::split
