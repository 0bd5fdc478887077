// Table of attributes and values that later MuJoCo releases reject, and warnings about them.
#include "mjforge/backport/refused_attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "mjforge/backport/mjcf_versions.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {
namespace {

/// Values that later releases accept; kUpToTwo stands for the integers from 0 to 2, kNonzero for
/// lists of numbers with one that is not 0, kMain for the text "main".
enum class Accepted { kNone, kInteger, kAtLeastMinusOne, kUpToTwo, kPositive, kNonzero, kMain };

struct Row {
  std::string_view where;  // in the form of MjcfFeature::where
  std::string_view names;  // in the form of MjcfFeature::names
  int since = 0;
  Accepted accepted = Accepted::kNone;
};

constexpr Row kRows[] = {
    {"lengthrange", "inteval", 233},
    {"compiler", "coordinate=global", 234},
    {"compiler", "convexhull exactmeshinertia", 325},
    {"composite", "type=rope type=cloth", 300},
    {"composite", "type=box type=cylinder type=ellipsoid", 325},
    {"composite", "type=loop", 326},
    {"composite", "type=particle type=grid", 330},
    {"option", "collision", 300},
    {"option", "mpr_iterations mpr_tolerance", 323},
    {"option", "apirate", 337},
    {"flag", "sensornoise", 314},
    {"flag", "passive", 336},
    {"sensor/*", "reftype=none reftype=unknown", 3012000},
    {"mujoco/size", "nconmax", 230, Accepted::kAtLeastMinusOne},
    {"mujoco/size", "njmax nstack", 3012000, Accepted::kAtLeastMinusOne},
    {"visual/map", "znear", 230, Accepted::kPositive},
    {"mujoco/statistic", "extent", 230, Accepted::kPositive},
    {"visual/headlight", "active", 4000000, Accepted::kUpToTwo},
    {"body/body body/inertial body/geom body/site body/camera default/geom default/site "
     "default/camera",
     "quat", 300, Accepted::kNonzero},
    {"mujoco/default", "class", 320, Accepted::kMain},
    // MuJoCo 3.0 and later require integers in the following attributes; 2.2 rounds numbers, and
    // ignores further numbers.
    {"option", "iterations noslip_iterations", 300, Accepted::kInteger},
    {"mujoco/size",
     "njmax nconmax nstack nuserdata nkey nuser_body nuser_jnt nuser_geom nuser_site nuser_cam "
     "nuser_tendon nuser_actuator nuser_sensor",
     300, Accepted::kInteger},
    {"visual/global", "offwidth offheight", 300, Accepted::kInteger},
    {"visual/quality", "shadowsize offsamples numslices numstacks numquads", 300,
     Accepted::kInteger},
    {"visual/headlight", "active", 300, Accepted::kInteger},
    {"custom/numeric", "size", 300, Accepted::kInteger},
    {"contact/pair default/pair", "condim", 300, Accepted::kInteger},
    {"body/geom default/geom", "group condim priority contype conaffinity", 300,
     Accepted::kInteger},
    {"body/joint default/joint body/freejoint body/site default/site tendon/* actuator/*", "group",
     300, Accepted::kInteger},
};

bool IsAccepted(Accepted accepted, std::string_view value) {
  const std::vector<double> numbers = xml::NumbersOf(value);
  const bool is_integer = numbers.size() == 1 && numbers[0] == std::round(numbers[0]) &&
                          std::abs(numbers[0]) <= std::numeric_limits<int>::max();
  switch (accepted) {
    case Accepted::kNone:
      return false;
    case Accepted::kInteger:
      return is_integer;
    case Accepted::kAtLeastMinusOne:
      return is_integer && numbers[0] >= -1;
    case Accepted::kUpToTwo:
      return is_integer && numbers[0] >= 0 && numbers[0] <= 2;
    case Accepted::kPositive:
      return std::ranges::all_of(numbers, [](double number) { return number > 0; });
    case Accepted::kNonzero:
      return std::ranges::any_of(numbers, [](double number) { return number != 0; });
    case Accepted::kMain:
      return value == "main";
  }
  return true;
}

// Accepted values, for messages, in the order of Accepted. For kUpToTwo, 2 is left out, because it
// has no meaning.
constexpr std::string_view kWanted[] = {"",
                                        "an integer",
                                        "an integer of at least -1",
                                        "0 or 1",
                                        "a number above 0",
                                        "a quaternion other than zero",
                                        "the name 'main'"};
static_assert(std::size(kWanted) == static_cast<std::size_t>(Accepted::kMain) + 1);

}  // namespace

std::optional<std::string> FindRefusal(std::string_view parent, std::string_view tag,
                                       std::string_view attribute, std::string_view value,
                                       int version) {
  const Row* found = nullptr;
  for (const Row& row : kRows) {
    if (row.since <= version || (found != nullptr && found->since <= row.since)) continue;
    if (!HasAttribute(row.names, attribute, value) || !IsAt(row.where, parent, tag)) continue;
    if (!IsAccepted(row.accepted, value)) found = &row;
  }
  if (found == nullptr) return std::nullopt;
  const std::string release = VersionText(found->since);
  if (found->accepted != Accepted::kNone) {
    return fmt::format("has '{}={}'; MuJoCo {} and later require {}", attribute, value, release,
                       kWanted[static_cast<std::size_t>(found->accepted)]);
  }
  const bool is_about_value = found->names.find('=') != std::string_view::npos;
  return fmt::format("has '{}{}', which MuJoCo {} and later reject", attribute,
                     is_about_value ? fmt::format("={}", value) : "", release);
}

}  // namespace mjforge::backport
