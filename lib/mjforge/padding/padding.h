// Padding: adds to each variant of a family the geoms and sites that any other variant has, because
// all worlds of a parallel simulation must have geoms and sites of equal number and types. Added
// elements are null: massless, invisible, without contact forces, and tiny, inside their body.

#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::padding {

/// The union of the parts, sites and meshes of several variants.
class Superset {
 public:
  /// Adds the parts, sites and meshes of a variant.
  void Add(const model::Object& object);

  /// Gives each body of an object all parts, sites and meshes that the body with the same name has
  /// in any variant, in an order that is the same for all objects. Renames elements of different
  /// types that have the same name in different variants: "handle" remains a box, and the cylinder
  /// "handle" becomes "handle.cylinder".
  void Complete(model::Object& object) const;

 private:
  // Union of the elements of a kind, each copied from the first variant that has the element. Two
  // variants have the same element if the keys are equal, which consist of name, type and those
  // attributes that all worlds share.
  template <typename Element>
  struct Slots {
    std::vector<Element> elements;
    std::map<std::string, std::size_t> positions;  // index in `elements`, by key

    /// Returns the position of the element with this key. If there is none, inserts the element
    /// that `make` returns at `next`.
    template <typename Make>
    std::size_t Position(const std::string& key, std::size_t next, const Make& make);
  };
  struct PartSlot {
    model::Part part;
    std::string mesh;  // key of the part's mesh; empty: no mesh
    /// Null mesh for variants that lack the part. If any variant lacks the part, all variants give
    /// the part a mesh that no other part uses and that has the name of the null mesh.
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
