#include "inspect.h"
#include "json.h"

namespace mjforge::app {
namespace {

void Parameters(Json& json, const forge::Recipe& recipe, const forge::Variant& variant) {
  auto drawn = variant.record.params.begin();
  json.Each("parameters", recipe.spec->parameters, [&](const spec::Parameter& parameter) {
    json.Member("name", parameter.name);
    json.Member("spec", parameter.source);
    json.Member("value", (drawn++)->second);
    json.Member("unit", parameter.unit);
    json.Member("doc", parameter.doc);
  });
}

void Pose(Json& json, const model::Pose& pose) {
  json.Member("pos", pose.p);
  json.Member("quat", Eigen::Vector4d(pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()));
}

void Parts(Json& json, const model::Body& body) {
  json.Each("parts", body.parts, [&](const model::Part& part) {
    json.Member("name", part.name);
    json.Member("type", model::GeomTypeName(part.shape.type));
    json.Member("collides", part.role != model::Role::kVisual);
    json.Member("visible", part.role != model::Role::kCollision);
    json.Member("size", part.shape.size.head(model::SizeCount(part.shape.type)));
    Pose(json, part.X_BG);
    json.Member("mass", part.mass);
  });
}

void Joints(Json& json, const model::Body& body) {
  json.Each("joints", body.joints, [&](const model::Joint& joint) {
    json.Member("name", joint.name);
    json.Member("type", joint.type);
    if (joint.type == "hinge" || joint.type == "slide") json.Member("axis", joint.axis);
    if (joint.range) json.Member("range", *joint.range);
    if (!joint.start.empty()) json.Member("start", joint.start);
  });
}

void Sites(Json& json, const model::Body& body) {
  json.Each("sites", body.sites, [&](const model::Site& site) {
    json.Member("name", site.name);
    Pose(json, site.X_BS);
  });
}

void Box(Json& json, const model::Box3& aabb) {
  json.Key("aabb");
  json.StartObject();
  json.Member("min", aabb.min);
  json.Member("max", aabb.max);
  json.EndObject();
}

// Inertia as in the manifest: xx yy zz xy xz yz.
void Mass(Json& json, const model::MassProperties& properties) {
  const Eigen::Matrix3d& I = properties.I_Cm_F;
  json.Member("mass", properties.mass);
  json.Member("com", properties.p_FCm);
  json.Member("inertia",
              Eigen::Vector<double, 6>(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
}

void Elements(Json& json, std::string_view key, const std::vector<model::Element>& elements) {
  json.Each(key, elements, [&](const model::Element& element) {
    json.Member("kind", element.tag);
    json.Member("name", element.name);
  });
}

void Sections(Json& json, const model::Object& object) {
  json.Key("sections");
  json.StartObject();
  for (const model::Section& section : object.sections) {
    Elements(json, section.info->name, section.elements);
  }
  json.EndObject();
}

void BodyHead(Json& json, const model::Object& object, const model::Body& body) {
  json.Member("name", body.name);
  json.Member("parent", body.parent < 0
                            ? std::string_view("world")
                            : object.bodies[static_cast<std::size_t>(body.parent)].name);
  Pose(json, body.X_PB);
  Mass(json, body.mass_properties);
}

// What several joints do has neither joint nor value.
void Sweep(Json& json, const std::optional<validate::Sweep>& sweep) {
  if (!sweep) return;
  json.Key("sweep");
  json.StartObject();
  json.Each("contacts", sweep->contacts, [&](const validate::Sweep::Contact& contact) {
    if (contact.joint.empty()) {
      json.Member("joint", nullptr);
      json.Member("value", nullptr);
    } else {
      json.Member("joint", contact.joint);
      json.Member("value", contact.value);
    }
    json.Member("body1", contact.body1);
    json.Member("geom1", contact.geom1);
    json.Member("body2", contact.body2);
    json.Member("geom2", contact.geom2);
    json.Member("depth", contact.depth);
  });
  json.Member("held", sweep->held);
  Box(json, sweep->aabb);
  json.EndObject();
}

}  // namespace

std::string InspectJson(const forge::Recipe& recipe, const forge::Variant& variant,
                        const std::optional<validate::Sweep>& sweep) {
  const model::Object& object = *variant.object;
  const manifest::Record& record = variant.record;
  Json json;
  json.StartObject();
  json.Member("name", recipe.spec->name);
  json.Member("description", recipe.spec->description);
  json.Member("spec", recipe.reference);
  json.Member("spec_sha256", recipe.spec->sha256);
  Parameters(json, recipe, variant);
  json.Member("seed", record.seed);
  json.Member("index", record.index);
  json.Member("attempt", record.attempt);
  json.Each("bodies", object.bodies, [&](const model::Body& body) {
    BodyHead(json, object, body);
    Parts(json, body);
    Joints(json, body);
    Sites(json, body);
    Elements(json, "elements", body.elements);
  });
  Sections(json, object);
  Box(json, object.bounds.aabb);
  Mass(json, object.mass_properties);
  json.Member("top_offset", object.bounds.top_offset);
  json.Member("bottom_offset", object.bounds.bottom_offset);
  json.Member("horizontal_radius", object.bounds.horizontal_radius);
  json.Member("text_bytes", variant.document.text.size());
  json.Member("mesh_bytes", mjcf::MeshBytes(variant.document.text));
  Sweep(json, sweep);
  json.EndObject();
  return json.Line();
}

std::string InspectJson(const validate::CompiledModel& model,
                        const std::optional<validate::Sweep>& sweep) {
  Json json;
  json.StartObject();
  const model::Object& object = model.object;
  json.Member("name", object.name);
  auto geoms = model.body_geoms.begin();
  json.Each("bodies", object.bodies, [&](const model::Body& body) {
    BodyHead(json, object, body);
    json.Member("geoms", *geoms++);
  });
  json.Key("joints");
  json.StartArray();
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      json.StartObject();
      json.Member("name", joint.name);
      json.Member("body", body.name);
      json.Member("type", joint.type);
      json.Member("axis", joint.axis);
      if (joint.range) json.Member("range", *joint.range);
      json.EndObject();
    }
  }
  json.EndArray();
  json.Each("elements", model.elements, [&](const validate::CompiledModel::Element& element) {
    json.Member("kind", element.kind);
    json.Member("name", element.name);
  });
  json.Member("ngeom", model.geoms);
  json.Member("nsite", model.sites);
  Box(json, object.bounds.aabb);
  Mass(json, object.mass_properties);
  Sweep(json, sweep);
  json.EndObject();
  return json.Line();
}

}  // namespace mjforge::app
