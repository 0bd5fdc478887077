#pragma once

// Object -> MJCF text that MuJoCo 2.2 to 3.x load with the same masses.

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

/// The content of the opening comment: enough to regenerate the file.
struct Provenance {
  std::string version;
  std::string spec;  // as given on the command line
  std::string spec_sha256;
  std::vector<std::pair<std::string, std::string>> settings;  // --set
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  std::string name;  // the object's, where it is not the spec's
  std::string target;
  std::string assets_as;    // empty: inline
  std::string sampler;      // empty: random
  std::uint64_t batch = 0;  // 0: the variant does not depend on the batch's size
};
/// Reads the comment of a generated file back; nothing if it has none.
std::optional<Provenance> ReadProvenance(std::string_view mjcf);

struct LineOrigin {
  int line = 0;  // 1-based
  diag::SourceMark mark;

  bool operator==(const LineOrigin&) const = default;
};

/// How meshes and textures that no file has are written.
enum class AssetForm {
  kInline,  // into the text
  kFiles    // beside it, as OBJ and PNG: the room files makes them
};
inline constexpr std::string_view kAssetForms[] = {"inline", "files"};
constexpr std::span<const std::string_view> WordsOf(AssetForm) { return kAssetForms; }

/// A file that is made from the object. Its name in the text has as many zeros where its content's
/// hash belongs.
inline constexpr std::size_t kHashDigits = 16;
struct MadeFile {
  enum class Kind { kMesh, kTexture };
  Kind kind = Kind::kMesh;
  std::size_t number = 0;  // in Object::meshes or Object::textures
  std::size_t hash = 0;    // byte of the text
};

struct MjcfDocument {
  std::string text;
  std::vector<LineOrigin> origins;  // by line
  /// Byte where a <size> element may be inserted; npos if MuJoCo must get the text unchanged (a
  /// scene has contacts).
  std::size_t size_position = 0;
  /// Byte where an element of the world may be inserted, right before the root body; npos if the
  /// file has its own floor.
  std::size_t world_position = 0;
  /// The host gives the root body a free joint, so the file has none.
  bool host_frees = false;
  double lift = 0;  // m, added to the height of the root body
  /// Files the text refers to.
  bytes::Assets assets;
  /// Others, which are still to be made.
  std::vector<MadeFile> made_files;

  /// The place in the spec that produced a line; no place if none did.
  diag::SourceMark Origin(int line) const;
};

/// The name of the keyframe is the object's with this suffix.
inline constexpr std::string_view kStartSuffix = "_start";
/// qpos of the joints at the start, in MuJoCo's order; empty if none has a position of its own.
/// `lift`, m, is added to the height of bodies of the world.
std::vector<double> StartPositions(const model::Object& object, double lift);

/// Object::bodies in the order of the text, which is MuJoCo's: depth first.
std::vector<int> DepthFirst(const model::Object& object);

/// Adapts the object to its target: see TargetRules. What the target does not support is dropped
/// with a warning; what would break there is an error. Must be called before WriteMjcf, so that the
/// object can still be compared with what MuJoCo compiles.
void Adapt(model::Object& object, Target target, diag::Findings& findings);

/// Bytes of the text's <mesh> elements: what shapes cost.
std::size_t MeshBytes(std::string_view text);

/// A texture as an element of MJCF on its own, without random marks: these differ between MuJoCo's
/// releases.
std::string TextureElement(const model::Texture& texture);

/// Replaces the content of `document`, reusing its memory.
void WriteMjcf(const model::Object& object, Target target, const Provenance& provenance,
               MjcfDocument& document);

}  // namespace mjforge::mjcf
