// `mjforge inspect --json`: one JSON object about a variant or an MJCF file.
#include <cmath>
#include <vector>

#include "inspect.h"
#include "json_output.h"

namespace mjforge::app {
namespace {

void WriteParameters(diag::Json& json, const forge::Recipe& recipe, const forge::Variant& variant) {
  auto drawn = variant.record.params.begin();
  json.Each("parameters", recipe.spec->parameters, [&](const spec::Parameter& parameter) {
    json.Member("name", parameter.name);
    json.Member("spec", parameter.source);
    json.Member("value", (drawn++)->second);
    json.Member("unit", parameter.unit);
    json.Member("section", parameter.section);
    json.Member("doc", parameter.doc);
  });
}

void WritePose(diag::Json& json, const model::Pose& pose) {
  json.Member("pos", pose.p);
  json.Member("quat", model::Wxyz(pose.q));
}

void WriteParts(diag::Json& json, const model::Body& body) {
  json.Each("parts", body.parts, [&](const model::Part& part) {
    json.Member("name", part.name);
    json.Member("type", model::GeomTypeName(part.shape.type));
    json.Member("collides", part.role != model::Role::kVisual);
    json.Member("visible", part.role != model::Role::kCollision);
    json.Member("size", part.shape.size.head(model::SizeCount(part.shape.type)));
    WritePose(json, part.X_BG);
    json.Member("mass", part.mass);
  });
}

void WriteJoints(diag::Json& json, const model::Body& body) {
  json.Each("joints", body.joints, [&](const model::Joint& joint) {
    json.Member("name", joint.name);
    json.Member("type", joint.type);
    if (joint.type == "hinge" || joint.type == "slide") json.Member("axis", joint.axis);
    if (joint.range) json.Member("range", *joint.range);
    if (!joint.start.empty()) json.Member("start", joint.start);
  });
}

void WriteSites(diag::Json& json, const model::Body& body) {
  json.Each("sites", body.sites, [&](const model::Site& site) {
    json.Member("name", site.name);
    WritePose(json, site.X_BS);
  });
}

void WriteRegions(diag::Json& json, const model::Body& body) {
  json.Each("regions", body.regions, [&](const model::Region& region) {
    json.Member("name", region.name);
    json.Member("site", region.site);
    json.Member("type", model::RegionTypeName(region.type));
    json.Member("half_size", region.half_size);
    if (!region.corners.empty()) {
      std::vector<double> corners;
      for (const Eigen::Vector2d& corner : region.corners)
        corners.insert(corners.end(), {corner.x(), corner.y()});
      json.Member("corners", corners);
    }
    WritePose(json, region.X_BR);
    json.Member("height", region.height);  // null if it is not limited
    json.Member("margin", region.margin);
    json.Member("clear", region.clear);
    json.Member("walls", region.has_walls);
  });
}

void WriteBox(diag::Json& json, const model::Box3& aabb, std::string_view key = "aabb") {
  json.Object(key, [&] {
    json.Member("min", aabb.min);
    json.Member("max", aabb.max);
  });
}

// Writes mass, centre of mass and inertia. Order of the inertia, as in records: xx yy zz xy xz yz.
void WriteMass(diag::Json& json, const model::MassProperties& properties) {
  const Eigen::Matrix3d& I = properties.I_Cm_F;
  json.Member("mass", properties.mass);
  json.Member("com", properties.p_FCm);
  json.Member("inertia",
              Eigen::Vector<double, 6>(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
}

void WriteElements(diag::Json& json, std::string_view key,
                   const std::vector<model::Element>& elements) {
  json.Each(key, elements, [&](const model::Element& element) {
    json.Member("kind", element.tag);
    json.Member("name", element.name);
  });
}

void WriteSections(diag::Json& json, const model::Object& object) {
  json.Object("sections", [&] {
    for (const model::Section& section : object.sections)
      WriteElements(json, section.info->name, section.elements);
  });
}

void WriteBodyHead(diag::Json& json, const model::Object& object, const model::Body& body) {
  json.Member("name", body.name);
  json.Member("parent", body.parent < 0
                            ? std::string_view("world")
                            : object.bodies[static_cast<std::size_t>(body.parent)].name);
  if (!body.place_name.empty()) json.Member("stands_at", body.place_name);
  WritePose(json, body.X_PB);
  WriteMass(json, body.mass_properties);
}

// Writes the sweep of the joints. Contacts that several joints cause together have null for `joint`
// and `value`.
void WriteSweep(diag::Json& json, const std::optional<validate::Sweep>& sweep) {
  if (!sweep) return;
  json.Object("sweep", [&] {
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
    json.Member("held", sweep->unlimited_slides);
    WriteBox(json, sweep->aabb);
  });
}

}  // namespace

std::string InspectJson(const forge::Recipe& recipe, const forge::Variant& variant,
                        const std::optional<validate::Sweep>& sweep) {
  const model::Object& object = *variant.object;
  const manifest::Record& record = variant.record;
  return JsonLine([&](diag::Json& json) {
    json.Member("name", recipe.spec->name);
    json.Member("description", recipe.spec->description);
    json.Member("spec", recipe.reference);
    json.Member("spec_sha256", recipe.spec->sha256);
    WriteParameters(json, recipe, variant);
    json.Member("seed", record.seed);
    json.Member("index", record.index);
    if (record.place_seed) json.Member("place_seed", *record.place_seed);
    json.Member("attempt", record.attempt);
    json.Each("bodies", object.bodies, [&](const model::Body& body) {
      WriteBodyHead(json, object, body);
      WriteParts(json, body);
      WriteJoints(json, body);
      WriteRegions(json, body);
      WriteSites(json, body);
      WriteElements(json, "elements", body.elements);
    });
    WriteSections(json, object);
    WriteBox(json, object.bounds.aabb);
    WriteBox(json, object.bounds.swept, "swept_aabb");
    WriteMass(json, object.mass_properties);
    json.Member("top_offset", object.bounds.top_offset);
    json.Member("bottom_offset", object.bounds.bottom_offset);
    json.Member("horizontal_radius", object.bounds.horizontal_radius);
    json.Member("text_bytes", variant.document.text.size());
    json.Member("mesh_bytes", mjcf::MeshBytes(variant.document.text));
    WriteSweep(json, sweep);
  });
}

std::string InspectJson(const validate::CompiledModel& model,
                        const std::optional<validate::Sweep>& sweep) {
  return JsonLine([&](diag::Json& json) {
    const model::Object& object = model.object;
    json.Member("name", object.name);
    auto geoms = model.body_geoms.begin();
    json.Each("bodies", object.bodies, [&](const model::Body& body) {
      WriteBodyHead(json, object, body);
      json.Member("geoms", *geoms++);
    });
    json.List("joints", object.bodies, [&](const model::Body& body) {
      for (const model::Joint& joint : body.joints) {
        json.Object([&] {
          json.Member("name", joint.name);
          json.Member("body", body.name);
          json.Member("type", joint.type);
          json.Member("axis", joint.axis);
          if (joint.range) json.Member("range", *joint.range);
        });
      }
    });
    json.Each("elements", model.elements, [&](const validate::CompiledModel::Element& element) {
      json.Member("kind", element.kind);
      json.Member("name", element.name);
    });
    json.Member("ngeom", model.geoms);
    json.Member("nsite", model.sites);
    WriteBox(json, object.bounds.aabb);
    WriteMass(json, object.mass_properties);
    WriteSweep(json, sweep);
  });
}

}  // namespace mjforge::app
