// Reader of shapes of parts: type, size, pose or `fromto`; reports keys that do not belong to the
// type.

#include "mjforge/assemble/shape_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/pose_reader.h"
#include "mjforge/assemble/solid_reader.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

bool HasEnds(std::string_view type) { return spec::FindShape(type)->Takes(Key::kFromTo); }

// Reports keys that only other types of shapes have. If the type is drawn, they cannot be reported
// when the spec is loaded.
bool HasStrayKeys(FieldReader& reader, const spec::Entry& entry, std::string_view type) {
  const spec::ShapeInfo* shape = spec::FindShape(type);
  bool stray = false;
  for (const spec::Field& field : entry.fields) {
    if (field.is_default || !spec::AnyShapeTakes(field.info->id) || shape->Takes(field.info->id))
      continue;
    reader.Report(Code::kModelBadValue, field, fmt::format("has no meaning for a {}", type));
    stray = true;
  }
  return stray;
}

bool ReadSize(FieldReader& reader, const spec::Entry& entry, std::string_view type,
              const std::optional<double>& half_length, model::Part& part) {
  const spec::Field* field = entry.Find(Key::kSize);
  if (field == nullptr)
    return reader.ReportElement(Code::kSpecMissingKey, part.mark, "has no 'size'");
  sample::Numbers numbers;
  if (!reader.Numbers(*field, numbers)) return false;
  const int all = model::SizeCount(part.shape.type);
  const int wanted = half_length ? all - 1 : all;
  if (static_cast<int>(numbers.size()) != wanted)
    return reader.Report(
        Code::kModelBadValue, *field,
        fmt::format("has {}; a {}{} takes {}", diag::Counted(numbers.size(), "number"), type,
                    half_length ? " with 'fromto'" : "", wanted));
  if (half_length) numbers.push_back(*half_length);
  numbers.resize(3);
  part.shape.size = Eigen::Vector3d(numbers.data());
  return true;
}

}  // namespace

model::GeomType TypeOf(std::string_view word) {
  const auto* name = std::ranges::find(model::kGeomTypeNames, word);
  return name == model::kGeomTypeNames.end()
             ? model::GeomType::kMesh
             : static_cast<model::GeomType>(name - model::kGeomTypeNames.begin());
}

std::optional<ShapePlacement> ReadShape(FieldReader& reader, const spec::Entry& entry,
                                        const std::filesystem::path& folder, PartTexture texture,
                                        Assets& assets, model::Part& part) {
  const spec::Field* type = Required(reader, entry, Key::kType, "type", part.mark);
  if (type == nullptr) return std::nullopt;
  const std::optional<std::string> word = reader.Word(*type);
  if (!word || HasStrayKeys(reader, entry, *word) || !ReadGrain(reader, entry, *word, texture))
    return std::nullopt;
  part.shape.type = TypeOf(*word);
  ShapePlacement placed;
  std::optional<double> half_length;
  if (const spec::Field* fromto = entry.Find(Key::kFromTo); fromto && HasEnds(*word)) {
    const std::optional<Segment> segment = ReadFromTo(reader, *fromto, entry.Find(Key::kUp));
    if (!segment) return std::nullopt;
    placed.X_FG = segment->pose;
    half_length = segment->half_length;
  } else {
    const std::optional<model::Pose> pose = ReadPose(reader, entry);
    if (!pose) return std::nullopt;
    placed.X_FG = *pose;
  }
  bool good = true;
  if (IsSolid(*word, entry)) {
    good = ReadSolid(reader, entry, *word, half_length, texture, assets, part, placed);
  } else if (*word == "mesh") {
    good = assets.ReadMesh(reader, entry, folder, part);
  } else {
    good = ReadSize(reader, entry, *word, half_length, part);
    if (good && part.shape.type == model::GeomType::kBox)
      placed.X_FG.q = placed.X_FG.q * TurnToGrain(texture, part.shape.size);
  }
  return good ? std::optional(std::move(placed)) : std::nullopt;
}

}  // namespace mjforge::assemble
