// Division of a scene into objects: copies of bodies, with the assets and elements that they use.

#include "mjforge/split/split.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "mjforge/split/object_names.h"
#include "mjforge/split/owners.h"

namespace mjforge::split {
namespace {

using diag::Code;
using model::Object;

// Copies one object out of a scene.
class Extraction {
 public:
  Extraction(const Object& scene, const Owners& owners, int owner, ObjectNames names)
      : scene_(scene), owners_(owners), owner_(owner), names_(std::move(names)) {}

  Object operator()(std::string name) {
    object_.name = std::move(name);
    object_.start_form = scene_.start_form;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      if (owners_.OfBody(i) == owner_) AddBody(i);
    }
    for (const model::Section& section : scene_.sections) AddElements(section);
    AddSetpoints();
    model::MeasureAtStart(object_);
    return std::move(object_);
  }

 private:
  void AddBody(std::size_t index) {
    const auto number = static_cast<int>(object_.bodies.size());
    new_bodies_.emplace(static_cast<int>(index), number);
    model::Body& body = object_.bodies.emplace_back(scene_.bodies[index]);
    if (number == 0) {
      PutAtOrigin(body);
    } else {
      body.parent = new_bodies_.at(body.parent);
    }
    if (body.attached >= 0) {
      const auto first = new_bodies_.find(body.attached);
      body.attached = first == new_bodies_.end() ? number : first->second;
    }
    std::erase_if(body.elements, [&](const model::Element& view) {
      const int target = owners_.Of(view);
      return target != kAnyOwner && target != owner_;
    });
    for (model::Site& site : body.sites) site.material = NewMaterial(site.material);
    for (model::Part& part : body.parts) {
      part.material = NewMaterial(part.material);
      if (part.mesh < 0) continue;
      part.mesh = NewMesh(part.mesh);
      part.shape.mesh = &object_.meshes[static_cast<std::size_t>(part.mesh)]->mesh;
    }
    names_.Rename(body);
  }

  // Moves the root of the object such that its frame at the start is the object's frame.
  static void PutAtOrigin(model::Body& root) {
    root.parent = -1;
    const bool moves = !root.joints.empty() && root.joints.front().type != "free";
    root.X_PB = moves ? model::StartPose(root).Inverse() * root.X_PB : model::Pose();
  }

  int NewMesh(int mesh) {
    const auto [found, is_new] = new_meshes_.try_emplace(mesh, object_.meshes.size());
    if (is_new) {
      const model::MeshAsset& old = *scene_.meshes[static_cast<std::size_t>(mesh)];
      object_.meshes.push_back(std::make_unique<model::MeshAsset>(old));
      object_.meshes.back()->name = names_.OfAsset("mesh", old.name);
    }
    return found->second;
  }

  int NewMaterial(int material) {
    if (material < 0) return material;
    const auto [found, is_new] = new_materials_.try_emplace(material, object_.materials.size());
    if (is_new) {
      model::Material copy = scene_.materials[static_cast<std::size_t>(material)];
      copy.name = names_.OfAsset("material", copy.name);
      copy.texture = NewTexture(copy.texture);
      object_.materials.push_back(std::move(copy));
    }
    return found->second;
  }

  int NewTexture(int texture) {
    if (texture < 0) return texture;
    const auto [found, is_new] = new_textures_.try_emplace(texture, object_.textures.size());
    if (is_new) {
      model::Texture copy = scene_.textures[static_cast<std::size_t>(texture)];
      copy.name = names_.OfAsset("texture", copy.name);
      object_.textures.push_back(std::move(copy));
    }
    return found->second;
  }

  void AddElements(const model::Section& section) {
    model::Section own = {section.info, {}};
    for (const model::Element& element : section.elements) {
      if (owners_.Of(element) != owner_) continue;
      AddMaterialsOf(element);
      names_.Rename(own.elements.emplace_back(element));
    }
    if (!own.elements.empty()) object_.sections.push_back(std::move(own));
  }

  // Adds the material to which an element, such as a tendon, refers by name.
  void AddMaterialsOf(const model::Element& element) {
    const model::Attribute* attribute = model::FindAttribute(element.attributes, "material");
    if (attribute == nullptr) return;
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
      if (scene_.materials[i].name == attribute->text) NewMaterial(static_cast<int>(i));
    }
  }

  void AddSetpoints() {
    for (model::Setpoint setpoint : scene_.setpoints) {
      setpoint.actuator = names_.Of("actuator", setpoint.actuator);
      const auto actuators = model::ElementsOf(object_, "actuator");
      if (std::ranges::count(actuators, setpoint.actuator, &model::Element::name) > 0)
        object_.setpoints.push_back(std::move(setpoint));
    }
  }

  const Object& scene_;
  const Owners& owners_;
  int owner_;
  ObjectNames names_;
  Object object_;
  // Index of each copied body in the object, by the body's index in the scene.
  std::map<int, int> new_bodies_;
  std::map<int, int> new_meshes_;
  std::map<int, int> new_materials_;
  std::map<int, int> new_textures_;
};

void WarnOfLeftOut(const model::Element& element, std::string_view why, diag::Findings& findings) {
  const std::string name =
      element.name.empty() ? std::string() : fmt::format(" '{}'", element.name);
  findings.Warn(Code::kTargetDropped, element.mark,
                fmt::format("{}{} {}: it is left out", element.tag, name, why),
                "add it where the objects are put together");
}

// Warns of elements of the scene that no object contains.
void ReportLeftOut(const Object& scene, const Owners& owners, diag::Findings& findings) {
  for (const model::Section& section : scene.sections) {
    for (const model::Element& element : section.elements) {
      if (section.info->name == "option") {
        // Elements <option> without a mark are not from the spec, but were added for a pile.
        const bool is_of_pile = !element.mark && !scene.piles.empty();
        findings.Warn(Code::kTargetDropped, is_of_pile ? scene.piles[0].mark : element.mark,
                      "option belongs to the whole scene: it is only in placement.json",
                      "set it where the objects are put together");
        continue;
      }
      const int owner = owners.Of(element);
      if (owner == kNoOwner) WarnOfLeftOut(element, "refers to several objects", findings);
      if (owner == kAnyOwner) WarnOfLeftOut(element, "belongs to the whole scene", findings);
    }
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const int owner = owners.OfBody(i);
    for (const model::Element& view : scene.bodies[i].elements) {
      const int target = owners.Of(view);
      if (owner == kNoOwner) {
        WarnOfLeftOut(view, "belongs to no object", findings);
      } else if (target != kAnyOwner && target != owner) {
        WarnOfLeftOut(view, "looks at another object", findings);
      }
    }
  }
}

}  // namespace

std::optional<std::vector<ScenePart>> Split(const Object& scene, const SplitOptions& options,
                                            diag::Findings& findings) {
  const Owners owners(scene);
  if (owners.roots() == std::vector{0}) {
    findings.Add(Code::kTargetOneObject, scene.bodies.front().mark,
                 fmt::format("'{}' is one object, not a scene of several", scene.name),
                 "write it without --each, or give bodies a `place:` or `joints: free`");
    return std::nullopt;
  }
  ReportLeftOut(scene, owners, findings);
  std::vector<std::string> names;
  for (const int root : owners.roots())
    names.push_back(scene.bodies[static_cast<std::size_t>(root)].name);
  const std::vector<model::Pose> X_WB = model::BodyPoses(scene);
  std::vector<ScenePart> parts;
  bool is_good = true;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    ObjectNames new_names(names, name, options.prefix ? name + '_' : std::string(),
                          options.root.empty() ? name : std::string(options.root));
    const auto root = static_cast<std::size_t>(owners.roots()[i]);
    const model::Body& body = scene.bodies[root];
    ScenePart& part = parts.emplace_back();
    part.object = Extraction(scene, owners, static_cast<int>(i), std::move(new_names))(name);
    part.X_WO = X_WB[root];
    part.at = body.place_name;
    part.is_free = model::FreeJointOf(body) != nullptr;
    is_good &= HasUniqueNames(part.object, findings);
  }
  if (!is_good) return std::nullopt;
  return parts;
}

}  // namespace mjforge::split
