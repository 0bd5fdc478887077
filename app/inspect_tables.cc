// `mjforge inspect`: tables about a variant or an MJCF file.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "inspect.h"
#include "mjforge/report/report.h"
#include "text_table.h"

namespace mjforge::app {
namespace {

// Returns a number with six significant digits; files have more digits.
std::string Number(double value) { return fmt::format("{:.6g}", value + 0.0); }

template <typename Numbers>
std::string NumbersText(const Numbers& numbers) {
  return diag::Joined(numbers, " ", Number);
}

std::string ValueText(const sample::ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return Number(*number);
  if (const auto text = report::TextOfWords(value)) return *text;
  return NumbersText(std::get<std::vector<double>>(value));
}

// Returns the role of a part. Geoms of attached files (`as_is`) have no separate visual geom, so
// "both" does not apply to them.
std::string_view RoleName(const model::Part& part) {
  return part.role == model::Role::kVisual                ? "visual"
         : part.role == model::Role::kBoth && !part.as_is ? "both"
                                                          : "collision";
}

std::string SizeText(const model::Shape& shape) {
  if (shape.mesh != nullptr) return fmt::format("{} vertices", shape.mesh->vertices.size());
  return NumbersText(shape.size.head(model::SizeCount(shape.type)));
}

std::string ParametersText(const forge::Recipe& recipe, const forge::Variant& variant) {
  TextTable table({"parameter", "spec", "here", "unit", "section", "doc"});
  for (std::size_t i = 0; i < recipe.spec->parameters.size(); ++i) {
    const spec::Parameter& parameter = recipe.spec->parameters[i];
    table.Add({parameter.name, parameter.source, ValueText(variant.record.params[i].second),
               parameter.unit, parameter.section, parameter.doc});
  }
  return table.empty() ? "" : table.Render() + "\n";
}

// Sets components to zero that are only rounding errors of sums of numbers of magnitude `scale`.
Eigen::Vector3d WithoutNoise(const Eigen::Vector3d& vector, double scale) {
  return (vector.array().abs() < 1e-12 * scale).select(0, vector);
}

double LengthOf(const model::Box3& aabb) { return aabb.empty() ? 0 : (aabb.max - aabb.min).norm(); }

std::string ComText(const model::MassProperties& properties, const model::Box3& aabb) {
  return NumbersText(WithoutNoise(properties.p_FCm, LengthOf(aabb)));
}

// Returns an inertia as "xx yy zz  xy xz yz".
std::string InertiaText(const model::MassProperties& properties) {
  const Eigen::Matrix3d& I = properties.I_Cm_F;
  const Eigen::Vector3d products = WithoutNoise({I(0, 1), I(0, 2), I(1, 2)}, I.trace());
  return fmt::format("{}  {}", NumbersText(I.diagonal()), NumbersText(products));
}

// Returns a quaternion as "w x y z"; empty if the axes are parallel to those of the parent.
std::string QuatText(const Eigen::Quaterniond& q) {
  if (q.vec().norm() < 1e-12) return "";
  return fmt::format("{} {}", Number(q.w()), NumbersText(q.vec()));
}

// Returns the body's name; empty if the object has only one body.
std::string BodyText(const model::Object& object, const model::Body& body) {
  return object.bodies.size() > 1 ? body.name : "";
}

// Returns the table of bodies. `geoms` has the number of geoms of each body of an MJCF file. For an
// object, `geoms` is empty, and the root body has no parent in the table.
std::string BodiesText(const model::Object& object, std::span<const int> geoms) {
  TextTable table({"body", "parent", "pos", "quat", "geoms", "kg", "com", "inertia, kg m^2"});
  for (const int number : mjcf::DepthFirstOrder(object)) {
    const auto i = static_cast<std::size_t>(number);
    const model::Body& body = object.bodies[i];
    const model::MassProperties& mass = body.mass_properties;
    const bool is_root = geoms.empty() && i == 0;
    table.Add({body.name,
               is_root           ? ""
               : body.parent < 0 ? "world"
                                 : object.bodies[static_cast<std::size_t>(body.parent)].name,
               NumbersText(body.X_PB.p), QuatText(body.X_PB.q),
               geoms.empty() ? "" : fmt::format("{}", geoms[i]), Number(mass.mass),
               mass.mass > 0 ? ComText(mass, object.bounds.aabb) : "",
               mass.mass > 0 ? InertiaText(mass) : ""});
  }
  return table.Render() + "\n";
}

std::string PartsText(const model::Object& object) {
  TextTable table({"part", "body", "type", "role", "size", "pos", "kg"});
  for (const model::Body& body : object.bodies) {
    for (const model::Part& part : body.parts) {
      table.Add({part.name, BodyText(object, body),
                 std::string(model::GeomTypeName(part.shape.type)), std::string(RoleName(part)),
                 SizeText(part.shape), NumbersText(part.X_BG.p), Number(part.mass)});
    }
  }
  return table.Render() + "\n";
}

std::string JointsText(const model::Object& object, bool always_bodies) {
  TextTable table({"joint", "body", "type", "axis", "range", "start"});
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      const bool has_axis = joint.type == "hinge" || joint.type == "slide";
      table.Add({joint.name, always_bodies ? body.name : BodyText(object, body),
                 std::string(joint.type), has_axis ? NumbersText(joint.axis) : "",
                 joint.range ? NumbersText(*joint.range) : "", NumbersText(joint.start)});
    }
  }
  return table.empty() ? "" : table.Render() + "\n";
}

std::string RegionsText(const model::Object& object) {
  TextTable table({"region", "body", "type", "size", "height", "margin", "clear", "walls"});
  for (const model::Body& body : object.bodies) {
    for (const model::Region& region : body.regions) {
      const bool is_disc = region.type == model::RegionType::kDisc;
      table.Add({region.name, BodyText(object, body),
                 std::string(model::RegionTypeName(region.type)),
                 NumbersText(region.half_size.head(is_disc ? 1 : 2)),
                 std::isinf(region.height) ? "" : Number(region.height),
                 region.margin > 0 ? Number(region.margin) : "",
                 region.clear > 0 ? Number(region.clear) : "", region.has_walls ? "yes" : ""});
    }
  }
  return table.empty() ? "" : table.Render() + "\n";
}

// Leaves out the sites of regions, which have a table of their own.
std::string SitesText(const model::Object& object) {
  TextTable table({"site", "body", "pos"});
  for (const model::Body& body : object.bodies) {
    for (const model::Site& site : body.sites) {
      if (std::ranges::find(body.regions, site.name, &model::Region::site) != body.regions.end())
        continue;
      table.Add({site.name, BodyText(object, body), NumbersText(site.X_BS.p)});
    }
  }
  return table.empty() ? "" : table.Render() + "\n";
}

// Lists cameras and lights of bodies, then the elements of sections.
std::string ElementsText(const model::Object& object) {
  TextTable table({"element", "kind", "of"});
  for (const model::Body& body : object.bodies) {
    for (const model::Element& element : body.elements) {
      table.Add({element.name, std::string(element.tag), body.name});
    }
  }
  for (const model::Section& section : object.sections) {
    for (const model::Element& element : section.elements) {
      table.Add({element.name, std::string(element.tag), std::string(section.info->name)});
    }
  }
  return table.empty() ? "" : table.Render() + "\n";
}

std::string TotalsText(const model::MassProperties& properties, const model::Box3& aabb) {
  std::string text;
  if (!aabb.empty()) {
    text += fmt::format("bounds   {} to {} m\n", NumbersText(aabb.min), NumbersText(aabb.max));
  }
  text += fmt::format("mass     {} kg\n", Number(properties.mass));
  text += fmt::format("com      {} m\n", ComText(properties, aabb));
  text += fmt::format("inertia  {} kg m^2 (xx yy zz  xy xz yz)\n", InertiaText(properties));
  return text;
}

std::string SizeOfText(const mjcf::MjcfDocument& document) {
  const std::size_t meshes = mjcf::MeshBytes(document.text);
  return fmt::format("text     {} bytes of MJCF{}\n", document.text.size(),
                     meshes > 0 ? fmt::format(", {} of them in meshes", meshes) : "");
}

// Lists contacts between bodies during the sweep of the joints, and the bounds of all poses.
std::string SweepText(const std::optional<validate::Sweep>& sweep) {
  if (!sweep) return "";
  TextTable table({"joint", "at", "body", "geom", "body", "geom", "mm deep"});
  for (const validate::Sweep::Contact& contact : sweep->contacts) {
    const bool alone = !contact.joint.empty();
    table.Add({alone ? contact.joint : "several", alone ? Number(contact.value) : "", contact.body1,
               contact.geom1, contact.body2, contact.geom2,
               fmt::format("{:.3g}", 1000 * contact.depth)});
  }
  std::string text =
      "\n" + (table.empty() ? "no contacts between bodies\n" : table.Render()) + "\n";
  for (const std::string& joint : sweep->unlimited_slides) {
    text += fmt::format("held     {}, a slide without a range\n", OneLine(joint));
  }
  const model::Box3& box = sweep->aabb;
  if (!box.empty()) {
    text += fmt::format("swept    {} to {} m\n", NumbersText(box.min), NumbersText(box.max));
  }
  return text;
}

}  // namespace

std::string InspectTables(const forge::Recipe& recipe, const forge::Variant& variant,
                          const std::optional<validate::Sweep>& sweep) {
  const spec::ObjectSpec& spec = *recipe.spec;
  const model::Object& object = *variant.object;
  const manifest::Record& record = variant.record;
  std::string text = spec.description.empty()
                         ? fmt::format("{}\n\n", spec.name)
                         : fmt::format("{}: {}\n\n", spec.name, OneLine(spec.description));
  text += ParametersText(recipe, variant);
  text += fmt::format("seed {}{}, index {}, attempt {}\n\n", record.seed,
                      record.place_seed ? fmt::format(", place seed {}", *record.place_seed) : "",
                      record.index, record.attempt);
  if (object.bodies.size() > 1) text += BodiesText(object, {});
  text += PartsText(object) + JointsText(object, false) + RegionsText(object) + SitesText(object) +
          ElementsText(object);
  text += TotalsText(object.mass_properties, object.bounds.aabb);
  text += fmt::format("radius   {} m about the z axis\n", Number(object.bounds.horizontal_radius));
  if (const auto& [box, swept] = std::pair(object.bounds.aabb, object.bounds.swept);
      box.min != swept.min || box.max != swept.max) {
    text += fmt::format("reach    {} to {} m with all positions of joints\n",
                        NumbersText(swept.min), NumbersText(swept.max));
  }
  text += SizeOfText(variant.document);
  return text + SweepText(sweep);
}

std::string InspectTables(const validate::CompiledModel& model,
                          const std::optional<validate::Sweep>& sweep) {
  const model::Object& object = model.object;
  TextTable elements({"element", "kind"});
  for (const auto& [kind, name] : model.elements) elements.Add({name, kind});
  std::string text = OneLine(object.name) + "\n\n" + BodiesText(object, model.body_geoms) +
                     JointsText(object, true);
  if (!elements.empty()) text += elements.Render() + "\n";
  return text + TotalsText(object.mass_properties, object.bounds.aabb) + SweepText(sweep);
}

}  // namespace mjforge::app
