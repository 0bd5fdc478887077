// Readers of positions, of the five orientations of MJCF, of `fromto` and of directions.

#include "mjforge/assemble/pose_reader.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;
using spec::Key;

// MuJoCo's mjEPS: MuJoCo rejects axes that are not longer than this.
constexpr double kShortest = 1e-14;

bool HasLength(const Eigen::Ref<const Eigen::VectorXd>& vector) {
  return vector.stableNorm() > kShortest;
}

std::nullopt_t Refuse(FieldReader& reader, Code code, const spec::Field& field,
                      std::string_view what) {
  reader.Report(code, field, what);
  return std::nullopt;
}

std::optional<Quaterniond> ReadQuat(FieldReader& reader, const spec::Field& field) {
  const auto q = reader.Vector<4>(field);
  if (!q) return std::nullopt;
  if (!HasLength(*q)) return Refuse(reader, Code::kModelBadRotation, field, "is zero");
  const Vector4d unit = q->stableNormalized();
  return Quaterniond(unit(0), unit(1), unit(2), unit(3));
}

std::optional<Quaterniond> ReadAxisAngle(FieldReader& reader, const spec::Field& field) {
  const auto numbers = reader.Vector<4>(field);
  if (!numbers) return std::nullopt;
  const Vector3d axis = numbers->head<3>();
  if (!HasLength(axis))
    return Refuse(reader, Code::kModelBadRotation, field, "has an axis of zero length");
  return model::FromAxisAngle(axis, (*numbers)[3]);
}

std::optional<Quaterniond> ReadXyAxes(FieldReader& reader, const spec::Field& field) {
  const auto numbers = reader.Vector<6>(field);
  if (!numbers) return std::nullopt;
  const Vector3d x = numbers->head<3>();
  const Vector3d y = numbers->tail<3>();
  if (!HasLength(x) || !HasLength(y))
    return Refuse(reader, Code::kModelBadRotation, field, "has an axis of zero length");
  if (!(x.stableNormalized().cross(y.stableNormalized()).norm() > 1e-10))
    return Refuse(reader, Code::kModelBadRotation, field, "has parallel axes");
  return model::FromXyAxes(x, y);
}

std::optional<Quaterniond> ReadOrientation(FieldReader& reader, const spec::Entry& entry) {
  if (const spec::Field* field = entry.Find(Key::kQuat)) return ReadQuat(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kAxisAngle)) return ReadAxisAngle(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kXyAxes)) return ReadXyAxes(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kEuler)) {
    const auto angles = reader.Vector<3>(*field);
    if (!angles) return std::nullopt;
    return model::FromEuler(*angles);
  }
  if (const spec::Field* field = entry.Find(Key::kZAxis)) {
    const auto z = ReadDirection(reader, *field);
    if (!z) return std::nullopt;
    return model::FromZAxis(*z);
  }
  return Quaterniond::Identity();
}

}  // namespace

std::optional<Vector3d> ReadDirection(FieldReader& reader, const spec::Field& field) {
  const auto direction = reader.Vector<3>(field);
  if (!direction) return std::nullopt;
  if (!HasLength(*direction)) return Refuse(reader, Code::kModelBadRotation, field, "is zero");
  return direction->stableNormalized();
}

std::optional<model::Pose> ReadPose(FieldReader& reader, const spec::Entry& entry) {
  model::Pose pose;
  const bool good = reader.ReadOptional(entry, Key::kPos, &FieldReader::Vector<3>, pose.p);
  const std::optional<Quaterniond> q = ReadOrientation(reader, entry);
  if (!good || !q) return std::nullopt;
  pose.q = *q;
  return pose;
}

// Reads the two points of `fromto`. The z axis points from the second point to the first, as in
// mjCGeom::Compile of MuJoCo 2.2 (src/user/user_objects.cc).
std::optional<Segment> ReadFromTo(FieldReader& reader, const spec::Field& field,
                                  const spec::Field* up_field) {
  const auto ends = reader.Vector<6>(field);
  if (!ends) return std::nullopt;
  const Vector3d from = ends->head<3>();
  const Vector3d to = ends->tail<3>();
  const double half = (from - to).stableNorm() / 2;
  if (!(half > kShortest))
    return Refuse(reader, Code::kModelBadValue, field, "has two equal end points");
  Segment segment = {.pose = {.p = (from + to) / 2}, .half_length = half};
  if (up_field == nullptr) {
    segment.pose.q = model::FromZAxis(from - to);
    return segment;
  }
  const std::optional<Vector3d> up = ReadDirection(reader, *up_field);
  if (!up) return std::nullopt;
  const Vector3d z = (from - to).stableNormalized();
  if (!(z.cross(*up).norm() > 1e-10))
    return Refuse(reader, Code::kModelBadRotation, *up_field, "is along `fromto`");
  const Vector3d x = up->cross(z);
  segment.pose.q = model::FromXyAxes(x, z.cross(x));
  return segment;
}

}  // namespace mjforge::assemble
