#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "mjforge/model/assembly.h"
#include "mjforge/model/names.h"
#include "mjforge/model/shape_reader.h"

namespace mjforge::model {
namespace {

using diag::Code;
using spec::Key;

bool ReadRole(FieldReader& reader, const spec::Entry& entry, Part& part) {
  const spec::Field* field = entry.Find(Key::kRole);
  if (field == nullptr) return true;
  const std::optional<std::string> word = reader.Word(*field);
  if (!word) return false;
  part.role = *word == "both"        ? Role::kBoth
              : *word == "collision" ? Role::kCollision
                                     : Role::kVisual;
  return true;
}

// Whether it is written to the MJCF element unchanged.
bool IsAttribute(Key id) { return id == Key::kAttribute || id == Key::kRgba || id == Key::kGroup; }

bool Has(const std::vector<Attribute>& attributes, std::string_view name) {
  return std::ranges::find(attributes, name, &Attribute::name) != attributes.end();
}

// Walls are thin, and what lies in them brings MuJoCo's soft contacts along: it would sink through.
// With these a ball of 5 mm that falls 10 cm stays on a floor of 1.5 mm; a time constant of less
// than two steps of 2 ms is not stable. docs/physics.md shows how they were found.
void HardenContacts(std::vector<Attribute>& attributes) {
  if (Has(attributes, "solref")) return;
  const auto add = [&](std::string_view name, sample::Numbers numbers) {
    if (Has(attributes, name)) return;
    Attribute& added = attributes.emplace_back();
    added.name = name;
    added.applies = Applies::kCollision;
    added.numbers = std::move(numbers);
  };
  add("solref", {0.005, 1});
  add("solmix", {100});
}

// What a material's texture asks for.
solid::TextureMapping TextureOf(const Object& object, int index) {
  using Unit = solid::TextureMapping::Unit;
  solid::TextureMapping texture = {.unit = Unit::kNone};
  if (index < 0) return texture;
  const Material& material = object.materials[static_cast<std::size_t>(index)];
  if (material.texture < 0) return texture;
  const Texture& image = object.textures[static_cast<std::size_t>(material.texture)];
  // A cube's pictures lie around the shape by themselves.
  const auto is_2d = [](const Attribute& a) { return a.name == "type" && a.text == "2d"; };
  if (std::ranges::none_of(image.attributes, is_2d)) return texture;
  texture.unit = Unit::kWhole;
  for (const Attribute& attribute : material.attributes) {
    if (attribute.name == "texuniform" && attribute.text == "true") texture.unit = Unit::kMetre;
    if (attribute.name != "texrepeat") continue;
    const std::size_t last = attribute.numbers.size() - 1;
    texture.repeat = {attribute.numbers[0], attribute.numbers[last]};
  }
  // As MuJoCo computes them: half as often as `texrepeat` says.
  if (texture.unit == Unit::kMetre) texture.repeat /= 2;
  return texture;
}

// Of a part, or of the pieces that stand for it.
Box3 BoxOf(const Part& part, const std::vector<Part>& pieces, const Pose& X_FG) {
  if (pieces.empty()) return BoundsOf(part.shape, X_FG);
  Box3 box;
  for (const Part& piece : pieces) box.Add(BoundsOf(piece.shape, X_FG * piece.X_BG));
  return box;
}

}  // namespace

Eigen::Vector3d FromCorner(const Eigen::Vector3d& p, const Eigen::Vector3d& total_size,
                           const Eigen::Vector3d& lower) {
  return p - total_size - lower;
}

bool ReadAttributes(FieldReader& reader, const spec::Entry& entry, std::vector<Attribute>& out,
                    std::span<const Attribute> of_material) {
  bool good = true;
  out.reserve(entry.fields.size() + of_material.size());
  const auto read = [&](auto from, auto to) {
    for (; from != to; ++from) {
      if (!IsAttribute(from->info->id) || Has(out, from->info->key)) continue;
      good &= reader.ReadAttribute(*from, out.emplace_back());
    }
  };
  const auto defaults = std::ranges::find(entry.fields, true, &spec::Field::is_default);
  read(entry.fields.begin(), defaults);
  for (const Attribute& attribute : of_material) {
    if (!Has(out, attribute.name)) out.push_back(attribute);
  }
  read(defaults, entry.fields.end());
  return good;
}

void Assembly::AddPart(Scope& scope, const spec::Entry& entry, const Pose& X_SF) {
  if (!HasRoomFor("parts", part_count_, entry.mark)) return;
  const std::optional<std::string> name = ReadName(scope, entry, scope.parts, findings_);
  if (!name) return;
  FieldReader reader(scope.values, findings_, "part", *name,
                     sample::Child(scope.parts, std::string_view(*name)));
  Part part;
  part.name = scope.prefix + *name;
  part.mark = entry.mark;
  bool good = ReadRole(reader, entry, part);
  const MaterialState* material = nullptr;
  good &= ReadMaterial(scope, reader, entry, part, material);
  const std::optional<PlacedShape> placed =
      good ? ReadShape(reader, entry, scope.values.spec().folder, TextureOf(object_, part.material),
                       assets_, part)
           : std::nullopt;
  good &= placed.has_value();
  if (placed) good &= ReadMass(reader, entry, material, part);
  good &= ReadAttributes(reader, entry, part.attributes,
                         material != nullptr ? std::span<const Attribute>(material->contact)
                                             : std::span<const Attribute>());
  if (!good) return;
  Pose X_SG = X_SF * placed->X_FG;
  if (scope.places_corners()) {
    const Box3 box = BoxOf(part, placed->pieces, {.p = Eigen::Vector3d::Zero(), .q = X_SG.q});
    X_SG.p = FromCorner(X_SG.p, *scope.total_size, box.min);
  }
  part.X_BG = scope.X_BS * X_SG;
  AddWithPieces(std::move(part), placed->pieces);
}

void Assembly::AddWithPieces(Part part, std::vector<Part> pieces) {
  std::vector<Part>& parts = body().parts;
  part_count_ += 1 + static_cast<int>(pieces.size());
  if (part.solid) part.density = 0;  // MuJoCo would take it for that of the mesh
  const bool is_seen = part.role != Role::kCollision;
  for (Part& piece : pieces) {
    piece.role = Role::kCollision;
    piece.attributes = part.attributes;
    if (pieces.size() > 1) HardenContacts(piece.attributes);
    if (is_seen) {
      const auto is_look = [](const Attribute& a) { return a.applies == Applies::kVisual; };
      std::erase_if(piece.attributes, is_look);
    } else {
      piece.material = part.material;
    }
  }
  if (pieces.empty()) return parts.push_back(std::move(part));
  if (!is_seen) {
    pieces.front().mass = part.mass;
    pieces.front().solid = InFrame(pieces.front().X_BG.Inverse(), *part.solid);
  }
  for (Part& piece : pieces) piece.X_BG = part.X_BG * piece.X_BG;
  part.role = Role::kVisual;
  if (is_seen) parts.push_back(std::move(part));
  std::ranges::move(pieces, std::back_inserter(parts));
}

bool Assembly::ReadMaterial(Scope& scope, FieldReader& reader, const spec::Entry& entry, Part& part,
                            const MaterialState*& material) {
  const spec::Field* field = entry.Find(Key::kMaterial);
  if (field == nullptr) return true;
  material = materials_.Use(scope, reader, *field);
  if (material == nullptr) return false;
  part.material = material->index;
  return true;
}

bool Assembly::SetDensity(FieldReader& reader, const spec::Field& field, double density,
                          Part& part) {
  const bool may_be_zero = part.role == Role::kVisual;
  if (density == 0 && !may_be_zero) {
    reader.Report(Code::kModelBadValue, field, "is 0; it must be greater than 0",
                  "for a part without mass use `role: visual`");
    return false;
  }
  part.density = density;
  return true;
}

// The part's own mass or density, its material's density, the defaults'
// mass or density, water. A visual part has mass only by its own word.
bool Assembly::ReadMass(FieldReader& reader, const spec::Entry& entry,
                        const MaterialState* material, Part& part) {
  const spec::Field* mass = entry.Find(Key::kMass);
  const spec::Field* field = mass != nullptr ? mass : entry.Find(Key::kDensity);
  if (field == nullptr || field->is_default) {
    if (part.role == Role::kVisual) return true;
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
  part.density = 1000.0;  // MuJoCo's
  return SetMass(reader, std::nullopt, part);
}

// The mass given, or that of the part's density.
bool Assembly::SetMass(FieldReader& reader, const std::optional<double>& mass, Part& part) {
  const std::optional<MassProperties> unit =
      part.solid ? part.solid : assets_.UnitMassOf(part.shape, part.mesh);
  if (!unit) {
    reader.ReportElement(Code::kModelBadMesh, part.mark, "has mass but no closed surface",
                         "leave `mass` and `density` out");
    return false;
  }
  if (mass) part.density = 0;
  part.mass = mass ? *mass : part.density * unit->mass;
  return true;
}

}  // namespace mjforge::model
