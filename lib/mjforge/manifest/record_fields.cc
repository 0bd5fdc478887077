// The table of the fields of a record: key, schema, meaning, writing and reading of each.

#include "mjforge/manifest/record_fields.h"

#include <fmt/format.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>

#include "mjforge/expr/expr.h"
#include "mjforge/manifest/record_values.h"
#include "mjforge/manifest/result_fields.h"

namespace mjforge::manifest {
namespace {

using model::Bounds;
using model::MassProperties;
using Value = rapidjson::Value;

constexpr JsonMember<Record::PlacedBody> kPlace[] = {{"body", &Record::PlacedBody::body},
                                                     {"at", &Record::PlacedBody::at},
                                                     {"pos", &Record::PlacedBody::pos},
                                                     {"quat", &Record::PlacedBody::quat}};

// A field of scope kBatch has the same value in all records of a batch.
enum class FieldScope { kVariant, kBatch };

template <auto member, FieldScope scope = FieldScope::kVariant>
RecordField Field(const char* key, std::string schema, std::string_view doc) {
  RecordField field{key, std::move(schema), doc,
                    [](Json& json, const Record& record) { Put(json, record.*member); },
                    [](const Value& value, Record& record) { return Get(value, record.*member); }};
  if constexpr (scope == FieldScope::kBatch)
    field.same = [](const Record& a, const Record& b) { return a.*member == b.*member; };
  return field;
}

// Makes a field that a record's JSON does not contain if `member` has its default value.
template <auto member, FieldScope scope = FieldScope::kVariant>
RecordField OptionalField(const char* key, std::string schema, std::string_view doc) {
  RecordField field = Field<member, scope>(key, std::move(schema), doc);
  field.is_absent = [](const Record& record) {
    return record.*member == std::remove_cvref_t<decltype(record.*member)>();
  };
  return field;
}

// Makes a field for a property of the object. The value is null in JSON if no object was made.
template <auto... way>
RecordField ObjectField(const char* key, std::string schema, std::string_view doc) {
  return {key, std::move(schema), doc,
          [](Json& json, const Record& record) {
            record.nbody > 0 ? Put(json, (record.*....*way)) : json.Value(nullptr);
          },
          [](const Value& value, Record& record) {
            return value.IsNull() ? ExpectedKind() : Get(value, (record.*....*way));
          }};
}

// Makes a field for a text. The value is null in JSON if the text is empty.
template <std::string Record::*member>
RecordField NullableField(const char* key, std::string schema, std::string_view doc) {
  return {key, std::move(schema), doc,
          [](Json& json, const Record& record) {
            (record.*member).empty() ? json.Value(nullptr) : json.Value(record.*member);
          },
          [](const Value& value, Record& record) {
            return value.IsNull() ? ExpectedKind() : Get(value, record.*member);
          }};
}

RecordField DeclaredBoundsField() {
  return {"declared_bounds",
          R"("enum": [true])",
          "Present if the bounds are those of the spec's total_size, not of the collision parts.",
          [](Json& json, const Record& record) { Put(json, record.bounds.declared); },
          [](const Value& value, Record& record) { return Get(value, record.bounds.declared); },
          [](const Record& record) { return !record.bounds.declared; }};
}

constexpr const char* kBox =
    R"("type": ["object", "null"], "required": ["min", "max"], "properties": )"
    R"({"min": {"type": "array", "items": {"type": "number"}}, )"
    R"("max": {"type": "array", "items": {"type": "number"}}})";

RecordField SweptBoundsField() {
  return {
      "swept_aabb",
      kBox,
      "Box around the collision parts at all positions of the joints; left out if no object was "
      "made.",
      [](Json& json, const Record& record) { Put(json, record.bounds.swept); },
      [](const Value& value, Record& record) { return Get(value, record.bounds.swept); },
      [](const Record& record) { return record.bounds.swept.empty(); }};
}

RecordField PhysicsField() {
  return {
      "physics",
      fmt::format(R"("type": "object", "properties": {{{}}})", ResultSchema()),
      "Measurements of its behaviour, in SI units; left out if none were made.",
      [](Json& json, const Record& record) { PutResult(json, *record.physics); },
      [](const Value& value, Record& record) { return GetResult(value, record.physics.emplace()); },
      [](const Record& record) { return !record.physics; }};
}

RecordField PlacesField() {
  return {
      "places",
      fmt::format(R"("type": "array", "items": {{"type": "object", "properties": {{{}}}}})",
                  SchemaOf(kPlace)),
      "The bodies that were placed, in the order of the file: name, region or site, and pose in "
      "the world at the start; left out if there are none.",
      [](Json& json, const Record& record) {
        Json places(AppendFileNumber);
        places.Each(record.places,
                    [&](const Record::PlacedBody& place) { PutAll(places, place, kPlace); });
        json.Raw(places.Take());
      },
      [](const Value& value, Record& record) {
        const bool is_good =
            value.IsArray() && std::ranges::all_of(value.GetArray(), [&](const Value& item) {
              return GetAll(item, record.places.emplace_back(), kPlace);
            });
        return is_good ? ExpectedKind() : "a list of places";
      },
      [](const Record& record) { return record.places.empty(); }};
}

void PutFindings(Json& json, const Record& record) {
  json.List(record.findings, [&](const std::string& finding) { json.Raw(finding); });
}

ExpectedKind GetFindings(const Value& value, Record& record) {
  if (!value.IsArray()) return "a list";
  for (const Value& finding : value.GetArray()) {
    rapidjson::StringBuffer buffer;
    rapidjson::Writer<rapidjson::StringBuffer> json(buffer);
    finding.Accept(json);
    record.findings.emplace_back(buffer.GetString(), buffer.GetSize());
  }
  return {};
}

constexpr const char* kWhole = R"("type": "integer", "minimum": 0)";
constexpr const char* kCount = R"("type": ["integer", "null"], "minimum": 0)";
constexpr const char* kNumber = R"("type": ["number", "null"])";
constexpr const char* kText = R"("type": "string")";
constexpr const char* kHash = R"("type": "string", "pattern": "^[0-9a-f]{64}$")";

const std::array kFields = {
    NullableField<&Record::file>(
        "file", R"("type": ["string", "null"])",
        "The object's file, relative to the manifest or in the archive; null if none was "
        "written."),
    OptionalField<&Record::archive>("archive", kText,
                                    "The archive that holds the file, relative to the manifest."),
    Field<&Record::name>("name", kText, "The object's name and the prefix of all names in it."),
    Field<&Record::index>("index", kWhole, "The variant's number in the family."),
    Field<&Record::seed, FieldScope::kBatch>("seed", kWhole, "The seed of all draws."),
    OptionalField<&Record::place_seed, FieldScope::kBatch>(
        "place_seed", kWhole, "The seed of the places alone; left out if they follow from `seed`."),
    Field<&Record::attempt>("attempt", kWhole, "How many draws were rejected before this one."),
    Field<&Record::spec, FieldScope::kBatch>(
        "spec", kText, "The spec: its name in the catalogue, or its file's name."),
    OptionalField<&Record::spec_file>(
        "spec_file", kText,
        "The spec's file, relative to the manifest; left out if it is found by its name, or "
        "has only the root folder in common with the manifest."),
    Field<&Record::spec_sha256, FieldScope::kBatch>(
        "spec_sha256", kHash, "SHA-256 of the text of all files that the spec was read from."),
    OptionalField<&Record::settings, FieldScope::kBatch>(
        "set", R"("type": "object", "additionalProperties": {"type": "string"})",
        "Parameters that were set in place of the spec's own values, as YAML."),
    OptionalField<&Record::assets_as, FieldScope::kBatch>(
        "assets_as", R"("enum": ["files"])",
        "How meshes and textures that no file has are written: as files beside the object; left "
        "out if they are in its file."),
    OptionalField<&Record::sampler, FieldScope::kBatch>(
        "sampler", R"("enum": ["sobol", "latin", "grid"])",
        "How the draws are spread over the batch; left out if they are random."),
    OptionalField<&Record::batch, FieldScope::kBatch>(
        "batch", R"("type": "integer", "minimum": 1)",
        "The number of variants that the draws are spread over; left out if none are."),
    Field<&Record::params>(
        "params",
        R"("type": "object", "additionalProperties": {"type": ["number", "boolean", )"
        R"("string", "array"], "items": {"type": ["number", "boolean", "string"]}})",
        "The value of each parameter."),
    ObjectField<&Record::mass_properties, &MassProperties::mass>(
        "mass", kNumber, "Mass, kg; null, here and below, if no object was made."),
    ObjectField<&Record::mass_properties, &MassProperties::p_FCm>(
        "com",
        R"("type": ["array", "null"], "items": {"type": "number"}, "minItems": 3, )"
        R"("maxItems": 3)",
        "Centre of mass at the start state in the object's frame, m."),
    ObjectField<&Record::mass_properties, &MassProperties::I_Cm_F>(
        "inertia",
        R"("type": ["array", "null"], "items": {"type": "number"}, "minItems": 6, )"
        R"("maxItems": 6)",
        "Inertia about the centre of mass at the start state, along the axes of the object's "
        "frame, kg m^2: xx yy zz xy xz yz."),
    ObjectField<&Record::bounds, &Bounds::aabb>(
        "aabb", kBox, "Bounds of the collision parts at the start state in the object's frame, m."),
    SweptBoundsField(),
    ObjectField<&Record::bounds, &Bounds::top_offset>(
        "top_offset", kNumber, "z of the highest point of a collision part, m."),
    ObjectField<&Record::bounds, &Bounds::bottom_offset>(
        "bottom_offset", kNumber, "z of the lowest point of a collision part, m."),
    ObjectField<&Record::bounds, &Bounds::horizontal_radius>(
        "horizontal_radius", kNumber, "Largest distance of a collision part from the z axis, m."),
    DeclaredBoundsField(),
    ObjectField<&Record::nbody>("nbody", kCount,
                                "Bodies in the file as MuJoCo counts them, the world included."),
    ObjectField<&Record::njnt>("njnt", kCount, "Joints in the file, free ones included."),
    ObjectField<&Record::ngeom>("ngeom", kCount, "Geoms in the file."),
    PlacesField(),
    OptionalField<&Record::pile_mujoco>("pile_mujoco", kText,
                                        "The release of MuJoCo that settled the piles."),
    OptionalField<&Record::left_out>(
        "left_out", R"("type": "array", "items": {"type": "string"})",
        "The bodies that found no room and that the spec allows to leave out (`fewer: true`)."),
    Field<&Record::target, FieldScope::kBatch>("target", kText,
                                               "The host that the file is written for."),
    OptionalField<&Record::each, FieldScope::kBatch>(
        "each", R"("enum": [true])",
        "Present if each object of the scene has a file of its own: `file` is the placement, the "
        "objects are among the `assets`, and masses, bounds and counts are those of the scene."),
    Field<&Record::validate, FieldScope::kBatch>(
        "validate", R"("enum": ["load", "none", "physics"])",
        "How the variant was checked: load, whether MuJoCo loads the file as intended; physics, "
        "whether the object also behaves."),
    OptionalField<&Record::mujoco, FieldScope::kBatch>(
        "mujoco", kText,
        "The release of MuJoCo in which the variant was checked; left out if it was not."),
    OptionalField<&Record::structure>(
        "structure", R"("type": "string", "pattern": "^[0-9a-f]{12}$")",
        "Hash of the structure: the counts, types, references, names and flags of the compiled "
        "model, which parallel worlds of one model share; left out if MuJoCo did not load the "
        "file."),
    OptionalField<&Record::layout, FieldScope::kBatch>(
        "layout", R"("enum": ["one", "split"])",
        "The structures of the batch: `one`, a variant with another structure than the first one "
        "is invalid; `split`, a folder per structure; left out if variants may have any."),
    OptionalField<&Record::layout_first, FieldScope::kBatch>(
        "layout_first", kWhole,
        "With the layout `one`: the index of the first variant of the batch, which determines the "
        "structure."),
    OptionalField<&Record::pad, FieldScope::kBatch>(
        "pad", R"("type": "integer", "minimum": 1)",
        "Present if each variant of the family has the geoms and sites of this many variants from "
        "`layout_first` on; those that it lacks are null."),
    OptionalField<&Record::mocap, FieldScope::kBatch>(
        "mocap", R"("enum": [true])",
        "Present if bodies that are fixed to the world are mocap bodies in the base of the "
        "family."),
    PhysicsField(),
    OptionalField<&Record::on_invalid, FieldScope::kBatch>(
        "on_invalid", R"("enum": ["skip", "resample"])",
        "What happens to an invalid variant; left out if it fails."),
    Field<&Record::status>(
        "status", R"("enum": ["ok", "failed", "skipped"])",
        "Failed and skipped variants have errors among their findings and no file."),
    RecordField{"findings",
                R"("type": "array", "items": {"type": "object", "required": ["severity", )"
                R"("code", "message"]})",
                "Errors and warnings about this variant.", PutFindings, GetFindings},
    NullableField<&Record::sha256>("sha256",
                                   R"("type": ["string", "null"], "pattern": "^[0-9a-f]{64}$")",
                                   "SHA-256 of the file's bytes."),
    OptionalField<&Record::assets>(
        "assets", fmt::format(R"("type": "object", "additionalProperties": {{{}}})", kHash),
        "The files that the file refers to (meshes, pictures, objects), by their names in it, with "
        "the SHA-256 of their bytes; left out if there are none."),
};

}  // namespace

std::span<const RecordField> RecordFields() { return kFields; }

std::string PhysicsJson(const physics::Result& result) {
  Json json(expr::AppendExactNumber);
  PutResult(json, result);
  return json.Take();
}

}  // namespace mjforge::manifest
