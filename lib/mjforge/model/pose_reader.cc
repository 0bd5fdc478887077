#include "mjforge/model/pose_reader.h"

namespace mjforge::model {
namespace {

using diag::Code;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;
using spec::Key;
using Rotation = Traced<Quaterniond>;
using SixNumbers = Traced<Eigen::Matrix<double, 6, 1>>;

// MuJoCo's mjEPS: axes shorter than this are refused there.
constexpr double kShortest = 1e-14;

Traced<Vector3d> FirstOf(const SixNumbers& numbers) {
  return tape::Apply([](const auto& six) { return Vector3d(six.template head<3>()); }, numbers);
}

Traced<Vector3d> SecondOf(const SixNumbers& numbers) {
  return tape::Apply([](const auto& six) { return Vector3d(six.template tail<3>()); }, numbers);
}

template <int N>
bool HasLength(const Traced<Eigen::Matrix<double, N, 1>>& vector) {
  return tape::Test([](const auto& v) { return v.stableNorm() > kShortest; }, vector);
}

std::optional<Rotation> ReadQuat(FieldReader& reader, const spec::Field& field) {
  const auto q = reader.Vector<4>(field);
  if (!q) return std::nullopt;
  if (!HasLength(*q)) {
    reader.Report(Code::kModelBadRotation, field, "is zero");
    return std::nullopt;
  }
  const auto rotation = [](const Vector4d& wxyz) {
    const Vector4d unit = wxyz.stableNormalized();
    return Quaterniond(unit(0), unit(1), unit(2), unit(3));
  };
  return tape::Apply(rotation, *q);
}

std::optional<Rotation> ReadAxisAngle(FieldReader& reader, const spec::Field& field) {
  const auto numbers = reader.Vector<4>(field);
  if (!numbers) return std::nullopt;
  const auto axis = tape::Apply([](const Vector4d& v) { return Vector3d(v.head<3>()); }, *numbers);
  if (!HasLength(axis)) {
    reader.Report(Code::kModelBadRotation, field, "has an axis of zero length");
    return std::nullopt;
  }
  return tape::Apply(FromAxisAngle, axis, tape::Element(*numbers, 3));
}

std::optional<Rotation> ReadXyAxes(FieldReader& reader, const spec::Field& field) {
  const auto numbers = reader.Vector<6>(field);
  if (!numbers) return std::nullopt;
  const Traced<Vector3d> x = FirstOf(*numbers);
  const Traced<Vector3d> y = SecondOf(*numbers);
  if (!HasLength(x) || !HasLength(y)) {
    reader.Report(Code::kModelBadRotation, field, "has an axis of zero length");
    return std::nullopt;
  }
  const auto crosses = [](const Vector3d& a, const Vector3d& b) {
    return a.stableNormalized().cross(b.stableNormalized()).norm() > 1e-10;
  };
  if (!tape::Test(crosses, x, y)) {
    reader.Report(Code::kModelBadRotation, field, "has parallel axes");
    return std::nullopt;
  }
  return tape::Apply(FromXyAxes, x, y);
}

std::optional<Rotation> ReadOrientation(FieldReader& reader, const spec::Entry& entry) {
  if (const spec::Field* field = entry.Find(Key::kQuat)) return ReadQuat(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kAxisAngle)) return ReadAxisAngle(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kXyAxes)) return ReadXyAxes(reader, *field);
  if (const spec::Field* field = entry.Find(Key::kEuler)) {
    const auto angles = reader.Vector<3>(*field);
    if (!angles) return std::nullopt;
    return tape::Apply(FromEuler, *angles);
  }
  if (const spec::Field* field = entry.Find(Key::kZAxis)) {
    const auto z = ReadDirection(reader, *field);
    if (!z) return std::nullopt;
    return tape::Apply(FromZAxis, *z);
  }
  return Rotation(Quaterniond::Identity());
}

}  // namespace

std::optional<Traced<Vector3d>> ReadDirection(FieldReader& reader, const spec::Field& field) {
  const auto direction = reader.Vector<3>(field);
  if (!direction) return std::nullopt;
  if (!HasLength(*direction)) {
    reader.Report(Code::kModelBadRotation, field, "is zero");
    return std::nullopt;
  }
  return tape::Apply([](const Vector3d& v) { return v.stableNormalized(); }, *direction);
}

std::optional<Pose> ReadPose(FieldReader& reader, const spec::Entry& entry) {
  Pose pose;
  bool good = true;
  if (const spec::Field* field = entry.Find(Key::kPos)) {
    const auto pos = reader.Vector<3>(*field);
    if (pos) pose.p = *pos;
    good = pos.has_value();
  }
  const std::optional<Rotation> q = ReadOrientation(reader, entry);
  if (!good || !q) return std::nullopt;
  pose.q = *q;
  return pose;
}

// As mjCGeom::Compile of MuJoCo 2.2 (src/user/user_objects.cc): z points from
// the second point to the first.
std::optional<Span> ReadFromTo(FieldReader& reader, const spec::Field& field,
                               const spec::Field* up_field) {
  const auto ends = reader.Vector<6>(field);
  if (!ends) return std::nullopt;
  const Traced<Vector3d> from = FirstOf(*ends);
  const Traced<Vector3d> to = SecondOf(*ends);
  const auto half_length = [](const Vector3d& a, const Vector3d& b) {
    return (a - b).stableNorm() / 2;
  };
  const Traced<double> half = tape::Apply(half_length, from, to);
  if (!(half > kShortest)) {
    reader.Report(Code::kModelBadValue, field, "has two equal end points");
    return std::nullopt;
  }
  const auto middle = [](const Vector3d& a, const Vector3d& b) { return Vector3d((a + b) / 2); };
  Span span = {.pose = {.p = tape::Apply(middle, from, to)}, .half_length = half};
  if (up_field == nullptr) {
    const auto along = [](const Vector3d& a, const Vector3d& b) { return FromZAxis(a - b); };
    span.pose.q = tape::Apply(along, from, to);
    return span;
  }
  const std::optional<Traced<Vector3d>> up = ReadDirection(reader, *up_field);
  if (!up) return std::nullopt;
  const auto crosses = [](const Vector3d& a, const Vector3d& b, const Vector3d& u) {
    return (a - b).stableNormalized().cross(u).norm() > 1e-10;
  };
  if (!tape::Test(crosses, from, to, *up)) {
    reader.Report(Code::kModelBadRotation, *up_field, "is along `fromto`");
    return std::nullopt;
  }
  const auto rolled = [](const Vector3d& a, const Vector3d& b, const Vector3d& u) {
    const Vector3d z = (a - b).stableNormalized();
    const Vector3d x = u.cross(z);
    return FromXyAxes(x, z.cross(x));
  };
  span.pose.q = tape::Apply(rolled, from, to, *up);
  return span;
}

}  // namespace mjforge::model
