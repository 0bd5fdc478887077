// Collection of the union of the parts, sites and meshes of all variants, and completion of an
// object by the elements that it lacks.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "mjforge/padding/null_elements.h"
#include "mjforge/padding/padding.h"

namespace mjforge::padding {
namespace {

using model::Part;
using model::Site;

// Attributes whose values are shared by all worlds of a parallel simulation.
constexpr std::array<std::string_view, 6> kShared = {"contype",  "conaffinity", "condim",
                                                     "priority", "group",       "fluidshape"};

std::string SharedAttributes(const std::vector<model::Attribute>& attributes) {
  std::string text;
  for (const model::Attribute& attribute : attributes) {
    if (std::ranges::count(kShared, attribute.name) == 0) continue;
    text += fmt::format(" {}:{}={}", static_cast<int>(attribute.applies), attribute.name,
                        attribute.text);
    for (const double number : attribute.numbers) text += fmt::format(" {}", number);
  }
  return text;
}

std::string KeyOf(const model::MeshAsset& mesh) {
  return fmt::format("{} {} {} {}", mesh.name, mesh.mesh.vertices.size(),
                     mesh.mesh.triangles.size(), mesh.file.filename().string());
}

const model::MeshAsset& MeshOf(const Part& part, const model::Object& object) {
  return *object.meshes[static_cast<std::size_t>(part.mesh)];
}

std::string KeyOf(const Part& part, const model::Object& object) {
  std::string key = fmt::format("{} {} {} {}", part.name, model::GeomTypeName(part.shape.type),
                                static_cast<int>(part.role), part.as_is);
  if (part.mesh >= 0) key += ' ' + KeyOf(MeshOf(part, object));
  return key + SharedAttributes(part.attributes);
}

std::string KeyOf(const Site& site) {
  return fmt::format("{} {}", site.name, model::GeomTypeName(site.type)) +
         SharedAttributes(site.attributes);
}

// Returns a name that is not in `taken`, and adds it: NAME, NAME.TYPE, NAME.TYPE.2 and so on.
std::string NewName(const std::string& name, std::string_view type, std::set<std::string>& taken) {
  std::string chosen = name;
  for (int i = 1; !taken.insert(chosen).second; ++i)
    chosen = i == 1 ? fmt::format("{}.{}", name, type) : fmt::format("{}.{}.{}", name, type, i);
  return chosen;
}

}  // namespace

template <typename Element>
template <typename Make>
std::size_t Superset::Slots<Element>::Position(const std::string& key, std::size_t next,
                                               const Make& make) {
  const auto known = positions.find(key);
  if (known != positions.end()) return known->second;
  elements.insert(elements.begin() + static_cast<std::ptrdiff_t>(next), make());
  for (auto& [other, position] : positions) position += position >= next ? 1 : 0;
  positions.emplace(key, next);
  return next;
}

void Superset::Add(const model::Object& object) {
  ++count_;
  std::size_t next = 0;
  for (const auto& mesh : object.meshes) {
    next = 1 + meshes_.Position(KeyOf(*mesh), next,
                                [&] { return NewName(mesh->name, "mesh", mesh_names_); });
  }
  for (const model::Body& body : object.bodies) {
    BodySlots& slots = bodies_[body.name];
    next = 0;
    for (const Part& part : body.parts) {
      const std::size_t position =
          slots.parts.Position(KeyOf(part, object), next, [&] { return NewSlot(part, object); });
      ++slots.parts.elements[position].count;
      next = position + 1;
    }
    next = 0;
    for (const Site& site : body.sites) {
      next = 1 + slots.sites.Position(KeyOf(site), next, [&] {
        Site copy = site;
        copy.name = NewName(site.name, model::GeomTypeName(site.type), site_names_);
        return copy;
      });
    }
  }
}

Superset::PartSlot Superset::NewSlot(const Part& part, const model::Object& object) {
  PartSlot slot = {.part = part, .mesh = {}, .null_mesh = {}};
  slot.part.name = NewName(part.name, model::GeomTypeName(part.shape.type), geom_names_);
  if (part.mesh < 0) return slot;
  slot.mesh = KeyOf(MeshOf(part, object));
  std::unique_ptr<model::MeshAsset> null = NullMesh(MeshOf(part, object));
  null->name = NewName(slot.part.name, "mesh", mesh_names_);
  slot.null_mesh = std::move(null);
  slot.part.shape.mesh = &slot.null_mesh->mesh;
  return slot;
}

// Completion of one object: adds and renames elements, and updates references and meshes.
class Superset::Completion {
 public:
  Completion(const Superset& superset, model::Object& object)
      : superset_(superset), object_(object) {}

  void operator()() {
    for (model::Body& body : object_.bodies) {
      const auto found = superset_.bodies_.find(body.name);
      if (found != superset_.bodies_.end()) CompleteBody(found->second, body);
    }
    TakeSharedMeshes();
    for (model::Body& body : object_.bodies) {
      for (Part& part : body.parts) FindMesh(part);
    }
    for (model::Section& section : object_.sections) {
      for (model::Element& element : section.elements) {
        model::ForEachReference(element, [&](std::string_view kind, std::string& name) {
          const auto found = renamed_.find({kind, name});
          if (found != renamed_.end()) name = found->second;
        });
      }
    }
  }

 private:
  // Puts the elements `items` of a body, whose keys are `keys`, into the order of the superset's
  // elements (slots). Calls `rename` with each slot and the item that has its key. `make` returns
  // an item for a slot whose key no item has. Items without a slot come last.
  template <typename Element, typename Item, typename Rename, typename Make>
  static void Arrange(const Slots<Element>& slots, const std::vector<std::string>& keys,
                      std::vector<Item>& items, const Rename& rename, const Make& make) {
    std::vector<std::optional<Item>> found(slots.elements.size());
    std::vector<Item> others;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto slot = slots.positions.find(keys[i]);
      if (slot == slots.positions.end()) {
        others.push_back(std::move(items[i]));
      } else {
        rename(slots.elements[slot->second], items[i]);
        found[slot->second] = std::move(items[i]);
      }
    }
    items.clear();
    for (std::size_t i = 0; i < found.size(); ++i)
      items.push_back(found[i] ? *std::move(found[i]) : make(slots.elements[i]));
    std::ranges::move(others, std::back_inserter(items));
  }

  // Gives a part a mesh that no other part uses.
  void OwnMesh(std::unique_ptr<model::MeshAsset> mesh, const PartSlot& slot, Part& part) {
    mesh->name = slot.null_mesh->name;
    part.shape.mesh = &mesh->mesh;
    own_meshes_.emplace(part.shape.mesh, std::move(mesh));
  }

  // Keeps only meshes that parts use: first the meshes that several parts may share, in the order
  // of the superset, then the meshes of single parts (OwnMesh).
  void TakeSharedMeshes() {
    std::vector<std::pair<std::size_t, std::unique_ptr<model::MeshAsset>>> shared;
    for (auto& mesh : object_.meshes) {
      const auto uses = [&](const Part& part) { return part.shape.mesh == &mesh->mesh; };
      const auto has_use = [&](const model::Body& body) {
        return std::ranges::any_of(body.parts, uses);
      };
      if (std::ranges::none_of(object_.bodies, has_use)) continue;
      const auto slot = superset_.meshes_.positions.find(KeyOf(*mesh));
      const bool is_known = slot != superset_.meshes_.positions.end();
      if (is_known) mesh->name = superset_.meshes_.elements[slot->second];
      shared.emplace_back(is_known ? slot->second : superset_.meshes_.elements.size(),
                          std::move(mesh));
    }
    std::ranges::stable_sort(shared, {}, [](const auto& mesh) { return mesh.first; });
    object_.meshes.clear();
    for (auto& [position, mesh] : shared) object_.meshes.push_back(std::move(mesh));
    for (const model::Body& body : object_.bodies) {
      for (const Part& part : body.parts) {
        const auto own = own_meshes_.find(part.shape.mesh);
        if (own != own_meshes_.end()) object_.meshes.push_back(std::move(own->second));
      }
    }
  }

  // Sets Part::mesh to the new index of the part's mesh.
  void FindMesh(Part& part) const {
    const auto found = std::ranges::find_if(
        object_.meshes, [&](const auto& mesh) { return &mesh->mesh == part.shape.mesh; });
    if (part.mesh >= 0) part.mesh = static_cast<int>(found - object_.meshes.begin());
  }

  template <typename Element>
  void Rename(std::string_view kind, const std::string& name, Element& element) {
    if (element.name == name) return;
    renamed_[{kind, element.name}] = name;
    if (kind == "geom") {
      const std::string suffix(model::kVisualSuffix);
      renamed_[{kind, element.name + suffix}] = name + suffix;
    }
    element.name = name;
  }

  void CompleteBody(const BodySlots& slots, model::Body& body) {
    const Eigen::Vector3d middle = MiddleOf(body);
    std::vector<std::string> part_keys;
    for (const Part& part : body.parts) part_keys.push_back(KeyOf(part, object_));
    Arrange(
        slots.parts, part_keys, body.parts,
        [&](const PartSlot& slot, Part& part) {
          Rename("geom", slot.part.name, part);
          if (part.mesh >= 0 && superset_.IsOptional(slot))
            OwnMesh(std::make_unique<model::MeshAsset>(MeshOf(part, object_)), slot, part);
        },
        [&](const PartSlot& slot) {
          Part part = slot.part;
          MakeNull(middle, part);
          if (slot.null_mesh)
            OwnMesh(std::make_unique<model::MeshAsset>(*slot.null_mesh), slot, part);
          return part;
        });
    std::vector<std::string> site_keys;
    for (const Site& site : body.sites) site_keys.push_back(KeyOf(site));
    Arrange(
        slots.sites, site_keys, body.sites,
        [&](const Site& slot, Site& site) { Rename("site", slot.name, site); },
        [&](Site site) {
          MakeNull(middle, site);
          return site;
        });
  }

  const Superset& superset_;
  model::Object& object_;
  std::map<const model::TriangleMesh*, std::unique_ptr<model::MeshAsset>> own_meshes_;
  /// New names, by kind and old name.
  std::map<std::pair<std::string_view, std::string>, std::string> renamed_;
};

void Superset::Complete(model::Object& object) const { Completion(*this, object)(); }

}  // namespace mjforge::padding
