#include <fmt/format.h>

#include "inspect.h"
#include "table.h"

namespace mjforge::app {
namespace {

// Tables are for eyes: fewer digits than the files have.
std::string Number(double value) { return fmt::format("{:.6g}", value + 0.0); }

template <typename Numbers>
std::string NumbersText(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) text += ' ';
    text += Number(number);
  }
  return text;
}

std::string VectorText(const Eigen::Vector3d& vector) {
  return fmt::format("{} {} {}", Number(vector.x()), Number(vector.y()), Number(vector.z()));
}

std::string ValueText(const sample::ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return Number(*number);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return NumbersText(std::get<std::vector<double>>(value));
}

std::string_view RoleName(model::Role role) {
  return role == model::Role::kBoth        ? "both"
         : role == model::Role::kCollision ? "collision"
                                           : "visual";
}

std::string SizeText(const model::Shape& shape) {
  if (shape.mesh != nullptr) return fmt::format("{} vertices", shape.mesh->vertices.size());
  return NumbersText(shape.size.head(model::SizeCount(shape.type)));
}

std::string Parameters(const forge::Recipe& recipe, const forge::Variant& variant) {
  Table table({"parameter", "spec", "here", "unit", "doc"});
  for (std::size_t i = 0; i < recipe.spec->parameters.size(); ++i) {
    const spec::Parameter& parameter = recipe.spec->parameters[i];
    table.Add({parameter.name, parameter.source, ValueText(variant.record.params[i].second),
               parameter.unit, parameter.doc});
  }
  return table.empty() ? "" : table.Render() + "\n";
}

std::string Parts(const model::Object& object) {
  Table table({"part", "type", "role", "size", "pos", "kg"});
  for (const model::Body& body : object.bodies) {
    for (const model::Part& part : body.parts) {
      table.Add({part.name, std::string(model::GeomTypeName(part.shape.type)),
                 std::string(RoleName(part.role)), SizeText(part.shape), VectorText(part.X_BG.p),
                 Number(part.mass)});
    }
  }
  return table.Render() + "\n";
}

std::string Joints(const model::Object& object) {
  Table table({"joint", "type", "axis", "range"});
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      const bool has_axis = joint.type == "hinge" || joint.type == "slide";
      table.Add({joint.name, std::string(joint.type), has_axis ? VectorText(joint.axis) : "",
                 joint.range ? NumbersText(*joint.range) : ""});
    }
  }
  return table.empty() ? "" : table.Render() + "\n";
}

std::string Sites(const model::Object& object) {
  Table table({"site", "pos"});
  for (const model::Body& body : object.bodies) {
    for (const model::Site& site : body.sites) table.Add({site.name, VectorText(site.X_BS.p)});
  }
  return table.empty() ? "" : table.Render() + "\n";
}

// Sums of numbers of the size `scale` that cancel leave rounding errors behind.
Eigen::Vector3d WithoutNoise(const Eigen::Vector3d& vector, double scale) {
  return (vector.array().abs() < 1e-12 * scale).select(0, vector);
}

std::string Totals(const model::MassProperties& properties, const model::Box3& aabb) {
  const Eigen::Matrix3d& I = properties.I_Cm_F;
  const double length = aabb.empty() ? 0 : (aabb.max - aabb.min).norm();
  const Eigen::Vector3d products = WithoutNoise({I(0, 1), I(0, 2), I(1, 2)}, I.trace());
  std::string text;
  if (!aabb.empty()) {
    text += fmt::format("bounds   {} to {} m\n", VectorText(aabb.min), VectorText(aabb.max));
  }
  text += fmt::format("mass     {} kg\n", Number(properties.mass));
  text += fmt::format("com      {} m\n", VectorText(WithoutNoise(properties.p_FCm, length)));
  text += fmt::format("inertia  {}  {} kg m^2 (xx yy zz  xy xz yz)\n", VectorText(I.diagonal()),
                      VectorText(products));
  return text;
}

}  // namespace

std::string InspectTables(const forge::Recipe& recipe, const forge::Variant& variant) {
  const spec::ObjectSpec& spec = *recipe.spec;
  const model::Object& object = *variant.object;
  const output::Record& record = variant.record;
  std::string text = spec.description.empty()
                         ? fmt::format("{}\n\n", spec.name)
                         : fmt::format("{}: {}\n\n", spec.name, spec.description);
  text += Parameters(recipe, variant);
  text +=
      fmt::format("seed {}, index {}, attempt {}\n\n", record.seed, record.index, record.attempt);
  text += Parts(object) + Joints(object) + Sites(object);
  text += Totals(object.mass_properties, object.bounds.aabb);
  text += fmt::format("radius   {} m about the z axis\n", Number(object.bounds.horizontal_radius));
  return text;
}

std::string InspectTables(const validate::CompiledModel& model) {
  Table bodies({"body", "parent", "geoms", "kg", "principal inertia, kg m^2"});
  for (const validate::CompiledModel::Body& body : model.bodies) {
    bodies.Add({body.name, body.parent, fmt::format("{}", body.geoms), Number(body.mass),
                VectorText(body.inertia)});
  }
  Table joints({"joint", "body", "type", "axis", "range"});
  for (const validate::CompiledModel::Joint& joint : model.joints) {
    const bool has_axis = joint.type == "hinge" || joint.type == "slide";
    joints.Add({joint.name, joint.body, joint.type, has_axis ? VectorText(joint.axis) : "",
                joint.limited ? NumbersText(joint.range) : ""});
  }
  std::string text = fmt::format("{}\n\n{}\n", model.name, bodies.Render());
  if (!joints.empty()) text += joints.Render() + "\n";
  return text + Totals(model.mass_properties, model.aabb);
}

}  // namespace mjforge::app
