#ifndef MJFORGE_MJCF_MJCF_H_
#define MJFORGE_MJCF_MJCF_H_

// Object -> MJCF text that MuJoCo 2.2 to 3.x load with the same masses.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/targets.h"
#include "mjforge/model/model.h"

namespace mjforge::mjcf {

/// What the opening comment says: enough to make the file again.
struct Provenance {
  std::string version;
  std::string spec;  // as given on the command line
  std::string spec_sha256;
  std::vector<std::pair<std::string, std::string>> settings;  // --set
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  std::string name;  // the object's, where it is not the spec's
  std::string target;
  std::string sampler;      // empty: random
  std::uint64_t batch = 0;  // 0: the variant does not depend on the batch's size
};
/// Reads the comment of a generated file back; nothing if it has none.
std::optional<Provenance> ReadProvenance(std::string_view mjcf);

struct LineOrigin {
  int line = 0;  // 1-based
  diag::SourceMark mark;
};

struct MjcfDocument {
  std::string text;
  std::vector<LineOrigin> origins;  // by line
  /// Byte where a <size> element may be put in; npos where MuJoCo must see the
  /// text as it is (a scene has contacts).
  std::size_t size_position = 0;
  /// Byte where an element of the world may be put in, right before the root body; npos where
  /// the file has a floor of its own.
  std::size_t world_position = 0;
  /// The host gives the root body a free joint, so that the file has none.
  bool host_frees = false;
  double lift = 0;  // m, added to the height of the root body
  /// Files the text refers to: name in the text, file to copy.
  std::vector<std::pair<std::string, std::filesystem::path>> assets;

  /// The place in the spec that produced a line; no place if none did.
  diag::SourceMark Origin(int line) const;
};

/// A visual geom is named as its part, with this after it.
inline constexpr std::string_view kVisualSuffix = "_vis";

/// Object::bodies in the order of the text, which is MuJoCo's: depth first.
std::vector<int> DepthFirst(const model::Object& object);

/// Changes the object into what its target reads: see TargetRules. What the
/// target has no place for is dropped with a warning; what would break there is
/// an error. Comes before WriteMjcf, so that a comparison of the object with
/// what MuJoCo compiles still holds.
void Adapt(model::Object& object, Target target, diag::Findings& findings);

/// Replaces the content of `document`, reusing its memory.
void WriteMjcf(const model::Object& object, Target target, const Provenance& provenance,
               MjcfDocument& document);

}  // namespace mjforge::mjcf

#endif  // MJFORGE_MJCF_MJCF_H_
