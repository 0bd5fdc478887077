// Names of the layers of a picture, and drawing of the marks (boxes, axes, labels) of the layers
// bounds, inertia, joints and regions.

#include "mjforge/picture/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/picture/subject.h"

namespace mjforge::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Color = std::array<float, 4>;

constexpr std::array<std::string_view, 6> kLayers = {"visual",  "collision", "bounds",
                                                     "inertia", "joints",    "regions"};

constexpr Color kBox = {0.10F, 0.28F, 0.62F, 1};
constexpr Color kDisk = {0.95F, 0.55F, 0.10F, 0.35F};
constexpr Color kMark = {0.80F, 0.10F, 0.15F, 1};
constexpr Color kInertia = {0.20F, 0.45F, 0.80F, 0.45F};

const Matrix3d kUpright = Matrix3d::Identity();

// Returns half the diagonal of the bounding box, m. Sizes of marks are multiples of this length.
double RadiusOf(const PlacedShapes& shapes) { return (shapes.Max() - shapes.Min()).norm() / 2; }

// Returns a rotation that maps z to `axis`.
Matrix3d RotationTo(const Vector3d& axis) {
  return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
}

void AddRod(const Vector3d& from, const Vector3d& to, double radius, const Color& color,
            Scene& scene) {
  const Vector3d along = to - from;
  if (along.norm() <= 0) return;
  scene.Add(mjGEOM_CAPSULE, {radius, radius, along.norm() / 2}, (from + to) / 2,
            RotationTo(along.normalized()), color);
}

void AddBall(const Vector3d& at, double radius, const Color& color, Scene& scene) {
  scene.Add(mjGEOM_SPHERE, {radius, radius, radius}, at, kUpright, color);
}

// Draws the edges of an axis-aligned box as capsules with this radius, m.
void DrawEdges(const Vector3d& min, const Vector3d& max, double radius, Scene& scene) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      Vector3d from = min;
      from[(axis + 1) % 3] = (corner % 2 == 0 ? min : max)[(axis + 1) % 3];
      from[(axis + 2) % 3] = (corner / 2 == 0 ? min : max)[(axis + 2) % 3];
      Vector3d to = from;
      to[axis] = max[axis];
      AddRod(from, to, radius, kBox, scene);
    }
  }
}

// Returns the color of the mark with this number. Marks with nearby numbers have different colors.
Color MarkColor(int number) {
  constexpr std::array<Color, 6> kColors = {
      Color{0.85F, 0.20F, 0.15F, 1}, Color{0.10F, 0.45F, 0.85F, 1}, Color{0.10F, 0.60F, 0.30F, 1},
      Color{0.75F, 0.45F, 0.05F, 1}, Color{0.55F, 0.20F, 0.70F, 1}, Color{0.05F, 0.55F, 0.60F, 1}};
  return kColors[static_cast<std::size_t>(number) % kColors.size()];
}

// Draws the marks of one joint.
struct JointMark {
  const mjModel& m;
  const mjData& d;
  int joint;
  double radius;  // half the diagonal of the object's bounding box, m
  Scene& scene;

  std::string Name() const { return m.names + m.name_jntadr[joint]; }
  Vector3d Anchor() const { return compiled::VectorAt(d.xanchor, joint); }
  Vector3d Axis() const { return compiled::VectorAt(d.xaxis, joint).normalized(); }
  bool Limited() const { return m.jnt_limited[joint] != 0; }
  double Value() const { return d.qpos[m.jnt_qposadr[joint]]; }
  double End(int i) const { return m.jnt_range[2 * joint + i]; }
  double Thickness() const { return 0.012 * radius; }

  // Puts the joint's number at `place`, and explains the number in the legend below the picture.
  void Label(const Vector3d& place, std::string_view range) const {
    const std::size_t number = scene.legend().size() + 1;
    scene.AddLabel(place, fmt::format("{}", number));
    scene.AddToLegend(fmt::format("{} {}: {}", number, Name(), range), MarkColor(joint));
  }

  void Arrow(const Vector3d& from, const Vector3d& to) const {
    const Color color = MarkColor(joint);
    const Vector3d along = (to - from).normalized();
    AddRod(from, to, Thickness(), color, scene);
    const double head = 4 * Thickness();
    scene.Add(mjGEOM_ARROW1, {2.2 * Thickness(), 2.2 * Thickness(), 3 * head}, to - head * along,
              RotationTo(along), color);
    scene.AddToFrame({.p_WS = to + head * along});
  }

  // Draws the axis of a hinge, and the arc on which its body's centre of mass moves over the range.
  void DrawHinge() const {
    const Color color = MarkColor(joint);
    const Vector3d axis = Axis();
    const Vector3d anchor = Anchor();
    Arrow(anchor - 0.3 * radius * axis, anchor + 0.45 * radius * axis);
    Vector3d arm = compiled::VectorAt(d.xipos, m.jnt_bodyid[joint]) - anchor;
    arm -= arm.dot(axis) * axis;
    if (arm.norm() < 0.02 * radius) arm = axis.unitOrthogonal();
    arm = arm.normalized() * std::clamp(arm.norm() * 1.3, 0.25 * radius, 0.7 * radius);
    const double from = Limited() ? End(0) - Value() : -std::numbers::pi;
    const double to = Limited() ? End(1) - Value() : std::numbers::pi;
    constexpr int kSegments = 36;
    const auto at = [&](int i) -> Vector3d {
      return anchor + Eigen::AngleAxisd(from + (to - from) * i / kSegments, axis) * arm;
    };
    for (int i = 0; i < kSegments; ++i) {
      AddRod(at(i), at(i + 1), 0.7 * Thickness(), color, scene);
      scene.AddToFrame({.p_WS = at(i)});
    }
    AddBall(anchor + arm, 2 * Thickness(), color, scene);
    const std::string range =
        Limited() ? fmt::format("{:.3g} to {:.3g} deg", End(0) * 180 / std::numbers::pi,
                                End(1) * 180 / std::numbers::pi)
                  : "unlimited";
    const double higher = axis.z() < 0 ? -0.3 : 0.45;
    Label(anchor + higher * radius * axis, range);
  }

  void DrawSlide() const {
    const Vector3d axis = Axis();
    const Vector3d anchor = compiled::VectorAt(d.xipos, m.jnt_bodyid[joint]);
    const double from = Limited() ? End(0) - Value() : -0.4 * radius;
    const double to = Limited() ? End(1) - Value() : 0.4 * radius;
    Arrow(anchor + from * axis, anchor + to * axis);
    AddBall(anchor, 2.2 * Thickness(), MarkColor(joint), scene);
    const std::string range =
        Limited() ? fmt::format("{:.4g} to {:.4g} m", End(0), End(1)) : "unlimited";
    Label(anchor + to * axis, range);
  }

  void DrawBallJoint() const {
    AddBall(Anchor(), 0.06 * radius, MarkColor(joint), scene);
    Label(Anchor(), Limited() ? fmt::format("ball, to {:.3g} deg", End(1) * 180 / std::numbers::pi)
                              : "ball, unlimited");
  }
};

}  // namespace

std::span<const std::string_view> LayerNames() { return kLayers; }

std::optional<Layer> ParseLayer(std::string_view name) {
  const auto* found = std::find(kLayers.begin(), kLayers.end(), name);
  if (found == kLayers.end()) return std::nullopt;
  return static_cast<Layer>(found - kLayers.begin());
}

void DrawBounds(const Subject::State& state, const PlacedShapes& around, Scene& scene) {
  const mjModel& m = *state.model;
  const Vector3d min = around.Min();
  const Vector3d max = around.Max();
  const Vector3d root = m.nbody > 1 ? compiled::VectorAt(state.data->xpos, 1) : Vector3d::Zero();
  const double radius = RadiusOf(around);
  const double reach = around.HorizontalRadius(root);
  const double thin = 0.004 * radius;
  DrawEdges(min, max, thin, scene);
  const Vector3d foot(root.x(), root.y(), min.z());
  const Vector3d head(root.x(), root.y(), max.z());
  scene.Add(mjGEOM_CYLINDER, {reach, reach, thin}, foot + Vector3d(0, 0, 2 * thin), kUpright,
            kDisk);
  AddRod(foot, head, 1.5 * thin, kMark, scene);
  AddBall(root, 8 * thin, kMark, scene);
  scene.AddToFrame(
      {.solid = {model::GeomType::kBox, Vector3d((max - min) / 2)}, .p_WS = (min + max) / 2});
  scene.AddToFrame({.solid = {model::GeomType::kCylinder, Vector3d(reach, thin, 0)}, .p_WS = foot});
  const Vector3d size = max - min;
  scene.AddLabel(head, fmt::format("top {:.4g} m", max.z() - root.z()));
  scene.AddLabel(foot, fmt::format("bottom {:.4g} m", min.z() - root.z()));
  scene.AddLabel(foot + Vector3d(reach, 0, 0), fmt::format("radius {:.4g} m", reach));
  scene.AddLabel({max.x(), min.y(), (min.z() + max.z()) / 2},
                 fmt::format("{:.4g} x {:.4g} x {:.4g} m", size.x(), size.y(), size.z()));
}

// Draws, for each body, a box of equal mass and inertia. A solid box of mass m and half sizes a, b,
// c has the moments I_x = m/3 (b^2 + c^2), and I_y and I_z accordingly, which determine a, b and c.
void DrawInertias(const Subject::State& state, const PlacedShapes& around, Scene& scene) {
  const mjModel& m = *state.model;
  const double radius = RadiusOf(around);
  for (int i = 1; i < m.nbody; ++i) {
    const double mass = m.body_mass[i];
    if (mass <= 0) continue;
    const Vector3d inertia = compiled::VectorAt(m.body_inertia, i);
    Vector3d half;
    for (int axis = 0; axis < 3; ++axis) {
      const double square = 3 / (2 * mass) * (inertia.sum() - 2 * inertia[axis]);
      half[axis] = std::sqrt(std::max(square, 0.0));
    }
    const Vector3d center = compiled::VectorAt(state.data->xipos, i);
    const Matrix3d axes = compiled::MatrixAt(state.data->ximat, i);
    scene.Add(mjGEOM_BOX, half, center, axes, kInertia);
    AddBall(center, 0.025 * radius, kMark, scene);
    scene.AddToFrame({.solid = {model::GeomType::kBox, half}, .p_WS = center, .R_WS = axes});
    scene.AddLabel(center, fmt::format("{} {:.3g} kg", m.names + m.name_bodyadr[i], mass));
  }
}

void DrawJoints(const Subject::State& state, const PlacedShapes& around, Scene& scene) {
  const double radius = RadiusOf(around);
  for (int i = 0; i < state.model->njnt; ++i) {
    const JointMark mark{*state.model, *state.data, i, radius, scene};
    const int type = state.model->jnt_type[i];  // a free joint has no mark
    if (type == mjJNT_HINGE) mark.DrawHinge();
    if (type == mjJNT_SLIDE) mark.DrawSlide();
    if (type == mjJNT_BALL) mark.DrawBallJoint();
  }
}

// Draws the areas of the regions, whose sites are boxes (three half lengths) and cylinders (radius,
// half length).
void DrawRegions(const Subject::State& state, const PlacedShapes& around, Scene& scene) {
  const mjModel& m = *state.model;
  int number = 0;
  for (int i = 0; i < m.nsite; ++i) {
    const bool is_box = m.site_type[i] == mjGEOM_BOX;
    if (m.site_group[i] != model::kRegionGroup || (!is_box && m.site_type[i] != mjGEOM_CYLINDER))
      continue;
    Vector3d size = compiled::VectorAt(m.site_size, i);
    if (!is_box) size = {size[0], size[0], size[1]};
    Color color = MarkColor(number++);
    const Vector3d center = compiled::VectorAt(state.data->site_xpos, i);
    const Matrix3d axes = compiled::MatrixAt(state.data->site_xmat, i);
    const double thick = 0.004 * RadiusOf(around);
    scene.AddLabel(center, fmt::format("{}", number));
    scene.AddToLegend(fmt::format("{} {}: {:.4g} x {:.4g} m", number, m.names + m.name_siteadr[i],
                                  2 * size.x(), 2 * size.y()),
                      color);
    color[3] = 0.5F;
    scene.Add(m.site_type[i], {size.x(), size.y(), thick}, center + thick * axes.col(2), axes,
              color);
    scene.AddToFrame({.solid = {model::GeomType::kBox, size}, .p_WS = center, .R_WS = axes});
  }
}

}  // namespace mjforge::picture
