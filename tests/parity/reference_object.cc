// Description of robosuite's objects, from the files of tests/reference.

#include "reference_object.h"
#include "harness/source_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <Eigen/Dense>

namespace mjforge::parity {
namespace {

using nlohmann::json;

std::filesystem::path Folder() { return harness::SourceFolder() / "tests" / "reference"; }

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

// Describes a joint of the compiled model, which includes defaults.
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

// Returns the inertia about the centre of mass, along the body's axes.
Numbers Inertia(const json& body) {
  const auto principal = body.at("inertia").get<Numbers>();
  const auto q = body.at("iquat").get<Numbers>();
  const Eigen::Matrix3d R =
      Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  const Eigen::Matrix3d I =
      R * Eigen::Vector3d(principal[0], principal[1], principal[2]).asDiagonal() * R.transpose();
  return {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
}

// Returns the body's name without the suffix `_main` or `_root`, which robosuite adds for children.
std::string ReferenceBodyName(std::string_view name, std::string_view prefix) {
  std::string out = WithoutPrefix(name, prefix);
  for (const std::string_view suffix : {"_main", "_root"}) {
    if (out.ends_with(suffix)) return out.substr(0, out.size() - suffix.size());
  }
  return out == "main" || out == "root" ? std::string(kRootBody) : out;
}

// Describes a body. An only body has no mass, because "whole" has it.
Element Body(const json& body, const json& masses, std::string_view prefix, bool is_only) {
  Element element;
  const auto parent = body.at("parent").get<std::string>();
  element.words["parent"] = parent == "world" ? parent : ReferenceBodyName(parent, prefix);
  element.numbers["pos"] = body.at("pos").get<Numbers>();
  element.numbers["quat"] = Canonical(body.at("quat").get<Numbers>());
  if (is_only) return element;
  element.numbers["mass"] = {masses.at("mass").get<double>()};
  if (masses.at("mass") == 0) return element;
  element.numbers["com"] = masses.at("ipos").get<Numbers>();
  element.numbers["inertia"] = Inertia(masses);
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
  if (reference.at("kind") != "composite_body") return element;
  const json& declared = reference.at("properties");
  element.numbers["bottom_offset"] = {declared.at("bottom_offset").at(2).get<double>()};
  element.numbers["top_offset"] = {declared.at("top_offset").at(2).get<double>()};
  element.numbers["declared_radius"] = {declared.at("horizontal_radius").get<double>()};
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
  const auto add = [&](std::string_view kind, const json& element, Element described) {
    described.words["body"] = ReferenceBodyName(element.at("body").get<std::string>(), prefix);
    out[key(kind, element)] = std::move(described);
  };
  for (const json& geom : reference.at("geoms")) add("geom", geom, Geom(geom));
  for (const json& joint : reference.at("mujoco").at("joints")) add("joint", joint, Joint(joint));
  for (const json& site : reference.at("sites")) add("site", site, Site(site));
  std::erase_if(out, [](const auto& entry) { return entry.first.ends_with("default_site"); });
  const json& bodies = reference.at("mujoco").at("bodies");
  const json& masses = reference.at("mujoco_group0_inertia").at("bodies");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string name = ReferenceBodyName(bodies[i].at("name").get<std::string>(), prefix);
    out["body/" + name] = Body(bodies[i], masses.at(i), prefix, bodies.size() == 1);
  }
  out["whole"] = Whole(reference);
  return out;
}

}  // namespace mjforge::parity
