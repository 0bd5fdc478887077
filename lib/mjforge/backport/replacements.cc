// Replaces attributes and elements of compilers, lights, cameras, materials and meshes.
#include "mjforge/backport/replacements.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/backport/mesh_inertia.h"
#include "mjforge/backport/mesh_measure.h"
#include "mjforge/backport/mjcf_versions.h"

namespace mjforge::backport {

void Replacements::Run() {
  for (ClassedElement* joint : elements_.In("joint")) {
    ReplaceJointForceRange(*joint, "actuatorfrcrange", "actuatorfrclimited");
    ReplaceJointForceRange(*joint, "actuatorforcerange", "actuatorforcelimited");
  }
  for (ClassedElement* actuator : elements_.In("actuator")) {
    ReplaceInheritedRange(*actuator);
    ReplaceDamping(*actuator);
  }
  for (ClassedElement* compiler : elements_.In("compiler")) ReplaceAssetFolder(*compiler);
  for (ClassedElement* light : elements_.In("light")) ReplaceLightType(*light);
  for (ClassedElement* camera : elements_.In("camera")) ReplaceSensorSize(*camera);
  for (ClassedElement* material : elements_.In("material")) ReplaceColorLayer(*material);
  for (ClassedElement* mesh : elements_.In("mesh")) ReplaceMeshInertia(*mesh);
}

std::optional<std::string_view> Replacements::Find(const xml::XmlElement* element,
                                                   std::string_view attribute) const {
  const auto found = replaced_.find(std::pair(element, std::string(attribute)));
  if (found == replaced_.end()) return std::nullopt;
  return found->second;
}

const std::string* Replacements::FindMissing(const ClassedElement& classed,
                                             std::string_view attribute) const {
  const std::string* text = elements_.Find(classed, attribute);
  if (text == nullptr) return nullptr;
  const MjcfFeature* feature =
      FindFeature(classed.parent->tag, classed.element->tag, attribute, *text);
  return feature != nullptr && feature->since > version_ ? text : nullptr;
}

void Replacements::MarkReplaced(ClassedElement& classed, std::string_view attribute,
                                std::string_view why_neutral) {
  const auto mark = [&](const xml::XmlElement* element) {
    std::string_view& kept = replaced_[{element, std::string(attribute)}];
    if (kept.empty()) kept = why_neutral;
  };
  mark(classed.element);
  for (const xml::XmlElement* element : elements_.DefaultsOf(classed)) {
    if (element->Find(attribute) != nullptr) mark(element);
  }
}

void Replacements::ReplaceAssetFolder(ClassedElement& compiler) {
  const std::string* folder = FindMissing(compiler, "assetdir");
  if (folder == nullptr) return;
  const std::string name = *folder;
  for (const char* setting : {"meshdir", "texturedir"}) {
    if (compiler.element->Find(setting) == nullptr) compiler.element->Set(setting, name);
  }
  MarkReplaced(compiler, "assetdir");
}

void Replacements::ReplaceLightType(ClassedElement& light) {
  const std::string* type = FindMissing(light, "type");
  if (type == nullptr || (*type != "directional" && *type != "spot")) return;
  light.element->Set("directional", *type == "directional" ? "true" : "false");
  MarkReplaced(light, "type");
}

// Replaces the sensor size of a pinhole camera by `fovy`, computed from the focal length and the
// height of the sensor.
void Replacements::ReplaceSensorSize(ClassedElement& camera) {
  if (FindMissing(camera, "sensorsize") == nullptr) return;
  const auto vertical = [&](std::string_view attribute) {
    const std::vector<double> numbers = xml::NumbersOf(elements_.Get(camera, attribute, ""));
    return numbers.size() == 2 ? numbers[1] : 0;
  };
  const double height = vertical("sensorsize");
  double focal = vertical("focal");
  if (vertical("focalpixel") > 0 && vertical("resolution") > 0) {
    focal = vertical("focalpixel") / vertical("resolution") * height;
  }
  if (height <= 0 || focal <= 0) return;
  camera.element->Set("fovy",
                      xml::TextOf({360 / std::numbers::pi * std::atan2(height / 2, focal)}));
  for (const char* attribute : {"sensorsize", "focal", "focalpixel"})
    MarkReplaced(camera, attribute);
}

// Replaces the colour layer of a material by the attribute `texture`.
void Replacements::ReplaceColorLayer(ClassedElement& material) {
  std::string texture;
  for (const xml::XmlElement& layer : material.element->children) {
    const MjcfFeature* feature = FindFeature(material.element->tag, layer.tag);
    if (feature == nullptr || feature->since <= version_) continue;
    const std::string* role = layer.Find("role");
    const std::string& name = role == nullptr ? layer.tag : *role;
    if (name != "rgb" && name != "rgba") continue;
    if (const std::string* said = layer.Find("texture")) texture = *said;
    replaced_[{&layer, ""}] = {};
  }
  if (!texture.empty()) material.element->Set("texture", texture);
}

void Replacements::ReplaceMeshInertia(ClassedElement& mesh) {
  const std::string* inertia = FindMissing(mesh, "inertia");
  if (inertia == nullptr) return;
  const std::string name = mesh.element->AssetName();
  if (!HasMass(name)) return MarkReplaced(mesh, "inertia", "no mass is computed from the mesh");
  if (!KindNamed(*inertia) || !CanComputeMasses(name)) return;
  mesh.element->Set("inertia", std::string(*inertia));
  MarkReplaced(mesh, "inertia");
}

bool Replacements::CanComputeMasses(const std::string& mesh) {
  if (!kComputesMeshInertia || elements_.Setting("inertiafromgeom", "auto") == "false" ||
      elements_.Setting("exactmeshinertia", "false") != "false" ||
      elements_.Setting("coordinate", "local") != "local")
    return false;
  return std::ranges::none_of(elements_.In("geom"), [&](const ClassedElement* geom) {
    return elements_.Get(*geom, "mesh", "") == mesh &&
           (elements_.Get(*geom, "type", "sphere") != "mesh" ||
            elements_.Get(*geom, "shellinertia", "false") != "false");
  });
}

bool Replacements::HasMass(const std::string& mesh) {
  const bool all = elements_.Setting("inertiafromgeom", "auto") == "true";
  const auto zero = [&](const ClassedElement& geom, std::string_view attribute) {
    const std::vector<double> numbers = xml::NumbersOf(elements_.Get(geom, attribute, "1"));
    return !numbers.empty() && numbers[0] == 0;
  };
  return std::ranges::any_of(elements_.In("geom"), [&](const ClassedElement* geom) {
    if (elements_.Get(*geom, "mesh", "") != mesh) return false;
    if (elements_.Get(*geom, "type", "sphere") != "mesh")
      return true;  // the shape is fitted to the inertia of the mesh
    if (geom->parent->tag == "worldbody" || zero(*geom, "mass") || zero(*geom, "density"))
      return false;
    return all || std::ranges::find(geom->parent->children, "inertial", &xml::XmlElement::tag) ==
                      geom->parent->children.end();
  });
}

}  // namespace mjforge::backport
