#include "reference_object.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

namespace mjforge::parity {
namespace {

using nlohmann::json;

std::filesystem::path Folder() {
  return std::filesystem::path(MJFORGE_SOURCE_DIR) / "tests" / "reference";
}

Numbers NumbersOr(const json& element, const char* key, const Numbers& defaults) {
  const auto found = element.find(key);
  if (found == element.end() || found->is_null()) return defaults;
  if (!found->is_array()) return {found->get<double>()};
  return Filled(found->get<Numbers>(),
                defaults.size() < found->size() ? found->get<Numbers>() : defaults);
}

Element Collision(const json& geom) {
  Element element;
  element.words["role"] = "collision";
  element.numbers["density"] = NumbersOr(geom, "density", {1000});
  element.numbers["friction"] = NumbersOr(geom, "friction", kFriction);
  element.numbers["solref"] = NumbersOr(geom, "solref", kSolref);
  element.numbers["solimp"] = NumbersOr(geom, "solimp", kSolimp);
  element.numbers["condim"] = NumbersOr(geom, "condim", {3});
  element.numbers["margin"] = NumbersOr(geom, "margin", {0});
  return element;
}

Element Visual(const json& geom) {
  Element element;
  element.words["role"] = "visual";
  element.numbers["mass"] = {0};
  if (!geom.at("rgba").is_null() || geom.at("material").is_null()) {
    element.numbers["rgba"] = NumbersOr(geom, "rgba", kGeomColor);
  } else {
    element.words["look"] = "textured";
  }
  return element;
}

Element Geom(const json& geom) {
  Element element = geom.at("group") == 0 ? Collision(geom) : Visual(geom);
  const auto type = geom.at("type").get<std::string>();
  element.words["type"] = type;
  element.numbers["size"] = UsedSize(type, geom.at("size").get<Numbers>());
  element.numbers["pos"] = geom.at("pos").get<Numbers>();
  element.numbers["quat"] = Canonical(NumbersOr(geom, "quat", {1, 0, 0, 0}));
  element.numbers["contype"] = NumbersOr(geom, "contype", {1});
  element.numbers["conaffinity"] = NumbersOr(geom, "conaffinity", {1});
  return element;
}

// As compiled, so that defaults are filled in.
Element Joint(const json& joint) {
  Element element;
  const auto type = joint.at("type").get<std::string>();
  element.words["type"] = type;
  for (const char* key : {"damping", "stiffness", "armature", "frictionloss"}) {
    element.numbers[key] = {joint.at(key).get<double>()};
  }
  if (type == "free") return element;
  element.numbers["pos"] = joint.at("pos").get<Numbers>();
  element.numbers["axis"] = joint.at("axis").get<Numbers>();
  element.numbers["limited"] = {joint.at("limited").get<double>()};
  element.numbers["range"] = joint.at("range").get<Numbers>();
  return element;
}

Element Site(const json& site) {
  Element element;
  const std::string type = site.value("type", "sphere");
  element.words["type"] = type;
  element.numbers["size"] = UsedSize(type, site.at("size").get<Numbers>());
  element.numbers["pos"] = site.at("pos").get<Numbers>();
  element.numbers["rgba"] = site.at("rgba").get<Numbers>();
  return element;
}

Element Whole(const json& reference) {
  Element element;
  const json& masses = reference.at("mujoco_group0_inertia");
  element.numbers["mass"] = {masses.at("total_mass").get<double>()};
  element.numbers["com"] = masses.at("com").get<Numbers>();
  element.numbers["inertia"] = masses.at("inertia_about_com").get<Numbers>();
  const json& compiled = reference.at("mujoco");
  if (const json& box = compiled.at("aabb_collision"); !box.is_null()) {
    element.numbers["aabb_min"] = box.at("min").get<Numbers>();
    element.numbers["aabb_max"] = box.at("max").get<Numbers>();
    element.numbers["horizontal_radius"] = {compiled.at("horizontal_radius_exact").get<double>()};
  }
  return element;
}

}  // namespace

std::vector<std::string> ReferenceNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(Folder())) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

json ReadReference(std::string_view name) {
  std::ifstream file(Folder() / fmt::format("{}.json", name));
  return json::parse(file);
}

Described DescribeReference(const json& reference) {
  const auto prefix = reference.at("properties").at("naming_prefix").get<std::string>();
  const auto key = [&prefix](std::string_view kind, const json& element) {
    return fmt::format("{}/{}", kind, WithoutPrefix(element.at("name").get<std::string>(), prefix));
  };
  Described out;
  for (const json& geom : reference.at("geoms")) out[key("geom", geom)] = Geom(geom);
  for (const json& joint : reference.at("mujoco").at("joints"))
    out[key("joint", joint)] = Joint(joint);
  for (const json& site : reference.at("sites")) out[key("site", site)] = Site(site);
  out.erase("site/default_site");
  out["whole"] = Whole(reference);
  return out;
}

}  // namespace mjforge::parity
