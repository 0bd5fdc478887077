// References between elements by name, such as a sensor's joint, checked once all elements exist.

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

/// The references of one object's sections.
class References {
 public:
  References(model::Object& object, diag::Findings& findings)
      : object_(object), findings_(findings) {}

  /// Place of an element: its section and its index there.
  struct ElementPlace {
    const spec::SectionInfo* section = nullptr;
    std::size_t position = 0;
  };
  /// Adds a reference of the element at `place` to an element of this kind. Messages show the name
  /// as `shown`, and the attribute with its element as `owner`.
  void Add(ElementPlace place, std::string_view kind, std::string full_name, std::string shown,
           std::string owner, diag::SourceMark mark);
  /// Notes that attaching the spec or file `origin` removed a joint.
  void MarkRemoved(std::string joint, std::string origin);
  bool IsRemoved(const std::string& joint) const;

  /// Drops elements that refer to removed elements, with a warning for each, and reports names that
  /// no element has.
  void Check();

 private:
  struct NameReference {
    ElementPlace place;
    std::string_view kind;
    std::string name;
    std::string shown;  // name in the spec or file
    std::string owner;  // "joint of jointpos 'angle'"
    diag::SourceMark mark;
  };
  using Set = std::unordered_set<std::string_view>;
  using Names = std::map<std::string_view, Set>;  // names by kind

  /// Returns the names of all elements of the kinds that are referred to. `geoms` gets the
  /// names of geoms, because the object does not contain all of them as texts to refer to.
  Names CollectNames(std::vector<std::string>& geoms) const;
  /// Drops the element if it refers to a removed one. Returns true if it was dropped now.
  bool DropIfRemoved(const NameReference& reference);
  bool IsDropped(ElementPlace place) const {
    return dropped_.contains({place.section, place.position});
  }
  void Report(const NameReference& reference, const Set& names);

  model::Object& object_;
  diag::Findings& findings_;
  std::vector<NameReference> references_;
  // Removed elements: reasons by kind and name.
  std::map<std::string, std::map<std::string, std::string>, std::less<>> removed_;
  std::set<std::pair<const spec::SectionInfo*, std::size_t>> dropped_;  // dropped elements
};

}  // namespace mjforge::assemble
