#include "mjforge/engine/pose_reader.h"

#include <fmt/format.h>

#include "mjforge/engine/adapt.h"

namespace mjforge::engine {
namespace {

constexpr std::string_view kNoDirection = "has no direction";

/// Makes its length 1; false if it has none.
bool Normalize(Point& direction) { return mju_normalize3(direction.data()) > mjMINVAL; }

}  // namespace

Point Pose::Turned(const Point& direction) const {
  Point turned;
  mju_rotVecQuat(turned.data(), direction.data(), quat.data());
  return turned;
}

Point Pose::At(const Point& x) const {
  Point at = Turned(x);
  mju_addTo3(at.data(), pos.data());
  return at;
}

Pose Pose::operator*(const Pose& inner) const {
  Pose product;
  product.pos = At(inner.pos);
  mju_mulQuat(product.quat.data(), quat.data(), inner.quat.data());
  mju_normalize4(product.quat.data());
  return product;
}

PoseReader::PoseReader(const PlacedElements& elements, const diag::Sources& sources,
                       diag::Findings& findings)
    : in_degrees_(elements.Setting("angle", "degree") != "radian"),
      sequence_(elements.Setting("eulerseq", "xyz")),
      sources_(sources),
      findings_(findings) {}

std::optional<Quaternion> PoseReader::Orientation(const XmlElement& element,
                                                  const std::string* quat) {
  std::string_view word;
  for (const std::string_view name : kOrientations) {
    if (element.Find(name) == nullptr) continue;
    if (!word.empty() || element.Find("quat") != nullptr) {
      Refuse(element, name, "is a second orientation");
      return std::nullopt;
    }
    word = name;
  }
  if (!word.empty()) return FromWord(element, word);
  auto read = Numbers<4>(element, "quat", quat, {1, 0, 0, 0});
  if (read && mju_normalize4(read->data()) < mjMINVAL) {
    Refuse(element, "quat", "must not be zero");
    return std::nullopt;
  }
  return read;
}

std::optional<Quaternion> PoseReader::FromWord(const XmlElement& element, std::string_view word) {
  const std::string* text = element.Find(word);
  if (word == "euler") {
    const auto angles = Numbers<3>(element, word, text, {});
    return angles ? FromEuler(element, *angles) : std::nullopt;
  }
  if (word == "xyaxes") {
    const auto axes = Numbers<6>(element, word, text, {});
    return axes ? FromAxes(element, *axes) : std::nullopt;
  }
  Quaternion quat;
  Point axis = {};
  if (word == "axisangle") {
    const auto read = Numbers<4>(element, word, text, {});
    if (!read) return std::nullopt;
    axis = {(*read)[0], (*read)[1], (*read)[2]};
    const bool good = Normalize(axis);
    mju_axisAngle2Quat(quat.data(), axis.data(), (*read)[3] * (in_degrees_ ? mjPI / 180 : 1));
    if (good) return quat;
  } else if (const auto read = Numbers<3>(element, word, text, {})) {
    axis = *read;
    const bool good = Normalize(axis);
    mju_quatZ2Vec(quat.data(), axis.data());
    if (good) return quat;
  } else {
    return std::nullopt;
  }
  Refuse(element, word, kNoDirection);
  return std::nullopt;
}

// The y axis is made perpendicular to the x axis.
std::optional<Quaternion> PoseReader::FromAxes(const XmlElement& element,
                                               const std::array<mjtNum, 6>& axes) {
  Point x = {axes[0], axes[1], axes[2]};
  Point y = {axes[3], axes[4], axes[5]};
  const bool good = Normalize(x);
  mju_addToScl3(y.data(), x.data(), -mju_dot3(x.data(), y.data()));
  if (!good || !Normalize(y)) {
    Refuse(element, "xyaxes", kNoDirection);
    return std::nullopt;
  }
  Point z;
  mju_cross(z.data(), x.data(), y.data());
  const std::array<mjtNum, 9> columns = {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
  Quaternion quat;
  mju_mat2Quat(quat.data(), columns.data());
  mju_normalize4(quat.data());
  return quat;
}

// Small letters are axes that turn along, capital ones stay.
std::optional<Quaternion> PoseReader::FromEuler(const XmlElement& element, Point angles) {
  Quaternion quat = {1, 0, 0, 0};
  constexpr std::string_view kAxes = "xyzXYZ";
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t letter = i < sequence_.size() ? kAxes.find(sequence_[i]) : kAxes.npos;
    if (letter == kAxes.npos) {
      Refuse(element, "euler", fmt::format("cannot be read with eulerseq '{}'", sequence_));
      return std::nullopt;
    }
    Point axis = {};
    axis[letter % 3] = 1;
    Quaternion turn;
    mju_axisAngle2Quat(turn.data(), axis.data(), angles[i] * (in_degrees_ ? mjPI / 180 : 1));
    const Quaternion before = quat;
    const bool turns_along = letter < 3;
    mju_mulQuat(quat.data(), turns_along ? before.data() : turn.data(),
                turns_along ? turn.data() : before.data());
  }
  mju_normalize4(quat.data());
  return quat;
}

void PoseReader::Refuse(const XmlElement& element, std::string_view attribute,
                        std::string_view problem) {
  if (!IsNew(element, attribute)) return;
  findings_.Add(diag::Code::kMujocoError, MarkOfAttribute(sources_, element, attribute),
                fmt::format("'{}' of {} {}", attribute, element.Description(), problem));
}

bool PoseReader::IsNew(const XmlElement& element, std::string_view attribute) {
  return told_.emplace(element.mark, attribute).second;
}

std::string PoseReader::CountText(std::size_t count) {
  return fmt::format("{} number{}", count, count == 1 ? "" : "s");
}

}  // namespace mjforge::engine
