#pragma once

// What MJCF has won since MuJoCo 2.2.2, up to 4.0: which attribute and element came with which
// release, and what it changes. The facts are those of MuJoCo's schema (mj_printSchema) in each
// release, and of its changelog.

#include <string>
#include <string_view>

namespace mjforge::engine {

/// What is lost where an element or attribute is left out.
enum class Loss {
  kLooks,       // pictures alone
  kSpeed,       // how fast, or how finely, the same is computed; how a file is saved
  kSimulation,  // how the whole model is simulated, not what it consists of
  kReading,     // a sensor, which acts on nothing
  kExpansion,   // MuJoCo expands the element when it compiles the model
  kInclusion,   // the element includes another model, which MuJoCo compiles with this one
  kMeaning,     // the model is another one
};

struct Later {
  /// Tags, blanks between them, each alone ("geom"), after its parent's ("visual/rgba"), or for all
  /// elements of a section ("sensor/*"). "body/" includes the world, frames and replicates. In `<default>` an element counts as in its own section.
  std::string_view where;
  /// Attributes, blanks between them; "name=value": only with this value; empty: the element.
  std::string_view names;
  int since = 0;  // as mjVERSION_HEADER
  Loss loss = Loss::kMeaning;
  /// The value with which an attribute changes nothing.
  std::string_view usual = {};
};

/// The row of an element; null if MuJoCo 2.2.2 has it, or no release.
const Later* FindLater(std::string_view parent, std::string_view tag);
/// The same for its attribute with this value.
const Later* FindLater(std::string_view parent, std::string_view tag, std::string_view attribute,
                       std::string_view value);

/// The section whose elements share defaults with this one: "actuator" for a `<motor>`.
std::string_view SectionOf(std::string_view parent, std::string_view tag);

/// 314 is "3.1.4", 3010000 "3.10.0".
std::string VersionText(int header);

}  // namespace mjforge::engine
