#ifndef MJFORGE_MODEL_MODEL_H_
#define MJFORGE_MODEL_MODEL_H_

// ObjectSpec + drawn values -> Object: bodies, parts, poses and masses, numbers
// only, everything checked that MuJoCo would not notice or not explain.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/model/meshes.h"
#include "mjforge/model/poses.h"
#include "mjforge/model/shapes.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

/// Objects with more parts than this are refused.
inline constexpr int kMaxParts = 100'000;

/// One MJCF attribute that mjforge carries without interpreting it: its numbers
/// or, if there are none, its text.
struct Attribute {
  std::string_view name;  // of the field table: lives forever
  spec::Applies applies = spec::Applies::kBoth;
  sample::Numbers numbers;
  std::string text;
};

/// A mesh asset. Inline vertices (a prism), or a file that is copied beside the output.
struct MeshAsset {
  std::string name;
  TriangleMesh mesh;           // scaled
  std::filesystem::path file;  // empty: inline, as vertices and triangles
  /// The surface is the convex hull of the vertices (a prism's): MuJoCo makes
  /// the triangles of those itself.
  bool is_hull = false;
  std::string output_file;  // its name in assets/
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  diag::SourceMark mark;
};

struct Texture {
  std::string name;
  std::filesystem::path file;  // empty: builtin
  std::string output_file;
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

/// One part of a body B: a solid, written as a collision geom, a visual one or both.
struct Part {
  std::string name;
  Role role = Role::kBoth;
  Shape shape;
  int mesh = -1;  // in Object::meshes
  Pose X_BG;
  /// kg; 0 for a visual part. MJCF says it as the density where that was given
  /// (`density` > 0), so that MuJoCo computes it from the same number.
  double mass = 0;
  double density = 0;
  int material = -1;  // in Object::materials
  std::vector<Attribute> attributes;
  diag::SourceMark mark;
};

struct Joint {
  std::string name;
  std::string_view type = "free";  // free ball slide hinge
  Eigen::Vector3d pos = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector2d> range;  // limited if present
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
  int parent = -1;  // in Object::bodies; -1: the world
  Pose X_PB;
  std::vector<Joint> joints;
  std::vector<Part> parts;
  std::vector<Site> sites;
  MassProperties mass_properties;  // in B
  /// Whether MJCF states the inertia instead of leaving it to MuJoCo: bodies
  /// with mesh parts, whose mass MuJoCo's versions compute differently.
  bool explicit_inertial = false;
  diag::SourceMark mark;
};

/// Extents of the collision parts in the root frame (all parts if none collides).
struct Bounds {
  Box3 aabb;
  double top_offset = 0;         // aabb.max.z, m
  double bottom_offset = 0;      // aabb.min.z, m
  double horizontal_radius = 0;  // largest distance from the root's z axis, m
  Eigen::Vector3d half_size() const { return (aabb.max - aabb.min) / 2; }
};

struct Object {
  std::string name;
  std::vector<Body> bodies;         // the root first, parents before children
  std::vector<Material> materials;  // those in use
  std::vector<Texture> textures;
  std::vector<std::unique_ptr<MeshAsset>> meshes;  // shared where equal
  Bounds bounds;
  MassProperties mass_properties;  // in the root frame
};

/// Is the point in a collision part?
bool Contains(const Object& object, const Eigen::Vector3d& p_Root);

/// Builds objects; keeps what variants share (meshes read from files).
class Assembler {
 public:
  struct Options {
    std::string name;    // of the object; empty: the spec's
    bool prefix = true;  // put `name_` before every element's name
  };

  /// Nothing when there was an error; then findings say what.
  std::optional<Object> Assemble(sample::Evaluator& values, const Options& options,
                                 diag::Findings& findings);

  struct CachedMesh {
    bool exists = false;
    std::optional<TriangleMesh> mesh;
    std::string why_not;                       // where there is no mesh
    std::optional<std::string> why_not_solid;  // where there is
    bool fit_for_mujoco = true;                // MuJoCo reads the same surface from the file
  };
  /// The unscaled content of a file, read at most once.
  const CachedMesh& ReadFile(const std::filesystem::path& file);

  struct CachedTexture {
    bool exists = false;
    bool is_png = false;
  };
  /// What a picture's file is, looked at once at most.
  const CachedTexture& ReadTexture(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, CachedMesh> files_;
  std::map<std::filesystem::path, CachedTexture> textures_;
};

}  // namespace mjforge::model

#endif  // MJFORGE_MODEL_MODEL_H_
