// The page of `mjforge customize`: its files, and the answers to its requests.
//
//   customize::Studio studio({.reference = "hammer"});
//   customize::Reply reply = studio.Answer(R"({"action": "draw", "settings": []})");

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/customize/access.h"
#include "mjforge/customize/settings_text.h"
#include "mjforge/spec/spec.h"

namespace mjforge::customize {

/// A file of the page. The files are compiled into the program.
struct PageFile {
  std::string_view name;  // empty for the page itself
  std::string_view type;  // media type
  std::string_view text;
};
std::span<const PageFile> PageFiles();

/// The spec to customize, and the state in which the page begins.
struct Start {
  std::string reference;
  spec::LoadOptions load;
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  std::optional<std::uint64_t> place_seed = {};  // seed of the draws of `place:` in all variants
};

/// Answer to a request of the page.
struct Reply {
  std::string json;     // a JSON object
  std::string picture;  // bytes of a WebP, a PNG or a tar archive; may be empty
  /// Files that the spec was read from; the page repeats its request when one of these files
  /// changes.
  std::vector<std::filesystem::path> files;
};

/// Makes and draws variants for the page. Several pages can send requests in turn, because every
/// request contains the whole state of its page. Keeps the spec, the last variant and the OpenGL
/// context between requests.
class Studio {
 public:
  explicit Studio(Start start);
  ~Studio();

  /// Answers a request, which is one JSON object:
  /// - `action: open` returns the description of the spec, its controls and the first state;
  /// - `action: draw` returns a picture of a variant, its values, facts and findings;
  /// - `action: check` returns the findings, including those of the physics checks;
  /// - `action: film` returns an animation of the simulated drop or, if there is a `name`, of the
  ///   drive of that joint, and its description;
  /// - `action: redraw` returns another random value of the parameter `name`;
  /// - `action: export` returns the variant in a form chosen by `name`: a text for command, params,
  ///   seed and mjcf (a tar archive if the MJCF refers to other files), or a picture for png;
  /// - `action: source` returns the text of the spec's file `name`;
  /// - `action: pick` returns the part at the point `x`, `y` of the picture;
  /// - `action: save` writes the settings to the preset `name`;
  /// - `action: preset` returns the settings of the preset `name`.
  /// An invalid request returns `{"error": "..."}`.
  Reply Answer(std::string_view request);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mjforge::customize
