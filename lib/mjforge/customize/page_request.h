// Request of the page of `mjforge customize`, read from JSON.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/picture/picture.h"
#include "mjforge/spec/spec.h"

namespace mjforge::customize {

/// Name that findings show in place of a file for settings made on the page.
inline constexpr std::string_view kSettingOrigin = "control";

/// Pose of the joints that were not moved on the page.
enum class BasePose {
  kView,   // the start pose, changed by `pose` of the spec's `view:`
  kStart,  // the start pose
  kZero    // all joints at zero
};
inline constexpr std::string_view kBasePoses[] = {"view", "start", "zero"};
constexpr std::span<const std::string_view> WordsOf(BasePose) { return kBasePoses; }

struct Request {
  std::string action;
  std::string name;            // name of a parameter, joint, preset, file or form of export
  std::uint64_t revision = 0;  // number of changes of the spec's files that the page has seen
  std::vector<spec::Setting> settings;
  // Indices of those elements of `settings` whose `text` is a plain text, not YAML.
  // VariantCache::QuoteTexts() converts these texts to YAML.
  std::vector<std::size_t> values = {};
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  std::uint64_t count = 1;  // number of variants that an exported command makes
  bool nine = false;        // true: the picture shows nine variants, from `index` on
  BasePose pose = BasePose::kView;
  std::vector<std::pair<std::string, double>> joints;  // moved joints, positions in rad or m
  double x = 0.5;  // point in the picture: from 0 (left, top) to 1 (right, bottom)
  double y = 0.5;
  picture::Options picture = {.width = 640, .height = 480};
};

/// Reads a request; members that are missing keep their defaults. Returns nullopt, and sets
/// `why_not` to the reason, if the text is not a JSON object or a member has a wrong type or is out
/// of range. Seed, index, count and revision are texts of digits, because JavaScript represents
/// only whole numbers up to 2^53 exactly.
std::optional<Request> ReadRequest(std::string_view json, std::string& why_not);

}  // namespace mjforge::customize
