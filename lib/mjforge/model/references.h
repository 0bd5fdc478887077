#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::model {

/// The kind of element that an attribute of `element` refers to; for `@objtype`, the kind that the
/// attribute objtype gives.
std::string_view KindOf(const Attribute& attribute, const Element& element);

/// The names that elements of sections refer to, checked once all elements exist.
class References {
 public:
  References(Object& object, diag::Findings& findings) : object_(object), findings_(findings) {}

  /// An element: its section and its index there.
  struct Place {
    const spec::SectionInfo* section = nullptr;
    std::size_t position = 0;
  };
  /// The element at `place` refers to an element of that kind. `owner` names the attribute and its
  /// element in messages.
  void Add(Place place, std::string_view kind, std::string full_name, std::string shown,
           std::string owner, diag::SourceMark mark);
  /// A joint that attaching removed; `origin` names the spec or file it came from.
  void TakeAway(std::string joint, std::string origin);
  bool IsTakenAway(const std::string& joint) const;

  /// Removes elements that refer to something removed, with a warning for each; reports names that
  /// no element has.
  void Check();

 private:
  struct Reference {
    Place place;
    std::string_view kind;
    std::string name;
    std::string shown;  // as the spec or the file says it
    std::string owner;  // "joint of jointpos 'angle'"
    diag::SourceMark mark;
  };
  using Set = std::unordered_set<std::string_view>;
  using Names = std::map<std::string_view, Set>;  // by kind

  Names Collect() const;
  bool TakeOutOne(const Reference& reference);
  void Report(const Reference& reference, const Set& names);

  Object& object_;
  diag::Findings& findings_;
  std::vector<Reference> references_;
  // By kind: a name that is gone, and why.
  std::map<std::string, std::map<std::string, std::string>, std::less<>> gone_;
  std::set<std::pair<const spec::SectionInfo*, std::size_t>> taken_out_;
};

}  // namespace mjforge::model
