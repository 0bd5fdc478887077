// Conversion of parts, sites and meshes to null elements: tiny, massless, invisible and without
// contact forces.

#include "mjforge/padding/null_elements.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace mjforge::padding {
namespace {

// Sizes of null elements, m. MuJoCo rejects a mesh with a volume below 1e-15 m^3.
constexpr double kNullSize = 1e-6;
constexpr double kNullMeshSize = 2e-4;

// Returns a point inside a part with a convex shape, in the body's frame: the centre of the shape,
// or the mean vertex of a mesh.
Eigen::Vector3d CenterOf(const model::Part& part) {
  if (part.shape.type != model::GeomType::kMesh) return part.X_BG.p;
  return part.X_BG * model::MeanVertex(*part.shape.mesh);
}

// Margin and gap, m, with which null geoms have no contact force in any release of MuJoCo. Releases
// up to 3.4 use the larger of two geoms' margins and the larger of their gaps, and have no force at
// distances above margin - gap. Later releases add both margins and both gaps, and find contacts
// below margin + gap. The attributes contype and conaffinity are not set to zero instead, because
// all worlds of a parallel simulation share them.
constexpr double kNullMargin = -2000;
constexpr double kNullGap = 1000;

// Sets an attribute; replaces an attribute with the same name.
void Set(std::string_view name, sample::Numbers numbers,
         std::vector<model::Attribute>& attributes) {
  std::erase_if(attributes, [&](const model::Attribute& one) { return one.name == name; });
  attributes.push_back({.name = name, .numbers = std::move(numbers)});
}

}  // namespace

Eigen::Vector3d MiddleOf(const model::Body& body) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double largest = 0;
  for (const model::Part& part : body.parts) {
    const double volume = part.role == model::Role::kVisual ? 0 : model::Volume(part.shape);
    if (volume <= largest) continue;
    largest = volume;
    middle = CenterOf(part);
  }
  return middle;
}

std::unique_ptr<model::MeshAsset> NullMesh(const model::MeshAsset& mesh) {
  auto null = std::make_unique<model::MeshAsset>(mesh);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.mesh.vertices) box.extend(vertex);
  const double factor = kNullMeshSize / box.sizes().maxCoeff();
  null->scale *= factor;
  null->mesh.in_micrometres = false;
  for (Eigen::Vector3d& vertex : null->mesh.vertices) vertex *= factor;
  return null;
}

void MakeNull(const Eigen::Vector3d& center, model::Part& part) {
  part.X_BG = {};
  if (part.shape.type == model::GeomType::kMesh) {
    part.X_BG.p = center - model::MeanVertex(*part.shape.mesh);
  } else {
    part.X_BG.p = center;
    part.shape.size.head(model::SizeCount(part.shape.type)).setConstant(kNullSize);
  }
  part.mass = 0;
  part.density = 0;
  part.solid.reset();
  part.extent.reset();
  part.X_GS = {};
  part.is_shell = false;
  part.material = -1;
  // Removes the fluid shape, because a geom with a fluid shape, however small, gives its whole body
  // another fluid model.
  std::erase_if(part.attributes, [](const model::Attribute& attribute) {
    return attribute.name == "fluidshape" || attribute.name == "fluidcoef";
  });
  Set("rgba", {0, 0, 0, 0}, part.attributes);
  Set("margin", {kNullMargin}, part.attributes);
  Set("gap", {kNullGap}, part.attributes);
}

void MakeNull(const Eigen::Vector3d& center, model::Site& site) {
  site.X_BS = {};
  site.X_BS.p = center;
  site.size.head(model::SizeCount(site.type)).setConstant(kNullSize);
  site.material = -1;
  Set("rgba", {0, 0, 0, 0}, site.attributes);
}

}  // namespace mjforge::padding
