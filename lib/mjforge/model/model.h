#ifndef MJFORGE_MODEL_MODEL_H_
#define MJFORGE_MODEL_MODEL_H_

// ObjectSpec + drawn values -> Object: bodies, parts, poses and masses, numbers
// only, everything checked that MuJoCo would not notice or not explain.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
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
  std::string_view refers = {};  // kind of element the text names; see spec::FieldInfo

  bool operator==(const Attribute&) const = default;
};

/// An MJCF element that mjforge carries whole: a sensor, a camera.
struct Element {
  std::string_view tag;  // of the section table: lives forever
  std::string name;      // empty: it has none
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  diag::SourceMark mark;
};

/// The elements of one section (contact, sensor, ...).
struct Section {
  const spec::SectionInfo* info = nullptr;
  std::vector<Element> elements;
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
  /// Of an attached file's mesh: what else its element says (refpos, refquat,
  /// inline vertices); `mesh` is what all of it comes to.
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
  std::vector<Element> elements;      // cameras and lights
  std::vector<Attribute> attributes;  // of the body itself
  MassProperties mass_properties;     // in B
  /// Whether MJCF states the inertia instead of leaving it to MuJoCo: bodies
  /// with mesh parts, whose mass MuJoCo's versions compute differently, and
  /// attached ones, which keep the inertia of their own file.
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
  std::vector<Section> sections;                   // in the order of spec::Sections()
  Bounds bounds;
  MassProperties mass_properties;  // in the root frame, at the joints' zero
};

/// X_RootB of every body at the joints' zero; the root's is the identity.
std::vector<Pose> BodyPoses(const Object& object);

/// The elements of a section, none if the object has none.
std::span<const Element> ElementsOf(const Object& object, std::string_view section);

/// One body of an MJCF file with all below it, each with the numbers MuJoCo
/// compiled in that file (autolimits, classes, angles, inertia options and the
/// rest resolved). Names are the file's, made names; references go to them.
struct Attachment {
  /// The first is the body asked for, with parent -1; parents before children.
  /// Every body states its inertia (explicit_inertial, mass_properties).
  std::vector<Body> bodies;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<std::unique_ptr<MeshAsset>> meshes;
  /// contact, equality, tendon, actuator and sensor elements that refer to
  /// nothing outside; unnamed ones stay so.
  std::vector<Section> sections;
  /// Names of the first body's joints, which attaching takes away.
  std::vector<std::string> root_joints;
};

/// Reads MJCF files; implemented where MuJoCo is.
class AttachmentSource {
 public:
  virtual ~AttachmentSource() = default;
  /// The body called `body` in `file` (empty: the first). Findings stand at
  /// `mark`, with notes in the XML, at every call, the warnings, too; null after
  /// an error. Reads each file once and keeps the result as long as it lives.
  virtual const Attachment* Attach(const std::filesystem::path& file, const std::string& body,
                                   diag::SourceMark mark, diag::Findings& findings) = 0;
};

/// Is the point in a collision part?
bool Contains(const Object& object, const Eigen::Vector3d& p_Root);

/// Builds objects; keeps what variants share (files read).
class Assembler {
 public:
  struct Options {
    std::string name;       // of the object; empty: the spec's
    bool prefix = true;     // put `name_` before every element's name
    std::string root = {};  // name of the root body; empty: the object's
  };

  /// `attachments` reads MJCF files; it must outlive the assembler. Without one
  /// an `mjcf:` body is an error.
  explicit Assembler(AttachmentSource* attachments = nullptr) : attachments_(attachments) {}

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

  AttachmentSource* attachments() const { return attachments_; }

 private:
  AttachmentSource* attachments_;
  std::map<std::filesystem::path, CachedMesh> files_;
  std::map<std::filesystem::path, CachedTexture> textures_;
};

}  // namespace mjforge::model

#endif  // MJFORGE_MODEL_MODEL_H_
