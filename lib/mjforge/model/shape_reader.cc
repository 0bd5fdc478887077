#include "mjforge/model/shape_reader.h"

#include <fmt/format.h>

#include "mjforge/model/names.h"
#include "mjforge/model/pose_reader.h"

namespace mjforge::model {
namespace {

using diag::Code;
using spec::Key;

bool HasEnds(std::string_view type) {
  return type == "box" || type == "cylinder" || type == "capsule" || type == "ellipsoid";
}

// Keys of other shapes, for types that are known only now.
bool HasStrayKeys(FieldReader& reader, const spec::Entry& entry, std::string_view type) {
  const bool is_prism = type == "prism";
  const bool is_mesh = type == "mesh";
  const std::pair<Key, bool> kKnown[] = {
      {Key::kSize, !is_prism && !is_mesh}, {Key::kFromTo, HasEnds(type)}, {Key::kUp, HasEnds(type)},
      {Key::kPolygon, is_prism},           {Key::kHeight, is_prism},      {Key::kFile, is_mesh},
      {Key::kScale, is_prism || is_mesh},
  };
  bool stray = false;
  for (const auto& [key, is_known] : kKnown) {
    const spec::Field* field = entry.Find(key);
    if (field == nullptr || field->is_default || is_known) continue;
    reader.Report(Code::kModelBadValue, *field, fmt::format("has no meaning for a {}", type));
    stray = true;
  }
  return stray;
}

bool ReadSize(FieldReader& reader, const spec::Entry& entry, std::string_view type,
              const std::optional<Traced<double>>& half_length, Part& part) {
  const spec::Field* field = entry.Find(Key::kSize);
  if (field == nullptr) {
    reader.ReportElement(Code::kSpecMissingKey, part.mark, "has no 'size'");
    return false;
  }
  sample::Numbers numbers;
  if (!reader.Numbers(*field, numbers)) return false;
  const int all = SizeCount(part.shape.type);
  const int wanted = half_length ? all - 1 : all;
  if (static_cast<int>(numbers.size()) != wanted) {
    reader.Report(Code::kModelBadValue, *field,
                  fmt::format("has {} number{}; a {}{} takes {}", numbers.size(),
                              numbers.size() == 1 ? "" : "s", type,
                              half_length ? " with 'fromto'" : "", wanted));
    return false;
  }
  if (half_length) numbers.push_back(*half_length);
  numbers.resize(3);
  part.shape.size = tape::Gather<Eigen::Vector3d>({numbers.data(), 3});
  return true;
}

}  // namespace

GeomType TypeOf(std::string_view word) {
  if (word == "box") return GeomType::kBox;
  if (word == "sphere") return GeomType::kSphere;
  if (word == "cylinder") return GeomType::kCylinder;
  if (word == "capsule") return GeomType::kCapsule;
  if (word == "ellipsoid") return GeomType::kEllipsoid;
  return GeomType::kMesh;
}

bool ReadShape(FieldReader& reader, const spec::Entry& entry, const std::filesystem::path& folder,
               Assets& assets, Part& part, Pose& X_FG) {
  const spec::Field* type = entry.Find(Key::kType);
  if (type == nullptr) {
    reader.ReportElement(Code::kSpecMissingKey, part.mark, "has no 'type'");
    return false;
  }
  const std::optional<std::string> word = reader.Word(*type);
  if (!word || HasStrayKeys(reader, entry, *word)) return false;
  part.shape.type = TypeOf(*word);
  if (const spec::Field* fromto = entry.Find(Key::kFromTo); fromto && HasEnds(*word)) {
    const std::optional<Span> span = ReadFromTo(reader, *fromto, entry.Find(Key::kUp));
    if (!span) return false;
    X_FG = span->pose;
    return ReadSize(reader, entry, *word, span->half_length, part);
  }
  const std::optional<Pose> pose = ReadPose(reader, entry);
  if (pose) X_FG = *pose;
  const bool good = *word == "prism"  ? assets.ReadPrism(reader, entry, part)
                    : *word == "mesh" ? assets.ReadMesh(reader, entry, folder, part)
                                      : ReadSize(reader, entry, *word, std::nullopt, part);
  return good && pose.has_value();
}

}  // namespace mjforge::model
