// Division of a scene among its objects: search for the root bodies of objects, and for the owners
// of elements by the names to which they refer.

#include "mjforge/split/owners.h"

#include <algorithm>

namespace mjforge::split {
namespace {

// Returns the owner of an element with two references whose owners are `a` and `b`.
int Join(int a, int b) {
  if (a == kAnyOwner) return b;
  return b == kAnyOwner || a == b ? a : kNoOwner;
}

}  // namespace

Owners::Owners(const model::Object& scene) : scene_(scene), bodies_(scene.bodies.size(), kNoOwner) {
  AddRoots();
  AddNames();
}

// Keeps a body whose ancestors move in the object of its parent, because a separate file would lose
// the connection.
void Owners::AddRoots() {
  const std::vector<model::Body>& bodies = scene_.bodies;
  const bool has_empty_root = bodies[0].parts.empty() && bodies[0].joints.empty();
  std::vector<bool> moves(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const model::Body& body = bodies[i];
    const bool is_world_child = body.parent < 0;
    const auto parent = static_cast<std::size_t>(std::max(body.parent, 0));
    const bool is_carried = !is_world_child && moves[parent];
    moves[i] = is_carried || !body.joints.empty();
    const bool is_own = is_world_child ? i > 0 || !has_empty_root
                                       : !is_carried && (!body.place_name.empty() ||
                                                         (parent == 0 && has_empty_root));
    if (is_own) {
      bodies_[i] = static_cast<int>(roots_.size());
      roots_.push_back(static_cast<int>(i));
    } else if (!is_world_child) {
      bodies_[i] = bodies_[parent];
    }
  }
}

void Owners::AddNames() {
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    const model::Body& body = scene_.bodies[i];
    const int owner = bodies_[i];
    const auto add = [&](std::string_view kind, const std::string& name) {
      named_.emplace(std::pair(std::string(kind), name), owner);
    };
    add("body", body.name);
    for (const model::Joint& joint : body.joints) add("joint", joint.name);
    for (const model::Site& site : body.sites) add("site", site.name);
    for (const model::Element& view : body.elements) add(view.tag, view.name);
    for (const model::Part& part : body.parts) {
      add("geom", part.name);
      add("geom", part.name + std::string(model::kVisualSuffix));
    }
  }
}

int Owners::Find(std::string_view kind, const std::string& name) const {
  if (kind == "xbody") kind = "body";
  const auto found = named_.find({std::string(kind), name});
  if (found != named_.end()) return found->second;
  // Tendons and actuators are not in `named_`, because they belong to the objects to which they
  // refer.
  if (kind != "tendon" && kind != "actuator") return kAnyOwner;
  for (const model::Element& element : model::ElementsOf(scene_, kind)) {
    if (element.name == name) return Of(element);
  }
  return kAnyOwner;
}

int Owners::Of(const model::Element& element) const {
  int owner = kAnyOwner;
  model::ForEachReference(element, [&](std::string_view kind, const std::string& name) {
    owner = Join(owner, Find(kind, name));
  });
  return owner;
}

}  // namespace mjforge::split
