#include "mjforge/model/pose_reader.h"

namespace mjforge::model {
namespace {

using diag::Code;
using spec::Key;

// MuJoCo's mjEPS: axes shorter than this are refused there.
constexpr double kShortest = 1e-14;

std::optional<Eigen::Quaterniond> ReadQuat(FieldReader& reader, const spec::Field& field) {
  const auto q = reader.Vector<4>(field);
  if (!q) return std::nullopt;
  if (!(q->stableNorm() > kShortest)) {
    reader.Report(Code::kModelBadRotation, field, "is zero");
    return std::nullopt;
  }
  const Eigen::Vector4d unit = q->stableNormalized();
  return Eigen::Quaterniond(unit(0), unit(1), unit(2), unit(3));
}

std::optional<Eigen::Quaterniond> ReadAxisAngle(FieldReader& reader, const spec::Field& field) {
  const auto numbers = reader.Vector<4>(field);
  if (!numbers) return std::nullopt;
  const Eigen::Vector3d axis = numbers->head<3>();
  if (!(axis.stableNorm() > kShortest)) {
    reader.Report(Code::kModelBadRotation, field, "has an axis of zero length");
    return std::nullopt;
  }
  return FromAxisAngle(axis, (*numbers)(3));
}

std::optional<Eigen::Quaterniond> ReadXyAxes(FieldReader& reader, const spec::Field& field) {
  const auto numbers = reader.Vector<6>(field);
  if (!numbers) return std::nullopt;
  const Eigen::Vector3d x = numbers->head<3>();
  const Eigen::Vector3d y = numbers->tail<3>();
  if (!(x.stableNorm() > kShortest) || !(y.stableNorm() > kShortest)) {
    reader.Report(Code::kModelBadRotation, field, "has an axis of zero length");
    return std::nullopt;
  }
  const double sine = x.stableNormalized().cross(y.stableNormalized()).norm();
  if (!(sine > 1e-10)) {
    reader.Report(Code::kModelBadRotation, field, "has parallel axes");
    return std::nullopt;
  }
  return FromXyAxes(x, y);
}

std::optional<Eigen::Quaterniond> ReadOrientation(FieldReader& reader, const spec::Entry& entry) {
  if (const spec::Field* field = entry.Find(Key::kQuat)) return ReadQuat(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kAxisAngle)) return ReadAxisAngle(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kXyAxes)) return ReadXyAxes(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kEuler)) {
    const auto angles = reader.Vector<3>(*field);
    if (!angles) return std::nullopt;
    return FromEuler(*angles);
  }
  if (const spec::Field* field = entry.Find(Key::kZAxis)) {
    const auto z = ReadDirection(reader, *field);
    if (!z) return std::nullopt;
    return FromZAxis(*z);
  }
  return Eigen::Quaterniond::Identity();
}

}  // namespace

std::optional<Eigen::Vector3d> ReadDirection(FieldReader& reader, const spec::Field& field) {
  const auto direction = reader.Vector<3>(field);
  if (!direction) return std::nullopt;
  if (!(direction->stableNorm() > kShortest)) {
    reader.Report(Code::kModelBadRotation, field, "is zero");
    return std::nullopt;
  }
  return direction->stableNormalized();
}

std::optional<Pose> ReadPose(FieldReader& reader, const spec::Entry& entry) {
  Pose pose;
  bool good = true;
  if (const spec::Field* field = entry.Find(Key::kPos)) {
    const auto pos = reader.Vector<3>(*field);
    if (pos) pose.p = *pos;
    good = pos.has_value();
  }
  const std::optional<Eigen::Quaterniond> q = ReadOrientation(reader, entry);
  if (!good || !q) return std::nullopt;
  pose.q = *q;
  return pose;
}

// As mjCGeom::Compile of MuJoCo 2.2 (src/user/user_objects.cc): z points from
// the second point to the first.
std::optional<Span> ReadFromTo(FieldReader& reader, const spec::Field& field) {
  const auto ends = reader.Vector<6>(field);
  if (!ends) return std::nullopt;
  const Eigen::Vector3d from = ends->head<3>();
  const Eigen::Vector3d to = ends->tail<3>();
  const double length = (from - to).stableNorm();
  if (!(length / 2 > kShortest)) {
    reader.Report(Code::kModelBadValue, field, "has two equal end points");
    return std::nullopt;
  }
  return Span{.pose = {.p = (from + to) / 2, .q = FromZAxis(from - to)}, .half_length = length / 2};
}

}  // namespace mjforge::model
