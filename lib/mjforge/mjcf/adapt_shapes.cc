// Replacement of cylinders and ellipsoids by convex meshes for a target that cannot collide them.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "mjforge/mjcf/adapt.h"
#include "mjforge/mjcf/element_writer.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {
namespace {

using diag::Code;
using model::GeomType;
using model::Part;
using model::Role;
using model::TriangleMesh;

// Number of sides of the prism that replaces a cylinder. Fewer than 20, because MJX drops half of
// the corners of faces with 20 or more corners; a multiple of 4, because the prism then has corners
// on the x and y axes and therefore the extents of the cylinder. All corners are on the cylinder.
// The middle of each side is 2 % of the radius inside the cylinder.
constexpr int kSides = 16;

TriangleMesh MakePrism(const Eigen::Vector3d& size) {
  std::array<Eigen::Vector2d, kSides> polygon;
  for (std::size_t i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kSides;
    polygon[i] = {size.x() * FlushNoise(std::cos(angle)), size.x() * FlushNoise(std::sin(angle))};
  }
  return solid::MakeConvexPrism(polygon, 2 * size.y()).value_or(TriangleMesh());
}

// Adds one vertex per edge to a mesh: the sum of the edge's two ends. UnitIcosphere() normalizes
// all vertices, which turns this sum into the projection of the edge's midpoint onto the sphere.
class EdgeMidpoints {
 public:
  explicit EdgeMidpoints(std::vector<Eigen::Vector3d>& vertices) : vertices_(vertices) {}

  int IndexOf(int i, int j) {
    const auto [found, is_new] = indices_.try_emplace(std::minmax(i, j), vertices_.size());
    if (is_new) {
      const Eigen::Vector3d sum =
          vertices_[static_cast<std::size_t>(i)] + vertices_[static_cast<std::size_t>(j)];
      vertices_.push_back(sum);
    }
    return static_cast<int>(found->second);
  }

 private:
  std::vector<Eigen::Vector3d>& vertices_;
  std::map<std::pair<int, int>, std::size_t> indices_;
};

// Returns an icosahedron with each face subdivided into four, projected onto the unit sphere. Six
// of the edge midpoints are on the axes.
TriangleMesh UnitIcosphere() {
  constexpr double kGolden = std::numbers::phi;
  TriangleMesh ball;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-kGolden, kGolden}) {
      ball.vertices.emplace_back(0, a, b);
      ball.vertices.emplace_back(a, b, 0);
      ball.vertices.emplace_back(b, 0, a);
    }
  }
  const auto at = [&](int k) { return ball.vertices[static_cast<std::size_t>(k)]; };
  const auto is_edge = [&](int i, int j) {
    return (at(i) - at(j)).norm() < 2.1;  // edges have length 2; the next larger distance is 2 phi
  };
  EdgeMidpoints midpoints(ball.vertices);
  for (int i = 0; i < 12; ++i) {
    for (int j = i + 1; j < 12; ++j) {
      for (int k = j + 1; k < 12; ++k) {
        if (!is_edge(i, j) || !is_edge(j, k) || !is_edge(i, k)) continue;
        const int ij = midpoints.IndexOf(i, j);
        const int jk = midpoints.IndexOf(j, k);
        const int ik = midpoints.IndexOf(i, k);
        ball.triangles.insert(ball.triangles.end(),
                              {{i, ij, ik}, {j, jk, ij}, {k, ik, jk}, {ij, jk, ik}});
      }
    }
  }
  for (Eigen::Vector3d& vertex : ball.vertices) vertex.normalize();
  for (std::array<int, 3>& t : ball.triangles) {
    if (at(t[0]).cross(at(t[1])).dot(at(t[2])) < 0) std::swap(t[1], t[2]);
  }
  return ball;
}

TriangleMesh MakeEllipsoid(const Eigen::Vector3d& size) {
  static const TriangleMesh kUnit = UnitIcosphere();
  TriangleMesh mesh = kUnit;
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = vertex.cwiseProduct(size);
  return mesh;
}

bool IsRound(GeomType type) { return type == GeomType::kCylinder || type == GeomType::kEllipsoid; }

class RoundShapeReplacer {
 public:
  explicit RoundShapeReplacer(model::Object& object) : object_(object) {
    for (const auto& mesh : object.meshes) mesh_names_.insert(mesh->name);
    ForEachGeomReference([&](const std::string& name) { referenced_geoms_.insert(name); });
  }

  void Run() {
    for (model::Body& body : object_.bodies) {
      const auto is_replaced = [](const Part& part) {
        return part.role != Role::kVisual && IsRound(part.shape.type);
      };
      if (std::ranges::none_of(body.parts, is_replaced)) continue;
      std::vector<Part> parts;
      for (Part& part : body.parts) {
        if (is_replaced(part)) {
          Replace(std::move(part), parts);
        } else {
          parts.push_back(std::move(part));
        }
      }
      body.parts = std::move(parts);
      // Without an inertial element MuJoCo would compute the inertia from the mesh.
      body.explicit_inertial = true;
    }
    if (visual_copies_.empty()) return;
    // Makes references to a replaced geom refer to its visual copy, because tendons wrap around the
    // true shape and sensors measure in the frame of the true shape.
    ForEachGeomReference([&](std::string& name) {
      const auto copy = visual_copies_.find(name);
      if (copy != visual_copies_.end()) name = copy->second;
    });
  }

  int cylinders = 0;
  int ellipsoids = 0;
  diag::SourceMark first_mark;  // mark of the first replaced part

 private:
  // Calls `visit` with each name of a geom in elements that are not in <contact>.
  template <typename Visit>
  void ForEachGeomReference(const Visit& visit) {
    for (model::Section& section : object_.sections) {
      if (section.info->name == "contact") continue;
      for (model::Element& element : section.elements) {
        model::ForEachReference(element, [&](std::string_view kind, std::string& name) {
          if (kind == "geom") visit(name);
        });
      }
    }
  }

  void Replace(Part part, std::vector<Part>& parts) {
    int& count = part.shape.type == GeomType::kCylinder ? cylinders : ellipsoids;
    if (cylinders + ellipsoids == 0) first_mark = part.mark;
    ++count;
    Part visual_copy = part;
    const bool has_visual = part.role == Role::kBoth && !part.as_is;
    part.mesh = MeshOf(part);
    part.shape = {GeomType::kMesh, Eigen::Vector3d::Zero(),
                  &object_.meshes[static_cast<std::size_t>(part.mesh)]->mesh};
    part.density = 0.0;  // the part keeps the mass of the true shape
    if (has_visual) {
      part.role = Role::kCollision;
      part.material = -1;
      std::erase_if(part.attributes, [](const model::Attribute& attribute) {
        return attribute.applies == model::Applies::kVisual;
      });
    }
    const std::string name = part.name;
    parts.push_back(std::move(part));
    if (!has_visual && !referenced_geoms_.contains(name)) return;
    AddVisualCopy(std::move(visual_copy), parts);
  }

  // Adds the true shape as a visual part, without contacts.
  void AddVisualCopy(Part copy, std::vector<Part>& parts) {
    copy.role = Role::kVisual;
    copy.mass = copy.density = 0.0;
    std::string name = copy.name + std::string(model::kVisualSuffix);
    if (copy.as_is) {
      std::swap(copy.name, name);
      for (const std::string_view bits : {"contype", "conaffinity"}) {
        std::erase_if(copy.attributes,
                      [&](const model::Attribute& attribute) { return attribute.name == bits; });
        copy.attributes.push_back({.name = bits, .numbers = {0}});
      }
      visual_copies_.emplace(name, copy.name);
    } else {
      visual_copies_.emplace(copy.name, name);
    }
    parts.push_back(std::move(copy));
  }

  int MeshOf(const Part& part) {
    const Eigen::Vector3d& size = part.shape.size;
    const auto [found, is_new] =
        meshes_.try_emplace({part.shape.type, size.x(), size.y(), size.z()}, object_.meshes.size());
    if (!is_new) return static_cast<int>(found->second);
    auto asset = std::make_unique<model::MeshAsset>();
    asset->name = part.name + "_convex";
    while (!mesh_names_.insert(asset->name).second) asset->name += '_';
    asset->mesh = part.shape.type == GeomType::kCylinder ? MakePrism(size) : MakeEllipsoid(size);
    asset->is_hull = true;
    asset->mark = part.mark;
    object_.meshes.push_back(std::move(asset));
    return static_cast<int>(found->second);
  }

  model::Object& object_;
  std::set<std::string, std::less<>> mesh_names_;
  std::set<std::string, std::less<>> referenced_geoms_;
  std::map<std::string, std::string, std::less<>> visual_copies_;  // by name of the replaced geom
  // Indices in Object::meshes, by the type and size of the shape that the mesh replaces.
  std::map<std::tuple<GeomType, double, double, double>, std::size_t> meshes_;
};

}  // namespace

void AdaptShapes(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  if (rules.supports_round_shapes) return;
  RoundShapeReplacer replacer(object);
  replacer.Run();
  const auto text = [](int count, std::string_view word, std::string_view mesh,
                       std::string_view meshes) {
    return count == 1 ? fmt::format("1 {} collides as a {}", word, mesh)
                      : fmt::format("{} {}s collide as {}", count, word, meshes);
  };
  std::string what;
  if (replacer.cylinders > 0)
    what = text(replacer.cylinders, "cylinder", "16-sided prism", "16-sided prisms");
  if (replacer.ellipsoids > 0) {
    if (!what.empty()) what += ", ";
    what += text(replacer.ellipsoids, "ellipsoid", "42-cornered mesh", "42-cornered meshes");
  }
  if (what.empty()) return;
  findings.Warn(
      Code::kTargetDropped, replacer.first_mark,
      fmt::format("{} does not collide cylinders and ellipsoids with boxes and meshes: {}",
                  rules.name, what),
      "mass and look still come from the original shapes; capsules and spheres need no "
      "replacement");
}

}  // namespace mjforge::mjcf
