// Padding: each variant of a family gets the geoms and sites that any variant has, because parallel
// worlds share their number and their types. The additional ones are null: without mass and
// visibility and contacts, and tiny, in the middle of their body.

#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::padding {

/// The parts, sites and meshes that at least one of several variants has.
class Superset {
 public:
  /// Adds those of a variant.
  void Add(const model::Object& object);

  /// Gives an object all parts, sites and meshes of the bodies that it has, in an order that is the
  /// same for all objects. An element has another name if one of another type has its name in
  /// another variant: "handle" is a box, "handle.cylinder" the cylinder.
  void Complete(model::Object& object) const;

 private:
  // Elements of a kind, each as the first variant with it has it, but with its name here. Keys are
  // equal for elements that worlds can share.
  template <typename Element>
  struct Slots {
    std::vector<Element> elements;
    std::map<std::string, std::size_t> positions;  // by key

    /// Returns the position of a key; inserts the element at `next` if the key is new.
    template <typename Make>
    std::size_t Position(const std::string& key, std::size_t next, const Make& make);
  };
  struct PartSlot {
    model::Part part;
    std::string mesh;  // key of its mesh; empty: it has none
    /// The mesh where the part is null. In each variant, a part that may be null has a mesh of its
    /// own, with this name.
    std::shared_ptr<const model::MeshAsset> null_mesh;
    std::size_t count = 0;  // variants that have the part
  };
  struct BodySlots {
    Slots<PartSlot> parts;
    Slots<model::Site> sites;
  };
  class Completion;

  PartSlot NewSlot(const model::Part& part, const model::Object& object);
  bool IsOptional(const PartSlot& slot) const { return slot.count < count_; }

  std::size_t count_ = 0;                    // variants
  std::map<std::string, BodySlots> bodies_;  // by name
  Slots<std::string> meshes_;                // names
  std::set<std::string> geom_names_, site_names_, mesh_names_;
};

}  // namespace mjforge::padding
