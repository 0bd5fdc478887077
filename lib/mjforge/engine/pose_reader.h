#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/engine/placed_elements.h"

namespace mjforge::engine {

using Point = std::array<mjtNum, 3>;
using Quaternion = std::array<mjtNum, 4>;  // w first, of length 1

/// A frame in its parent's: what has the coordinates x in it is at pos + quat * x. In m.
struct Pose {
  Point pos = {};
  Quaternion quat = {1, 0, 0, 0};

  Point At(const Point& x) const;
  Point Turned(const Point& direction) const;
  Pose operator*(const Pose& inner) const;
};

/// What says an orientation beside `quat`. The one that is said last counts, and before any `quat`.
inline constexpr std::string_view kOrientations[] = {"axisangle", "xyaxes", "zaxis", "euler"};

/// Reads numbers as MuJoCo does, by the file's `angle` and `eulerseq`. What MuJoCo refuses is an
/// error at its place, once for each.
class PoseReader {
 public:
  PoseReader(const PlacedElements& elements, const diag::Sources& sources,
             diag::Findings& findings);

  /// As many numbers as `usual` has, and those where nothing is said (null).
  template <std::size_t kCount>
  std::optional<std::array<mjtNum, kCount>> Numbers(const XmlElement& element,
                                                    std::string_view attribute,
                                                    const std::string* text,
                                                    std::array<mjtNum, kCount> usual) {
    if (text == nullptr) return usual;
    const std::vector<double> numbers = NumbersOf(*text);
    if (numbers.size() != kCount) {
      Refuse(element, attribute, "must be " + CountText(kCount));
      return std::nullopt;
    }
    std::copy(numbers.begin(), numbers.end(), usual.begin());
    return usual;
  }

  /// What the element says in any word; `quat` may be what a class says.
  std::optional<Quaternion> Orientation(const XmlElement& element, const std::string* quat);
  /// By angles in the file's unit.
  std::optional<Quaternion> FromEuler(const XmlElement& element, Point angles);

  /// An error: "'pos' of body 'lid' must be 3 numbers".
  void Refuse(const XmlElement& element, std::string_view attribute, std::string_view problem);
  /// True at the first call with this element and attribute (copies of an element have its place).
  bool IsNew(const XmlElement& element, std::string_view attribute);

 private:
  static std::string CountText(std::size_t count);
  std::optional<Quaternion> FromWord(const XmlElement& element, std::string_view word);
  std::optional<Quaternion> FromAxes(const XmlElement& element, const std::array<mjtNum, 6>& axes);

  bool in_degrees_;
  std::string sequence_;
  const diag::Sources& sources_;
  diag::Findings& findings_;
  std::set<std::pair<diag::SourceMark, std::string>> told_;
};

}  // namespace mjforge::engine
