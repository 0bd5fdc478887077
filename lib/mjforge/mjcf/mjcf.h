// Conversion of an object to MJCF text that MuJoCo 2.2 to 4.0 load with the same masses.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/targets.h"
#include "mjforge/model/model.h"

namespace mjforge::mjcf {

/// Content of the comment at the beginning of a generated file. Together with the spec, it is
/// enough to regenerate the file.
struct Provenance {
  std::string version;
  std::string spec;  // name or path of the spec, as given on the command line
  std::string spec_sha256;
  std::vector<std::pair<std::string, std::string>> settings;  // names and values of --set
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> place_seed;  // --place-seed
  std::uint64_t index = 0;
  std::string name;  // object's name; empty: the name of the spec
  std::string part;  // object of a scene that this file contains (--each); empty: the whole scene
  std::string target;
  std::string assets_as;    // form of assets (kAssetForms); empty: inline
  std::string sampler;      // empty: random
  std::uint64_t batch = 0;  // size of the batch; 0: the variant does not depend on this size
};
/// Reads the opening comment of a generated file; returns nullopt if the file has no such comment
/// or the comment is malformed.
std::optional<Provenance> ReadProvenance(std::string_view mjcf);

/// A line of the MJCF text and the place in the spec that produced it.
struct LineOrigin {
  int line = 0;  // 1-based
  diag::SourceMark mark;

  bool operator==(const LineOrigin&) const = default;
};

/// Form in which meshes and textures are written that are generated, not copied from a file.
enum class AssetForm {
  kInline,  // in the MJCF text
  kFiles    // in OBJ and PNG files beside the text, made by the library `files`
};
inline constexpr std::string_view kAssetForms[] = {"inline", "files"};
constexpr std::span<const std::string_view> WordsOf(AssetForm) { return kAssetForms; }

/// Folder beside an MJCF file that contains all files to which the MJCF file refers.
inline constexpr std::string_view kAssetFolder = "assets/";

/// Returns zero for values below 1e-15 in magnitude, otherwise the value. For lengths in m and
/// components of unit vectors, such small values are rounding errors of rotations and sums.
inline double FlushNoise(double value) { return std::abs(value) < 1e-15 ? 0.0 : value; }

/// A mesh or texture file that is still to be generated from the object. The file's name in the
/// text has bytes::kHashDigits zeros as a placeholder for the hash of the content.
struct GeneratedFile {
  enum class Kind { kMesh, kTexture };
  Kind kind = Kind::kMesh;
  std::size_t index = 0;          // index in Object::meshes or Object::textures
  std::size_t hash_position = 0;  // offset of the placeholder in the text, bytes
};

/// MJCF text with the origins of its lines and the files that it refers to.
struct MjcfDocument {
  std::string text;
  std::vector<LineOrigin> origins;  // sorted by line
  /// Offset, in bytes, at which validation may insert a <size> element with small buffers, which
  /// makes loading faster; npos for a scene, because contacts with the floor need larger buffers.
  std::size_t size_position = 0;
  /// Offset, in bytes, at which a child element of <worldbody> may be inserted, right before the
  /// root body; npos for a scene, which has its own floor.
  std::size_t world_position = 0;
  /// True if the host adds a free joint to the root body; the text then has no such joint.
  bool host_adds_free_joint = false;
  double lift = 0;  // m, added to the height of the children of the world
  /// Existing files that the text refers to.
  bytes::Assets assets;
  /// Files that the text refers to and that do not exist yet.
  std::vector<GeneratedFile> generated_files;

  /// Returns the place in the spec that produced a line (1-based) of the text; an empty mark if
  /// there is none.
  diag::SourceMark Origin(int line) const;
};

/// Suffix of the start keyframe's name, which begins with the object's name.
inline constexpr std::string_view kStartSuffix = "_start";
/// The start state in MuJoCo's order. All vectors are empty if the whole state is MuJoCo's default.
/// Otherwise, qvel, act and ctrl are empty if all their numbers are defaults, and qpos is empty
/// only if the object has no joints.
struct StartState {
  std::vector<double> qpos;
  std::vector<double> qvel;
  std::vector<double> act;
  std::vector<double> ctrl;
};
/// Returns the start state of an object. `lift`, m, is added to the height of free bodies.
StartState StartStateOf(const model::Object& object, double lift);

/// Returns the indices of Object::bodies in depth-first order, the order of bodies in the text and
/// in MuJoCo's models.
std::vector<int> DepthFirstOrder(const model::Object& object);

/// Adapts the object to the program that will load it (TargetRules). Drops elements that this
/// program does not support, with a warning, and reports as errors elements that it cannot load.
/// Makes the object's start its zero configuration if the spec or the program requires this. Must
/// be called before WriteMjcf(). A separate step, because the adapted object is also compared with
/// the compiled model.
void Adapt(model::Object& object, Target target, diag::Findings& findings);

/// Returns the total size of all <mesh> elements of an MJCF text, bytes.
std::size_t MeshBytes(std::string_view text);

/// Returns a <texture> element as text, with the name "texture" and without mark="random", because
/// random marks differ between releases of MuJoCo.
std::string TextureElement(const model::Texture& texture);

/// Writes the object as MJCF; replaces the content of `document`, reusing its memory.
void WriteMjcf(const model::Object& object, Target target, const Provenance& provenance,
               MjcfDocument& document);

}  // namespace mjforge::mjcf
