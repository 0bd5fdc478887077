// Object: numbers in SI units that describe a tree of bodies with parts, joints and sites, its
// assets, and its sections of MJCF.

#pragma once

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
#include "mjforge/model/bounds.h"
#include "mjforge/model/checks.h"
#include "mjforge/model/pile.h"
#include "mjforge/model/poses.h"
#include "mjforge/model/region.h"
#include "mjforge/model/shapes.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

/// Maximum number of parts of an object. MuJoCo's loading time grows with the square of the number
/// of parts; with this number, it is within the default time limit even on a slow machine.
inline constexpr int kMaxParts = 40'000;

/// Suffix of the visual geom of a part with two geoms; the collision geom has the part's name.
inline constexpr std::string_view kVisualSuffix = "_vis";

/// An inline mesh (from the library `solid`), or a mesh file that is copied into the output.
struct MeshAsset {
  std::string name;
  TriangleMesh mesh;           // surface after scaling
  std::filesystem::path file;  // empty for inline meshes
  /// True if the surface is the convex hull of the vertices; MuJoCo computes its triangles.
  bool is_hull = false;
  std::string output_file;  // file name in assets/
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  /// Other attributes of a mesh of an attached file (refpos, refquat, inline vertices). All of them
  /// are already applied to `mesh`.
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct TextureFile {
  std::string_view attribute = "file";  // "file", "fileright", "fileup", ...
  std::filesystem::path file;
  std::string output_file;  // file name in assets/

  bool operator==(const TextureFile&) const = default;
};

struct Texture {
  std::string name;
  std::vector<TextureFile> files;  // empty for builtin textures
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Material {
  std::string name;
  int texture = -1;  // index in Object::textures
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

enum class Role { kBoth, kCollision, kVisual };

/// A rigid solid of a body B, written as a collision geom, a visual geom or both. A shape that the
/// library `solid` makes becomes several parts: its visual render mesh, which has the name of the
/// shape, and its colliding convex pieces NAME_0, NAME_1, ...
struct Part {
  std::string name;
  std::string piece_of;  // for a convex piece, the name of its shape; otherwise empty

  /// Returns the full name of the spec's part: this part or, for a convex piece, its shape.
  const std::string& NameInSpec() const { return piece_of.empty() ? name : piece_of; }

  Role role = Role::kBoth;
  Shape shape;
  int mesh = -1;  // index in Object::meshes
  Pose X_BG;
  /// Mass, kg; 0 for most visual parts. If `density`, kg/m^3, is positive, too, MJCF contains this
  /// number of the spec instead of the mass, and MuJoCo computes the mass.
  double mass = 0;
  double density = 0;
  /// Mass properties of the exact solid at 1 kg/m^3, in the geom's frame G. If nullopt, `shape` is
  /// exact.
  std::optional<MassProperties> solid;
  /// Convex hull of the exact solid, in the solid's frame S. If null, `shape` has the same hull. If
  /// a solid has several pieces, one has the hull of the solid; the others have an empty hull.
  std::shared_ptr<const solid::Extent> extent;
  Pose X_GS;
  bool is_shell = false;  // true: mass on the mesh's surface; `solid->mass` is its area
  int material = -1;      // index in Object::materials
  /// True for a geom (of an attached file, or a region for robocasa) that is written with its own
  /// name and only its own attributes. `role` then determines only whether the geom collides.
  bool as_is = false;
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Joint {
  std::string name;
  std::string_view type = "free";                   // free ball slide hinge
  Eigen::Vector3d pos = Eigen::Vector3d::Zero();    // anchor in the frame B of the body, m
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // in B, of any length but 0
  std::optional<Eigen::Vector2d> range;             // rad or m; nullopt: the joint is not limited
  /// Start position as in qpos: m or rad; w, x, y, z for a ball joint. Empty: the joint's zero.
  sample::Numbers start;
  /// Start velocity as in qvel, m/s or rad/s. The linear velocity of a free joint is in the frame P
  /// in which X_PB of its body is given. Empty: at rest.
  sample::Numbers start_velocity;
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Site {
  std::string name;
  GeomType type = GeomType::kSphere;
  Eigen::Vector3d size = Eigen::Vector3d::Constant(0.005);  // m, in the convention of Shape::size
  Pose X_BS;
  int material = -1;
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Body {
  std::string name;
  int parent = -1;  // index in Object::bodies; -1 (the world) for the root and free bodies
  Pose X_PB;
  std::vector<Joint> joints;
  std::vector<Part> parts;
  std::vector<Site> sites;
  std::vector<Region> regions;
  double front = 0;  // angle of the body's front about z, counter-clockwise from -y, rad
  /// Region or site at which the body was placed, named as in the spec ("table.surface"); empty if
  /// the body was not placed.
  std::string place_name;
  std::vector<Element> elements;                     // cameras and lights
  std::vector<Attribute> attributes;                 // attributes of <body>
  MassProperties mass_properties;                    // in B
  std::optional<Eigen::Quaterniond> principal_axes;  // axes in B, in the order of an attached file
  /// True if MJCF contains the inertia (<inertial>): for bodies with mesh parts, because MuJoCo's
  /// releases compute the mass of meshes differently; for bodies whose geoms differ from the exact
  /// solid; and for attached bodies, which have the inertia of their file.
  bool explicit_inertial = false;
  /// Index of the body (maybe this body) whose key `mjcf:` adds this body; -1 if no key adds it.
  int attached = -1;
  diag::SourceMark mark;
};

/// State of an actuator at the start: control and, if the actuator has one, activation.
struct Setpoint {
  std::string actuator;
  std::optional<double> ctrl;
  std::optional<double> act;
  diag::SourceMark mark;
};

struct Object {
  std::string name;
  std::vector<Body> bodies;         // the root first, parents before children
  std::vector<Material> materials;  // only those that elements use
  std::vector<Texture> textures;
  std::vector<std::unique_ptr<MeshAsset>> meshes;  // equal meshes only once
  std::vector<Section> sections;                   // in the order of spec::Sections()
  std::vector<Setpoint> setpoints;  // in the order of actuators; empty if all actuators start at 0
  Bounds bounds;
  MassProperties mass_properties;       // in W, at the start state
  std::optional<StartForm> start_form;  // nullopt: depends on the bodies and the output format
  diag::SourceMark start_mark;          // first entry of `pose:`, or else `start:`; may be empty
  Checks checks;
  std::vector<Expectation> expectations;
  std::vector<Pile> piles;
  std::vector<std::string> left_out;  // full names of bodies for which no place was found
  std::vector<diag::Finding> unmet_expectations;  // violated conditions (`that`) of `expect:`
};

/// Returns the pose X_WB of every body at the start state. W is the object's frame, in which X_PB
/// of the root and of free bodies is given; for most objects, W is the frame of the root.
std::vector<Pose> BodyPoses(const Object& object);

/// Returns the number of a body's geoms in MJCF; a part that collides and is visual has two.
std::size_t GeomCount(const Body& body);

/// Returns the elements of a section; an empty list if the object does not have the section.
std::span<const Element> ElementsOf(const Object& object, std::string_view section);

/// Returns true if the point is inside a collision part at the start state.
bool Contains(const Object& object, const Eigen::Vector3d& p_W);

}  // namespace mjforge::model
