#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {

/// An element outside of `<default>`, with what its default class depends on.
struct Placed {
  XmlElement* element = nullptr;
  const XmlElement* parent = nullptr;
  std::string_view section;   // as SectionOf() says; empty: it has no defaults
  std::string default_class;  // empty: the main one
};

/// The elements of a file, and what their default classes say. Valid while the tree keeps its
/// elements.
class PlacedElements {
 public:
  explicit PlacedElements(XmlElement& root);

  std::vector<Placed>& all() { return placed_; }
  /// Those that share defaults: "actuator", "joint", ...
  std::vector<Placed*> In(std::string_view section);

  /// What the element says, or its default class; null if neither does.
  const std::string* Find(const Placed& placed, std::string_view attribute) const;
  std::string Get(const Placed& placed, std::string_view attribute, std::string_view usual) const;
  /// What the compiler sections say; the last one counts.
  std::string Setting(std::string_view attribute, std::string_view usual) const;
  /// The elements of `<default>` that it takes after: those of the main class first.
  std::vector<const XmlElement*> DefaultsOf(const Placed& placed) const;

 private:
  void ReadClass(const XmlElement& section, const std::string& name, const std::string& parent);
  void Place(XmlElement& parent, const std::string& child_class);

  struct Class {
    std::string parent;
    std::vector<const XmlElement*> elements;
  };
  std::map<std::string, Class> classes_ = {{"", {}}};
  std::string main_ = "main";
  std::vector<Placed> placed_;
};

/// Numbers separated by blanks; none if a word is not a number.
std::vector<double> NumbersOf(std::string_view text);
std::string TextOf(const std::vector<double>& numbers);

}  // namespace mjforge::engine
