#include "mjforge/manifest/record_fields.h"

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <variant>

#include "mjforge/expr/expr.h"
#include "mjforge/manifest/physics_json.h"

namespace mjforge::manifest {
namespace {

void TextOrNull(JsonText& json, std::string_view text) {
  if (text.empty()) {
    json.Null();
  } else {
    json.String(text);
  }
}

void Numbers(JsonText& json, std::span<const double> values) {
  json.StartArray();
  for (const double value : values) json.Number(value);
  json.EndArray();
}

void Vector(JsonText& json, const Eigen::Vector3d& vector) {
  Numbers(json, std::span(vector.data(), 3));
}

bool HasObject(const Record& record) { return record.nbody > 0; }

// A number that only exists where an object was made.
template <typename Value>
void OfObject(JsonText& json, const Record& record, Value value) {
  if (!HasObject(record)) {
    json.Null();
  } else if constexpr (std::is_same_v<Value, int>) {
    json.Whole(static_cast<std::uint64_t>(value));
  } else {
    json.Number(value);
  }
}

void Parameter(JsonText& json, const sample::ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    json.Number(*number);
  } else if (const auto* flag = std::get_if<bool>(&value)) {
    json.Bool(*flag);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    json.String(*text);
  } else {
    Numbers(json, std::get<std::vector<double>>(value));
  }
}

void Settings(JsonText& json, const Record& record) {
  json.StartObject();
  for (const auto& [name, text] : record.settings) {
    json.Key(name);
    json.String(text);
  }
  json.EndObject();
}

void Parameters(JsonText& json, const Record& record) {
  json.StartObject();
  for (const auto& [name, value] : record.params) {
    json.Key(name);
    Parameter(json, value);
  }
  json.EndObject();
}

void CentreOfMass(JsonText& json, const Record& record) {
  if (!HasObject(record)) {
    json.Null();
  } else {
    Vector(json, record.mass_properties.p_FCm);
  }
}

// In the order of MJCF's fullinertia.
void Inertia(JsonText& json, const Record& record) {
  if (!HasObject(record)) {
    json.Null();
    return;
  }
  const Eigen::Matrix3d& I = record.mass_properties.I_Cm_F;
  Numbers(json, std::array{I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)});
}

void Box(JsonText& json, const Record& record) {
  if (!HasObject(record)) {
    json.Null();
    return;
  }
  json.StartObject();
  json.Key("min");
  Vector(json, record.bounds.aabb.min);
  json.Key("max");
  Vector(json, record.bounds.aabb.max);
  json.EndObject();
}

void FindingList(JsonText& json, const Record& record) {
  json.StartArray();
  for (const std::string& finding : record.findings) {
    json.Raw(finding);
  }
  json.EndArray();
}

using J = JsonText;
using R = Record;

constexpr std::string_view kWhole = R"("type": "integer", "minimum": 0)";
constexpr std::string_view kCount = R"("type": ["integer", "null"], "minimum": 0)";
constexpr std::string_view kNumber = R"("type": ["number", "null"])";
constexpr std::string_view kText = R"("type": "string")";
constexpr std::string_view kHash = R"("type": "string", "pattern": "^[0-9a-f]{64}$")";

constexpr std::string_view kPhysicsSchema =
    R"("type": "object", "properties": {"dropped": {"type": "boolean"}, )"
    R"("at_rest": {"type": "boolean"}, "time": {"type": ["number", )"
    R"("null"]}, "drift": {"type": ["number", "null"]}, "tilt": {"type": )"
    R"(["number", "null"]}, "speed": {"type": ["number", "null"]}, )"
    R"("penetration": {"type": ["number", "null"]}, "sink": {"type": ["number", "null"]}, )"
    R"("energy_gain": {"type": )"
    R"(["number", "null"]}, "ncon": {"type": "integer"}, "nefc": {"type": )"
    R"("integer"}, "overlap": {"type": ["number", "null"]}, "joints": )"
    R"({"type": "array", "items": {"type": "object", "properties": {"name": )"
    R"({"type": "string"}, "overshoot": {"type": ["number", "null"]}, )"
    R"("reach": {"type": ["number", "null"]}, "penetration": {"type": )"
    R"(["number", "null"]}, "return_error": {"type": ["number", )"
    R"("null"]}}}}})";

const std::array kFields = {
    RecordField{"file", R"("type": ["string", "null"])",
                "The object's file, relative to the manifest or in the archive; null if none was "
                "written.",
                [](J& j, const R& r) { TextOrNull(j, r.file); }},
    RecordField{"archive", kText, "The archive that holds the file, relative to the manifest.",
                [](J& j, const R& r) { j.String(r.archive); },
                [](const R& r) { return r.archive.empty(); }},
    RecordField{"name", kText, "The object's name and the prefix of all names in it.",
                [](J& j, const R& r) { j.String(r.name); }},
    RecordField{"index", kWhole, "The variant's number in the family.",
                [](J& j, const R& r) { j.Whole(r.index); }},
    RecordField{"seed", kWhole, "The seed of all draws.",
                [](J& j, const R& r) { j.Whole(r.seed); }},
    RecordField{"attempt", kWhole, "How many draws were rejected before this one.",
                [](J& j, const R& r) { j.Whole(r.attempt); }},
    RecordField{"spec", kText, "The spec: its name in the catalogue, or its file's name.",
                [](J& j, const R& r) { j.String(r.spec); }},
    RecordField{
        "spec_file", kText,
        "The spec's file, relative to the manifest; left out if it is found by its name, or "
        "has only the root folder in common with the manifest.",
        [](J& j, const R& r) { j.String(r.spec_file); },
        [](const R& r) { return r.spec_file.empty(); }},
    RecordField{"spec_sha256", kHash, "SHA-256 of the texts of all files the spec was read from.",
                [](J& j, const R& r) { j.String(r.spec_sha256); }},
    RecordField{"set", R"("type": "object", "additionalProperties": {"type": "string"})",
                "Parameters that were set in place of the spec's own values, as YAML.", Settings,
                [](const R& r) { return r.settings.empty(); }},
    RecordField{"sampler", R"("enum": ["sobol", "latin", "grid"])",
                "How the draws are spread over the batch; left out if they are random.",
                [](J& j, const R& r) { j.String(r.sampler); },
                [](const R& r) { return r.sampler.empty(); }},
    RecordField{"batch", R"("type": "integer", "minimum": 1)",
                "The number of variants that the draws are spread over; left out if none are.",
                [](J& j, const R& r) { j.Whole(r.batch); },
                [](const R& r) { return r.batch == 0; }},
    RecordField{"params",
                R"("type": "object", "additionalProperties": {"type": ["number", "boolean", )"
                R"("string", "array"], "items": {"type": "number"}})",
                "The value of each parameter.", Parameters},
    RecordField{"mass", kNumber, "kg; null, here and below, if no object was made.",
                [](J& j, const R& r) { OfObject(j, r, r.mass_properties.mass); }},
    RecordField{"com",
                R"("type": ["array", "null"], "items": {"type": "number"}, "minItems": 3, )"
                R"("maxItems": 3)",
                "Centre of mass in the root body's frame, m.", CentreOfMass},
    RecordField{"inertia",
                R"("type": ["array", "null"], "items": {"type": "number"}, "minItems": 6, )"
                R"("maxItems": 6)",
                "Inertia about the centre of mass, along the root body's axes, kg m^2: "
                "xx yy zz xy xz yz.",
                Inertia},
    RecordField{"aabb",
                R"("type": ["object", "null"], "required": ["min", "max"], "properties": )"
                R"({"min": {"type": "array", "items": {"type": "number"}}, )"
                R"("max": {"type": "array", "items": {"type": "number"}}})",
                "Bounds of the collision parts in the root body's frame, m.", Box},
    RecordField{"top_offset", kNumber, "z of the highest point of a collision part, m.",
                [](J& j, const R& r) { OfObject(j, r, r.bounds.top_offset); }},
    RecordField{"bottom_offset", kNumber, "z of the lowest point of a collision part, m.",
                [](J& j, const R& r) { OfObject(j, r, r.bounds.bottom_offset); }},
    RecordField{"horizontal_radius", kNumber,
                "Largest distance of a collision part from the z axis, m.",
                [](J& j, const R& r) { OfObject(j, r, r.bounds.horizontal_radius); }},
    RecordField{"nbody", kCount, "Bodies in the file as MuJoCo counts them, the world included.",
                [](J& j, const R& r) { OfObject(j, r, r.nbody); }},
    RecordField{"njnt", kCount, "Joints in the file, free ones included.",
                [](J& j, const R& r) { OfObject(j, r, r.njnt); }},
    RecordField{"ngeom", kCount, "Geoms in the file.",
                [](J& j, const R& r) { OfObject(j, r, r.ngeom); }},
    RecordField{"target", kText, "Who the file is written for.",
                [](J& j, const R& r) { j.String(r.target); }},
    RecordField{"validate", R"("enum": ["load", "none", "physics"])",
                "What was asked about it: load, whether MuJoCo loads the file as it is meant; "
                "physics, whether it also behaves.",
                [](J& j, const R& r) { j.String(r.validate); }},
    RecordField{"physics", kPhysicsSchema,
                "What was measured of it, in SI units; left out where that was not asked for.",
                [](J& j, const R& r) { WritePhysics(j, *r.physics); },
                [](const R& r) { return !r.physics; }},
    RecordField{"on_invalid", R"("enum": ["skip", "resample"])",
                "What was to be done if it is invalid; left out where it fails.",
                [](J& j, const R& r) { j.String(r.on_invalid); },
                [](const R& r) { return r.on_invalid.empty(); }},
    RecordField{"status", R"("enum": ["ok", "failed", "skipped"])",
                "Failed and skipped variants have errors among their findings and no file.",
                [](J& j, const R& r) { j.String(r.status); }},
    RecordField{"findings",
                R"("type": "array", "items": {"type": "object", "required": ["severity", )"
                R"("code", "message"]})",
                "Errors and warnings about this variant.", FindingList},
    RecordField{"sha256", R"("type": ["string", "null"], "pattern": "^[0-9a-f]{64}$")",
                "SHA-256 of the file's bytes.", [](J& j, const R& r) { TextOrNull(j, r.sha256); }},
};

}  // namespace

void JsonText::String(std::string_view text) {
  Separate();
  const auto is_plain = [](char c) {
    return static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\';
  };
  if (std::all_of(text.begin(), text.end(), is_plain)) {
    out_ += '"';
    out_ += text;
    out_ += '"';
    return;
  }
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
  out_.append(buffer.GetString(), buffer.GetSize());
}

void JsonText::Whole(std::uint64_t number) {
  Separate();
  std::array<char, 20> digits;  // enough for 2^64 - 1
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  out_.append(digits.data(), end);
}

void JsonText::Number(double number) {
  if (!std::isfinite(number)) {
    Null();
    return;
  }
  Separate();
  expr::AppendExactNumber(out_, number);
}

std::span<const RecordField> RecordFields() { return kFields; }

}  // namespace mjforge::manifest
