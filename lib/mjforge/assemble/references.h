// References between elements by name, such as a sensor's joint; checked after all elements were
// added.

#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// The references, by name, of the elements in the MJCF sections (sensor, actuator, ...) of an
/// object.
class References {
 public:
  References(model::Object& object, diag::Findings& findings)
      : object_(object), findings_(findings) {}

  /// Place of an element: its section, and its index in the section.
  struct ElementPlace {
    const spec::SectionInfo* section = nullptr;
    std::size_t position = 0;
  };
  /// Adds a reference of the element at `place` to an element of the kind `kind` with the name
  /// `full_name`. Messages contain `shown`, the name in the spec, and `owner`, the attribute with
  /// its element.
  void Add(ElementPlace place, std::string_view kind, std::string full_name, std::string shown,
           std::string owner, diag::SourceMark mark);
  /// Records that a joint was removed because the spec or file `origin` was attached.
  void MarkRemoved(std::string joint, std::string origin);
  bool IsRemoved(const std::string& joint) const;

  /// Removes elements that refer to removed elements, and adds a warning for each. Then reports
  /// references to names that no element has.
  void Check();

 private:
  struct NameReference {
    ElementPlace place;
    std::string_view kind;
    std::string name;
    std::string shown;  // name as written in the spec or file
    std::string owner;  // "joint of jointpos 'angle'"
    diag::SourceMark mark;
  };
  using Set = std::unordered_set<std::string_view>;
  using Names = std::map<std::string_view, Set>;  // names by kind

  /// Returns the names of all elements, by kind, for the kinds that references need. The result
  /// refers to texts in the object and in `geoms`, to which the function adds the names of geoms.
  Names CollectNames(std::vector<std::string>& geoms) const;
  /// Removes the element that has the reference if the element to which it refers was removed.
  /// Returns true if this call removed the element.
  bool DropIfRemoved(const NameReference& reference);
  bool IsDropped(ElementPlace place) const {
    return dropped_.contains({place.section, place.position});
  }
  void Report(const NameReference& reference, const Set& names);

  model::Object& object_;
  diag::Findings& findings_;
  std::vector<NameReference> references_;
  // Reasons why elements were removed, by kind and name of the element.
  std::map<std::string, std::map<std::string, std::string>, std::less<>> removed_;
  // Elements of MJCF sections that are left out: the section, and the index in the section.
  std::set<std::pair<const spec::SectionInfo*, std::size_t>> dropped_;
};

}  // namespace mjforge::assemble
