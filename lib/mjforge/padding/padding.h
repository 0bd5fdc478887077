// Padding: each variant of a family gets the geoms and sites that any variant has, because all
// worlds of a parallel simulation have geoms and sites of equal number and types. Added elements
// are null: massless, invisible, without contacts, and tiny, in the middle of their body.

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
  /// Adds the parts, sites and meshes of a variant.
  void Add(const model::Object& object);

  /// Gives each body of an object all parts, sites and meshes that the body of this name has in any
  /// variant, in an order that is the same for all objects. An element is renamed if its name
  /// belongs to an element of another type in another variant: "handle" is a box, "handle.cylinder"
  /// the cylinder.
  void Complete(model::Object& object) const;

 private:
  // Elements of a kind that any variant has, each copied from the first variant that has the
  // element. Elements of two variants are one element in all worlds if their keys (name, type and
  // shared attributes) are equal.
  template <typename Element>
  struct Slots {
    std::vector<Element> elements;
    std::map<std::string, std::size_t> positions;  // index in `elements`, by key

    /// Returns the position of a key; inserts the element at `next` if the key is new.
    template <typename Make>
    std::size_t Position(const std::string& key, std::size_t next, const Make& make);
  };
  struct PartSlot {
    model::Part part;
    std::string mesh;  // key of the part's mesh; empty: no mesh
    /// Null mesh for variants that lack the part. If any variant lacks the part, the part has in
    /// each variant a mesh that no other part uses, with the name of this mesh.
    std::shared_ptr<const model::MeshAsset> null_mesh;
    std::size_t count = 0;  // number of variants that have the part
  };
  struct BodySlots {
    Slots<PartSlot> parts;
    Slots<model::Site> sites;
  };
  class Completion;

  PartSlot NewSlot(const model::Part& part, const model::Object& object);
  bool IsOptional(const PartSlot& slot) const { return slot.count < count_; }

  std::size_t count_ = 0;                    // number of variants
  std::map<std::string, BodySlots> bodies_;  // by name
  Slots<std::string> meshes_;                // names of the meshes
  std::set<std::string> geom_names_, site_names_, mesh_names_;
};

}  // namespace mjforge::padding
