// Reader of parts: material, shape, mass and attributes; splits parts into a visual part and convex
// pieces.

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/grain.h"
#include "mjforge/assemble/names.h"
#include "mjforge/assemble/shape_reader.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

bool ReadRole(FieldReader& reader, const spec::Entry& entry, model::Part& part) {
  std::string word = "both";
  const bool good = reader.ReadOptional(entry, Key::kRole, &FieldReader::Word, word);
  part.role = word == "both"        ? model::Role::kBoth
              : word == "collision" ? model::Role::kCollision
                                    : model::Role::kVisual;
  return good;
}

// Returns true for keys whose values are written to the MJCF element unchanged.
bool IsAttribute(Key id) { return id == Key::kAttribute || id == Key::kRgba || id == Key::kGroup; }

// Makes the contacts of a shape's convex pieces stiffer, because with MuJoCo's default parameters
// objects sink through thin walls. 97 of 100 beakers with walls of 1.5 mm hold dropped balls of 5
// mm with these values, but none with the defaults (docs/physics.md). The time constant is just
// above two timesteps of 2 ms, MuJoCo's lower limit (refsafe).
void HardenContacts(std::vector<model::Attribute>& attributes) {
  if (model::FindAttribute(attributes, "solref") != nullptr) return;
  const auto add = [&](std::string_view name, sample::Numbers numbers) {
    AddUnlessPresent({name, spec::Applies::kCollision, std::move(numbers), {}}, attributes);
  };
  add("solref", {0.005, 1});
  add("solmix", {100});
}

// Returns the bounding box, in frame F, of a part with the pose X_FG. Computes the box from the
// convex pieces if there are any, unless Part::extent describes the exact curved shape.
model::Box3 BoxOf(const model::Part& part, const std::vector<model::Part>& pieces,
                  const model::Pose& X_FG) {
  if (pieces.empty() || part.extent) return model::BoundsOf(part, X_FG);
  model::Box3 box;
  for (const model::Part& piece : pieces) box.Add(model::BoundsOf(piece.shape, X_FG * piece.X_BG));
  return box;
}

bool SetDensity(FieldReader& reader, const spec::Field& field, double density, model::Part& part) {
  if (density == 0 && part.role == model::Role::kBoth)
    return reader.Report(Code::kModelBadValue, field, "is 0; it must be greater than 0",
                         "a part without mass has `role: visual` or `role: collision`");
  part.density = density;
  return true;
}

}  // namespace

Eigen::Vector3d FromCorner(const Eigen::Vector3d& p, const Eigen::Vector3d& total_size,
                           const Eigen::Vector3d& lower) {
  return p - total_size - lower;
}

bool ReadAttributes(FieldReader& reader, const spec::Entry& entry,
                    std::vector<model::Attribute>& out,
                    std::span<const model::Attribute> of_material) {
  bool good = true;
  out.reserve(entry.fields.size() + of_material.size());
  auto field = entry.fields.begin();
  const auto read = [&](bool defaults) {
    for (; field != entry.fields.end() && field->is_default == defaults; ++field) {
      if (!IsAttribute(field->info->id)) continue;
      if (defaults && model::FindAttribute(out, field->info->key) != nullptr) continue;
      good &= reader.ReadAttribute(*field, out.emplace_back());
    }
  };
  read(false);
  for (const model::Attribute& attribute : of_material) AddUnlessPresent(attribute, out);
  read(true);
  return good;
}

void Assembly::AddPart(Scope& scope, const spec::Entry& entry, const model::Pose& X_SF) {
  if (!HasRoomFor("parts", part_count_, entry.mark)) return;
  const std::optional<std::string> name = ReadName(scope, entry, scope.parts, findings_);
  if (!name) return;
  FieldReader reader(scope.values, findings_, "part", *name,
                     sample::Child(scope.parts, std::string_view(*name)));
  model::Part part;
  part.name = scope.prefix + *name;
  part.mark = entry.mark;
  bool good = ReadRole(reader, entry, part);
  const MaterialState* material = nullptr;
  good &= materials_.Read(scope, reader, entry, material);
  if (material != nullptr) part.material = material->index;
  std::optional<ShapePlacement> placed =
      good ? ReadShape(reader, entry, scope.values.spec().folder, TextureOf(object_, part.material),
                       assets_, part)
           : std::nullopt;
  good &= placed.has_value();
  if (placed) good &= ReadMass(reader, entry, material, part);
  good &= ReadAttributes(reader, entry, part.attributes,
                         material != nullptr ? std::span<const model::Attribute>(material->contact)
                                             : std::span<const model::Attribute>());
  if (!good) return;
  model::Pose X_SG = X_SF * placed->X_FG;
  if (scope.places_corners()) {
    const model::Box3 box =
        BoxOf(part, placed->pieces, {.p = Eigen::Vector3d::Zero(), .q = X_SG.q});
    X_SG.p = FromCorner(X_SG.p, *scope.total_size, box.min);
  }
  part.X_BG = scope.X_BS * X_SG;
  AddWithPieces(std::move(part), std::move(placed->pieces));
}

void Assembly::AddWithPieces(model::Part part, std::vector<model::Part> pieces) {
  std::vector<model::Part>& parts = body().parts;
  part_count_ += 1 + static_cast<int>(pieces.size());
  if (part.solid) part.density = 0;  // MuJoCo would apply the density to the render mesh
  const bool is_seen = part.role != model::Role::kCollision;
  for (model::Part& piece : pieces) {
    piece.role = model::Role::kCollision;
    piece.attributes = part.attributes;
    if (pieces.size() > 1) HardenContacts(piece.attributes);
    if (is_seen) {
      std::erase_if(piece.attributes,
                    [](const model::Attribute& a) { return a.applies == spec::Applies::kVisual; });
    } else {
      piece.material = part.material;
    }
  }
  if (pieces.empty()) return parts.push_back(std::move(part));
  if (!is_seen) {
    pieces.front().mass = part.mass;
    pieces.front().solid = model::InFrame(pieces.front().X_BG.Inverse(), *part.solid);
  }
  for (model::Part& piece : pieces) piece.X_BG = part.X_BG * piece.X_BG;
  part.role = model::Role::kVisual;
  if (is_seen) parts.push_back(std::move(part));
  std::ranges::move(pieces, std::back_inserter(parts));
}

// Sets the mass from the first of the following that exists: the part's own mass or density, the
// density of its material, the mass or density in the defaults, the density of water. A visual part
// has mass only if its entry has the key `mass` or `density`.
bool Assembly::ReadMass(FieldReader& reader, const spec::Entry& entry,
                        const MaterialState* material, model::Part& part) {
  const spec::Field* mass = entry.Find(Key::kMass);
  const spec::Field* field = mass != nullptr ? mass : entry.Find(Key::kDensity);
  if (field == nullptr || field->is_default) {
    if (part.role == model::Role::kVisual) return true;
    if (material != nullptr && material->density) {
      if (!SetDensity(reader, *material->density_field, *material->density, part)) return false;
      return SetMass(reader, std::nullopt, part);
    }
  }
  if (field != nullptr) {
    const std::optional<double> number = reader.Number(*field);
    if (!number || !SetDensity(reader, *field, *number, part)) return false;
    return SetMass(reader, mass != nullptr ? number : std::nullopt, part);
  }
  part.density = 1000;  // MuJoCo's default
  return SetMass(reader, std::nullopt, part);
}

// Sets the part's mass to `mass` or, if it is nullopt, computes the mass from the part's density.
bool Assembly::SetMass(FieldReader& reader, const std::optional<double>& mass, model::Part& part) {
  if (part.is_shell && !mass)
    return reader.ReportElement(Code::kSpecMissingKey, part.mark, "is a shell and has no 'mass'",
                                "a density does not say how thick a shell is");
  const std::optional<model::MassProperties> unit =
      part.solid ? part.solid : assets_.UnitMassOf(part.shape, part.mesh);
  if (!unit)
    return reader.ReportElement(Code::kModelBadMesh, part.mark, "has mass but no closed surface",
                                "leave `mass` and `density` out, or write `inertia: shell`");
  if (mass) part.density = 0;
  part.mass = mass ? *mass : part.density * unit->mass;
  return true;
}

}  // namespace mjforge::assemble
