// Description of an object of ours, from its MJCF and from MuJoCo's compiled model.

#include "our_object.h"
#include "harness/source_folder.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string_view>

#include <pugixml.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/assemble/assemble.h"
#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/sample/sample.h"
#include "mjforge/validate/validate.h"

namespace mjforge::parity {
namespace {

// Value of a word that is not a number: it equals nothing, so that the comparison fails.
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

Numbers NumbersOr(const pugi::xml_node& node, const char* attribute, const Numbers& defaults) {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) return defaults;
  Numbers out;
  std::istringstream words(found.value());
  for (std::string word; words >> word;) {
    out.push_back(expr::ParseNumber(word).value_or(kNotANumber));
  }
  return out.size() < defaults.size() ? Filled(out, defaults) : out;
}

Element Collision(const pugi::xml_node& geom) {
  Element element;
  element.words["role"] = "collision";
  element.numbers["density"] =
      NumbersOr(geom, "density", {geom.attribute("mass") ? kNotANumber : 1000});
  element.numbers["friction"] = NumbersOr(geom, "friction", kFriction);
  element.numbers["solref"] = NumbersOr(geom, "solref", kSolref);
  element.numbers["solimp"] = NumbersOr(geom, "solimp", kSolimp);
  element.numbers["condim"] = NumbersOr(geom, "condim", {3});
  element.numbers["margin"] = NumbersOr(geom, "margin", {0});
  return element;
}

// Describes a visual geom with the colour that MuJoCo compiles: the geom's, or else its material's.
Element Visual(const pugi::xml_node& geom, const pugi::xml_node& asset) {
  Element element;
  element.words["role"] = "visual";
  element.numbers["mass"] = NumbersOr(geom, "mass", {kNotANumber});
  const pugi::xml_node material =
      asset.find_child_by_attribute("material", "name", geom.attribute("material").value());
  const bool has_texture = !material.attribute("texture").empty();
  element.words["look"] = has_texture ? "textured" : "plain";
  element.numbers["rgba"] =
      NumbersOr(geom, "rgba", material ? NumbersOr(material, "rgba", {1, 1, 1, 1}) : kGeomColor);
  return element;
}

Element Geom(const pugi::xml_node& geom, const pugi::xml_node& asset) {
  const Numbers contype = NumbersOr(geom, "contype", {1});
  Element element = contype == Numbers{0} ? Visual(geom, asset) : Collision(geom);
  const std::string type = geom.attribute("type").value();
  element.words["type"] = type;
  element.numbers["size"] = UsedSize(type, NumbersOr(geom, "size", {}));
  element.numbers["pos"] = NumbersOr(geom, "pos", {0, 0, 0});
  element.numbers["quat"] = Canonical(NumbersOr(geom, "quat", {1, 0, 0, 0}));
  element.numbers["contype"] = contype;
  element.numbers["conaffinity"] = NumbersOr(geom, "conaffinity", {1});
  return element;
}

Element Joint(const pugi::xml_node& joint) {
  Element element;
  const bool is_freejoint = std::string_view(joint.name()) == "freejoint";
  element.words["type"] = is_freejoint ? "free" : joint.attribute("type").value();
  for (const char* key : {"damping", "stiffness", "armature", "frictionloss"}) {
    element.numbers[key] = NumbersOr(joint, key, {0});
  }
  element.numbers["pos"] = NumbersOr(joint, "pos", {0, 0, 0});
  element.numbers["axis"] = NumbersOr(joint, "axis", {0, 0, 1});
  element.numbers["limited"] = {joint.attribute("limited").as_bool() ? 1.0 : 0.0};
  element.numbers["range"] = NumbersOr(joint, "range", {0, 0});
  return element;
}

Element Site(const pugi::xml_node& site) {
  Element element;
  const std::string type = site.attribute("type").as_string("sphere");
  element.words["type"] = type;
  element.numbers["size"] = UsedSize(type, NumbersOr(site, "size", {0.005}));
  element.numbers["pos"] = NumbersOr(site, "pos", {0, 0, 0});
  element.numbers["rgba"] = NumbersOr(site, "rgba", kGeomColor);
  return element;
}

std::string BodyName(std::string_view name, const std::string& object_name) {
  return name == object_name ? std::string(kRootBody) : WithoutPrefix(name, object_name + "_");
}

void DescribeBody(const pugi::xml_node& body, const pugi::xml_node& asset, const std::string& name,
                  Described& out) {
  for (const pugi::xml_node& node : body.children()) {
    const std::string_view kind = node.name();
    if (kind == "body") DescribeBody(node, asset, name, out);
    const bool is_joint = kind == "joint" || kind == "freejoint";
    if (!is_joint && kind != "geom" && kind != "site") continue;
    Element element = is_joint ? Joint(node) : kind == "geom" ? Geom(node, asset) : Site(node);
    element.words["body"] = BodyName(body.attribute("name").value(), name);
    const std::string own_name = WithoutPrefix(node.attribute("name").value(), name + "_");
    out[std::string(is_joint ? "joint" : kind) + "/" + own_name] = std::move(element);
  }
}

void DescribeText(const std::string& text, const std::string& name, Described& out) {
  pugi::xml_document document;
  if (!document.load_buffer(text.data(), text.size())) return;
  const pugi::xml_node root = document.child("mujoco");
  DescribeBody(root.child("worldbody").child("body"), root.child("asset"), name, out);
}

Numbers List(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

void AddMass(const model::MassProperties& properties, Element& element) {
  const Eigen::Matrix3d& inertia = properties.I_Cm_F;
  element.numbers["mass"] = {properties.mass};
  element.numbers["com"] = List(properties.p_FCm);
  element.numbers["inertia"] = {inertia(0, 0), inertia(1, 1), inertia(2, 2),
                                inertia(0, 1), inertia(0, 2), inertia(1, 2)};
}

Element Body(const model::Object& object, const model::Body& body, const std::string& name) {
  Element element;
  const Eigen::Quaterniond& q = body.X_PB.q;
  element.words["parent"] =
      body.parent < 0 ? "world"
                      : BodyName(object.bodies[static_cast<std::size_t>(body.parent)].name, name);
  element.numbers["pos"] = List(body.X_PB.p);
  element.numbers["quat"] = Canonical({q.w(), q.x(), q.y(), q.z()});
  AddMass(body.mass_properties, element);
  return element;
}

double HorizontalRadius(const model::Object& object) {
  double radius = 0;
  const std::vector<model::Pose> poses = model::BodyPoses(object);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (const model::Part& part : object.bodies[i].parts) {
      if (part.role == model::Role::kVisual) continue;
      radius = std::max<double>(radius, model::HorizontalRadius(part.shape, poses[i] * part.X_BG));
    }
  }
  return radius;
}

Element Whole(const model::Object& object, const model::Object& compiled) {
  Element element;
  AddMass(compiled.mass_properties, element);
  element.numbers["bottom_offset"] = {object.bounds.bottom_offset};
  element.numbers["top_offset"] = {object.bounds.top_offset};
  element.numbers["declared_radius"] = {object.bounds.horizontal_radius};
  if (!compiled.bounds.aabb.empty()) {
    element.numbers["aabb_min"] = List(compiled.bounds.aabb.min);
    element.numbers["aabb_max"] = List(compiled.bounds.aabb.max);
    element.numbers["horizontal_radius"] = {HorizontalRadius(object)};
  }
  return element;
}

// Moves the mass of a root without parts back to the first body fixed to it. Our objects share that
// mass equally between the two bodies; robosuite's roots have none.
void GiveBack(const model::Object& object, const std::string& name, Described& out) {
  const model::Body& root = object.bodies.front();
  const bool has_own =
      std::ranges::any_of(root.parts, [](const auto& part) { return part.mass > 0; });
  if (has_own || root.mass_properties.mass == 0) return;
  const auto giver =
      std::ranges::find_if(object.bodies.begin() + 1, object.bodies.end(), [&](const auto& body) {
        return body.mass_properties.mass == root.mass_properties.mass && body.joints.empty();
      });
  if (giver == object.bodies.end()) return;
  out.at("body/" + BodyName(root.name, name)).numbers["mass"] = {0};
  Element& element = out.at("body/" + BodyName(giver->name, name));
  for (const char* key : {"mass", "inertia"}) {
    for (double& number : element.numbers.at(key)) number *= 2;
  }
}

// Makes and describes the object of a spec; stops at the first stage that fails.
void Make(const spec::ObjectSpec& spec, const std::string& name, diag::Sources& sources,
          diag::Findings& findings, Described& out) {
  auto values = sample::Sample(spec, {}, sample::kRootStream, {}, findings);
  if (!values) return;
  assemble::Assembler assembler;
  const auto object = assembler.Assemble(*values, {.name = name}, findings);
  if (!object) return;
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(*object, mjcf::Target::kMujoco, mjcf::Provenance{}, document);
  validate::Loader loader;
  loader.Validate(document, *object, findings);
  const harness::TemporaryFolder folder;
  const auto compiled = loader.Load(folder.Write("object.xml", document.text), sources, findings);
  if (!compiled) return;
  DescribeText(document.text, name, out);
  for (const model::Body& body : compiled->object.bodies) {
    out["body/" + BodyName(body.name, name)] = Body(compiled->object, body, name);
  }
  GiveBack(*object, name, out);
  out["whole"] = Whole(*object, compiled->object);
}

}  // namespace

OurObject MakeObject(const std::string& spec_name, const std::string& name,
                     const std::vector<spec::Setting>& settings) {
  OurObject out;
  diag::Sources sources;
  diag::Findings findings;
  const spec::LoadOptions options{.settings = settings,
                                  .parameter_files = {},
                                  .search_path = {harness::SourceFolder() / "specs"}};
  const auto spec = spec::LoadSpec(spec_name, options, sources, findings);
  if (spec) Make(*spec, name, sources, findings, out.described);
  for (const diag::Finding& finding : findings) {
    out.findings += diag::RenderText(finding, sources, false);
  }
  return out;
}

}  // namespace mjforge::parity
