#include "mjforge/engine/rewrite.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/engine/later_mjcf.h"

namespace mjforge::engine {

void Rewriting::Run() {
  for (Placed* joint : elements_.In("joint")) {
    LimitJoint(*joint, "actuatorfrcrange", "actuatorfrclimited");
    LimitJoint(*joint, "actuatorforcerange", "actuatorforcelimited");
  }
  for (Placed* actuator : elements_.In("actuator")) {
    InheritRange(*actuator);
    DampServo(*actuator);
  }
  for (Placed* compiler : elements_.In("compiler")) SetFolders(*compiler);
  for (Placed* light : elements_.In("light")) AimLight(*light);
  for (Placed* camera : elements_.In("camera")) PlaceCamera(*camera);
  for (Placed* material : elements_.In("material")) LayMaterial(*material);
  for (Placed* mesh : elements_.In("mesh")) WeighMesh(*mesh);
}

std::optional<std::string_view> Rewriting::Find(const XmlElement* element,
                                                std::string_view attribute) const {
  const auto found = done_.find(std::pair(element, std::string(attribute)));
  if (found == done_.end()) return std::nullopt;
  return found->second;
}

const std::string* Rewriting::Lacking(const Placed& placed, std::string_view attribute) const {
  const std::string* text = elements_.Find(placed, attribute);
  if (text == nullptr) return nullptr;
  const Later* later = FindLater(placed.parent->tag, placed.element->tag, attribute, *text);
  return later != nullptr && later->since > version_ ? text : nullptr;
}

void Rewriting::Done(Placed& placed, std::string_view attribute, std::string_view why_nothing) {
  const auto mark = [&](const XmlElement* element) {
    std::string_view& kept = done_[{element, std::string(attribute)}];
    if (kept.empty()) kept = why_nothing;
  };
  mark(placed.element);
  for (const XmlElement* element : elements_.DefaultsOf(placed)) {
    if (element->Find(attribute) != nullptr) mark(element);
  }
}

void Rewriting::SetFolders(Placed& compiler) {
  const std::string* folder = Lacking(compiler, "assetdir");
  if (folder == nullptr) return;
  const std::string name = *folder;
  for (const char* setting : {"meshdir", "texturedir"}) {
    if (compiler.element->Find(setting) == nullptr) compiler.element->Set(setting, name);
  }
  Done(compiler, "assetdir");
}

void Rewriting::AimLight(Placed& light) {
  const std::string* type = Lacking(light, "type");
  if (type == nullptr || (*type != "directional" && *type != "spot")) return;
  light.element->Set("directional", *type == "directional" ? "true" : "false");
  Done(light, "type");
}

// The field of view is what a pinhole of this focal length sees on the sensor.
void Rewriting::PlaceCamera(Placed& camera) {
  if (Lacking(camera, "sensorsize") == nullptr) return;
  const auto vertical = [&](std::string_view attribute) {
    const std::vector<double> numbers = NumbersOf(elements_.Get(camera, attribute, ""));
    return numbers.size() == 2 ? numbers[1] : 0;
  };
  const double height = vertical("sensorsize");
  double focal = vertical("focal");
  if (vertical("focalpixel") > 0 && vertical("resolution") > 0) {
    focal = vertical("focalpixel") / vertical("resolution") * height;
  }
  if (height <= 0 || focal <= 0) return;
  camera.element->Set("fovy", TextOf({360 / std::numbers::pi * std::atan2(height / 2, focal)}));
  for (const char* attribute : {"sensorsize", "focal", "focalpixel"}) Done(camera, attribute);
}

// The layer of the colour is the texture of old.
void Rewriting::LayMaterial(Placed& material) {
  std::string texture;
  for (const XmlElement& layer : material.element->children) {
    const Later* later = FindLater(material.element->tag, layer.tag);
    if (later == nullptr || later->since <= version_) continue;
    const std::string* role = layer.Find("role");
    const std::string& name = role == nullptr ? layer.tag : *role;
    if (name != "rgb" && name != "rgba") continue;
    if (const std::string* said = layer.Find("texture")) texture = *said;
    done_[{&layer, ""}] = {};
  }
  if (!texture.empty()) material.element->Set("texture", texture);
}

void Rewriting::WeighMesh(Placed& mesh) {
  if (Lacking(mesh, "inertia") == nullptr) return;
  std::string name = mesh.element->Name();
  const std::string* file = mesh.element->Find("file");
  if (name.empty() && file != nullptr) {  // so MuJoCo names it
    name = file->substr(file->find_last_of("/\\") + 1);
    name.erase(std::min(name.find_last_of('.'), name.size()));
  }
  if (!Weighs(name)) Done(mesh, "inertia", "no mass is computed from the mesh");
}

bool Rewriting::Weighs(const std::string& mesh) {
  const bool all = elements_.Setting("inertiafromgeom", "auto") == "true";
  const auto zero = [&](const Placed& geom, std::string_view attribute) {
    const std::vector<double> numbers = NumbersOf(elements_.Get(geom, attribute, "1"));
    return !numbers.empty() && numbers[0] == 0;
  };
  return std::ranges::any_of(elements_.In("geom"), [&](const Placed* geom) {
    if (elements_.Get(*geom, "mesh", "") != mesh) return false;
    if (elements_.Get(*geom, "type", "sphere") != "mesh") return true;  // fitted to its inertia
    if (geom->parent->tag == "worldbody" || zero(*geom, "mass") || zero(*geom, "density"))
      return false;
    return all || std::ranges::find(geom->parent->children, "inertial", &XmlElement::tag) ==
                      geom->parent->children.end();
  });
}

}  // namespace mjforge::engine
