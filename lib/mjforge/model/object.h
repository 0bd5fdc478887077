#pragma once

// An object: a tree of bodies with parts, joints and sites, its assets, and the
// MJCF sections that go with it. Numbers only, in SI units.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/model/attributes.h"
#include "mjforge/model/checks.h"
#include "mjforge/model/meshes.h"
#include "mjforge/model/poses.h"
#include "mjforge/model/shapes.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

/// Objects with more parts than this are refused: MuJoCo's loading grows with the square of their
/// number, and so many still fit into the default time limit on a machine half as fast as ours.
inline constexpr int kMaxParts = 40'000;

/// A mesh asset. Inline vertices (a prism, the look and the pieces of a lathe), or a file that is
/// copied into the output.
struct MeshAsset {
  std::string name;
  TriangleMesh mesh;           // scaled
  std::filesystem::path file;  // empty: inline, as vertices and triangles
  /// The surface is the convex hull of the vertices, as for a prism: MuJoCo makes the triangles
  /// itself.
  bool is_hull = false;
  std::string output_file;  // its name in assets/
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  /// For the mesh of an attached file: the other attributes of its element (refpos, refquat, inline
  /// vertices); `mesh` is the result with all of them applied.
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct TextureFile {
  std::string_view attribute = "file";  // or fileright, fileup, ...
  std::filesystem::path file;
  std::string output_file;  // its name in assets/

  bool operator==(const TextureFile&) const = default;
};

struct Texture {
  std::string name;
  std::vector<TextureFile> files;  // none: builtin
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Material {
  std::string name;
  int texture = -1;  // in Object::textures
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

enum class Role { kBoth, kCollision, kVisual };

/// One part of a body B: a solid, written as a collision geom, a visual one or both. A shape that
/// MuJoCo does not have is several: what is seen of it, under its name, and its pieces, NAME_0 and
/// so on, which collide.
struct Part {
  std::string name;
  std::string piece_of;  // the name of the shape whose piece it is; empty: none
  Role role = Role::kBoth;
  Shape shape;
  int mesh = -1;  // in Object::meshes
  Pose X_BG;
  /// kg; 0 for a visual part. MJCF states the density instead if that was given (`density` > 0), so
  /// that MuJoCo computes the mass from the same number.
  double mass = 0;
  double density = 0;
  /// Of density 1, in G: the true solid that has the mass, where that is not `shape`.
  std::optional<MassProperties> solid;
  int material = -1;  // in Object::materials
  /// A geom of an attached file: written under its own name and with no more
  /// attributes than it has; the role only says whether it collides.
  bool as_is = false;
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Joint {
  std::string name;
  std::string_view type = "free";  // free ball slide hinge
  Eigen::Vector3d pos = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector2d> range;  // limited if present
  /// Where it stands at the start, as qpos has it: m or rad, of a ball joint w, x, y, z. Empty: at
  /// its zero.
  sample::Numbers start;
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Site {
  std::string name;
  GeomType type = GeomType::kSphere;
  Eigen::Vector3d size = Eigen::Vector3d::Constant(0.005);
  Pose X_BS;
  int material = -1;
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Body {
  std::string name;
  int parent = -1;  // in Object::bodies; -1: the world, for the root and for free bodies
  Pose X_PB;
  std::vector<Joint> joints;
  std::vector<Part> parts;
  std::vector<Site> sites;
  std::vector<Element> elements;      // cameras and lights
  std::vector<Attribute> attributes;  // of the body itself
  MassProperties mass_properties;     // in B
  /// Whether MJCF states the inertia instead of leaving it to MuJoCo: bodies
  /// with mesh parts, whose mass MuJoCo's versions compute differently, and
  /// attached ones, which keep the inertia of their own file.
  bool explicit_inertial = false;
  /// Of an attached file's bodies: the first of them, in Object::bodies.
  int attached = -1;
  diag::SourceMark mark;
};

/// Extents of the collision parts in the root frame (all parts if none collides).
struct Bounds {
  Box3 aabb;
  double top_offset = 0;         // aabb.max.z, m
  double bottom_offset = 0;      // aabb.min.z, m
  double horizontal_radius = 0;  // largest distance from the root's z axis, m
  Eigen::Vector3d half_size() const;
};

struct Object {
  std::string name;
  std::vector<Body> bodies;         // the root first, parents before children
  std::vector<Material> materials;  // those in use
  std::vector<Texture> textures;
  std::vector<std::unique_ptr<MeshAsset>> meshes;  // shared where equal
  std::vector<Section> sections;                   // in the order of spec::Sections()
  Bounds bounds;
  MassProperties mass_properties;  // in the root frame, with all joints at zero
  Checks checks;
  std::vector<Expectation> expectations;
  std::vector<diag::Finding> unmet;  // conditions of `expect:` that do not hold
};

/// X_RootB of every body with all joints at zero; that of the first body, the root, is the
/// identity.
std::vector<Pose> BodyPoses(const Object& object);

/// How many geoms MJCF has for the body's parts: a part that is both collision and visual has two.
std::size_t GeomCount(const Body& body);

/// The elements of a section, none if the object has none.
std::span<const Element> ElementsOf(const Object& object, std::string_view section);

/// Is the point in a collision part?
bool Contains(const Object& object, const Eigen::Vector3d& p_Root);

}  // namespace mjforge::model
