// Comparison of compiled bodies with those of the object: counts, names, poses, masses and
// inertias. Also compares the start keyframe.
#include "mjforge/validate/compare.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"

namespace mjforge::validate {
namespace {

// Tolerances for MuJoCo's principal moments, kg m^2, and principal axes, rad. mju_eig3 (2.2.2)
// stops if all off-diagonal terms are below 1e-12 kg m^2, or if the next rotation is below 1.4e-6
// rad (cosine within 1e-12 of 1). The tolerances are about twice these values.
constexpr double kMomentCutoff = 2e-12;
constexpr double kAxesRelative = 3e-6;

/// Returns the largest distance, m, of an element from the origin of its body, or of a body from
/// the origin of its parent.
double ScaleOf(const model::Object& object) {
  double scale = 0;
  for (const model::Body& body : object.bodies) {
    scale = std::max(scale, body.X_PB.p.norm());
    for (const model::Joint& joint : body.joints) scale = std::max(scale, joint.pos.norm());
    for (const model::Site& site : body.sites) {
      scale = std::max(scale, site.X_BS.p.norm() + site.size.norm());
    }
    for (const model::Part& part : body.parts) {
      double radius = part.shape.size.norm();
      if (part.shape.mesh != nullptr) {
        radius = 0;
        for (const Eigen::Vector3d& v : part.shape.mesh->vertices) {
          radius = std::max(radius, v.norm());
        }
      }
      scale = std::max(scale, part.X_BG.p.norm() + radius);
    }
  }
  return scale;
}

/// Returns the number of elements whose body is the world. A scene may have such elements; their
/// ids come before those of the object.
int CountOfWorld(const int* bodies, int count) {
  return static_cast<int>(std::count(bodies, bodies + count, 0));
}

bool IsCamera(const model::Element& element) { return element.tag == "camera"; }

}  // namespace

void AddMismatch(diag::SourceMark mark, std::string message, diag::Findings& findings) {
  findings.Add(
      diag::Code::kMujocoMismatch, mark, std::move(message),
      "the file does not say what was meant: please report this with the spec and the seed");
}

bool SameCount(std::string_view what, int compiled, std::size_t meant, diag::SourceMark mark,
               diag::Findings& findings) {
  if (compiled == static_cast<int>(meant)) return true;
  AddMismatch(mark, fmt::format("MuJoCo compiled {} {}, not {}", compiled, what, meant), findings);
  return false;
}

bool SameName(std::string_view compiled, const ComparedElement& subject, diag::Findings& findings) {
  if (compiled.size() == subject.name.size() + subject.suffix.size() &&
      compiled.starts_with(subject.name) && compiled.ends_with(subject.suffix)) {
    return true;
  }
  AddMismatch(subject.mark,
              fmt::format("MuJoCo compiled {} '{}' where '{}{}' was meant", subject.kind, compiled,
                          subject.name, subject.suffix),
              findings);
  return false;
}

Comparison::Comparison(const mjModel& compiled, const model::Object& object,
                       diag::Findings& findings)
    : m_(compiled), object_(object), findings_(findings), scale_(ScaleOf(object)) {
  length_tolerance_ = kRelative * scale_;
}

void Comparison::Run(double lift) {
  if (!SameCounts()) return;
  next_site_ = 0;
  next_camera_ = CountOfWorld(m_.cam_bodyid, m_.ncam);
  next_light_ = CountOfWorld(m_.light_bodyid, m_.nlight);
  int id = 0;  // MuJoCo's id of the world
  for (const int i : mjcf::DepthFirstOrder(object_)) {
    CompareBody(++id, object_.bodies[static_cast<std::size_t>(i)], lift);
  }
  CompareSections(m_, object_, findings_);
  CompareStart(lift);
}

void Comparison::CompareStart(double lift) {
  const mjcf::StartState meant = mjcf::StartStateOf(object_, lift);
  if (meant.qpos.empty() && meant.ctrl.empty() && meant.act.empty()) return;
  const ComparedElement subject{"keyframe", object_.name, mjcf::kStartSuffix,
                                object_.bodies.front().mark};
  if (!SameCount("keyframes", m_.nkey, 1, subject.mark, findings_) ||
      !SameName(m_.names + m_.name_keyadr[0], subject, findings_)) {
    return;
  }
  const auto compare = [&](std::string_view what, const mjtNum* compiled,
                           const std::vector<double>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      Number(subject, what, static_cast<int>(i), compiled[i], numbers[i],
             kRelative * std::max(1.0, std::abs(numbers[i])) + length_tolerance_);
    }
  };
  compare("qpos", m_.key_qpos, meant.qpos);
  compare("qvel", m_.key_qvel, meant.qvel);
  compare("act", m_.key_act, meant.act);
  compare("ctrl", m_.key_ctrl, meant.ctrl);
  CompareStartPoses(lift);
}

// Compares the positions of bodies that MuJoCo computes from the start keyframe with those of
// model::BodyPoses(), from which mjforge computes bounds and records.
void Comparison::CompareStartPoses(double lift) {
  const compiled::Data d = compiled::MakeData(m_);
  std::copy_n(m_.key_qpos, m_.nq, d->qpos);
  mj_kinematics(&m_, d.get());
  const std::vector<model::Pose> X_WB = model::BodyPoses(object_);
  // Factor for tolerances, because rounding errors add up along a chain of bodies.
  const double chain = static_cast<double>(X_WB.size());
  int id = 0;
  for (const int i : mjcf::DepthFirstOrder(object_)) {
    const model::Body& body = object_.bodies[static_cast<std::size_t>(i)];
    Eigen::Vector3d p = X_WB[static_cast<std::size_t>(i)].p;
    p.z() += lift;
    Vector({"body", body.name, {}, body.mark}, "position at the start", d->xpos + 3 * ++id, p,
           chain * (length_tolerance_ + kRelative * p.norm()));
  }
}

bool Comparison::SameCounts() {
  const diag::SourceMark mark =
      object_.bodies.empty() ? diag::SourceMark{} : object_.bodies.front().mark;
  std::size_t joints = 0;
  std::size_t sites = 0;
  std::size_t geoms = 0;
  std::size_t cameras = 0;
  std::size_t lights = 0;
  for (const model::Body& body : object_.bodies) {
    joints += body.joints.size();
    sites += body.sites.size();
    geoms += model::GeomCount(body);
    for (const model::Element& element : body.elements) ++(IsCamera(element) ? cameras : lights);
  }
  // Subtracts geoms, cameras and lights of the world, because they belong to a scene.
  bool same = true;
  const auto count = [&](std::string_view what, int compiled, std::size_t meant) {
    same &= SameCount(what, compiled, meant, mark, findings_);
  };
  count("bodies", m_.nbody - 1, object_.bodies.size());
  count("joints", m_.njnt, joints);
  count("sites", m_.nsite, sites);
  count("cameras", m_.ncam - CountOfWorld(m_.cam_bodyid, m_.ncam), cameras);
  count("lights", m_.nlight - CountOfWorld(m_.light_bodyid, m_.nlight), lights);
  count("geoms", m_.ngeom - m_.body_geomnum[0], geoms);
  return same;
}

void Comparison::CompareBody(int id, const model::Body& body, double lift) {
  const ComparedElement subject{"body", body.name, {}, body.mark};
  if (!SameName(m_.names + m_.name_bodyadr[id], subject, findings_)) return;
  Eigen::Vector3d pos = body.X_PB.p;
  if (body.parent < 0) pos.z() += lift;
  // The error of the position also grows with the lift, which may be larger than the object.
  Vector(subject, "pos", m_.body_pos + 3 * id, pos, length_tolerance_ + kRelative * std::abs(lift));
  Quaternion(subject, m_.body_quat + 4 * id, body.X_PB.q);
  CompareMass(id, body, subject);

  const bool same_geoms = SameCount("geoms of a body", m_.body_geomnum[id], model::GeomCount(body),
                                    body.mark, findings_);
  const bool same_joints =
      SameCount("joints of a body", m_.body_jntnum[id], body.joints.size(), body.mark, findings_);
  if (!same_geoms || !same_joints) return;
  int geom = m_.body_geomadr[id];
  for (const model::Part& part : body.parts) ComparePart(geom, part);
  int joint = m_.body_jntadr[id];
  for (const model::Joint& meant : body.joints) CompareJoint(joint++, meant);
  for (const model::Site& site : body.sites) CompareSite(next_site_++, site);
  for (const model::Element& element : body.elements) CompareElement(element);
}

void Comparison::CompareElement(const model::Element& element) {
  const int address =
      IsCamera(element) ? m_.name_camadr[next_camera_++] : m_.name_lightadr[next_light_++];
  SameName(m_.names + address, {element.tag, element.name, {}, element.mark}, findings_);
}

void Comparison::CompareMass(int id, const model::Body& body, const ComparedElement& subject) {
  const model::MassProperties& meant = body.mass_properties;
  // Allows mjMINVAL more, the mass with which bodies with several massless geoms are written.
  Number(subject, "mass", -1, m_.body_mass[id], meant.mass, kRelative * meant.mass + mjMINVAL);
  if (meant.mass == 0) return;  // without mass there is no centre and no inertia
  Vector(subject, "centre of mass", m_.body_ipos + 3 * id, meant.p_FCm, length_tolerance_);
  CompareInertia(id, body, subject);
}

void Comparison::CompareInertia(int id, const model::Body& body, const ComparedElement& subject) {
  const model::MassProperties& meant = body.mass_properties;
  // Rounding error of moments, kg m^2: an error of a length changes them by mass times length
  // squared. A file may state larger moments than such a body can have.
  const double rounding = kRelative * std::max(meant.mass * scale_ * scale_, meant.I_Cm_F.trace());
  const Eigen::Matrix3d tensor = compiled::MassOf(m_, id).I_Cm_F;
  constexpr std::string_view kTerms[] = {"inertia xx", "inertia yy", "inertia zz",
                                         "inertia xy", "inertia xz", "inertia yz"};
  constexpr int kRows[] = {0, 1, 2, 0, 0, 1};
  constexpr int kColumns[] = {0, 1, 2, 1, 2, 2};
  const double turned = kAxesRelative * meant.I_Cm_F.trace();
  const bool exact_axes = body.explicit_inertial;
  for (std::size_t i = 0; i < std::size(kTerms); ++i) {
    Number(subject, kTerms[i], -1, tensor(kRows[i], kColumns[i]),
           meant.I_Cm_F(kRows[i], kColumns[i]),
           exact_axes ? rounding : rounding + turned + kMomentCutoff);
  }
  if (exact_axes) return;
  Eigen::Vector3d sorted = compiled::VectorAt(m_.body_inertia, id);
  std::sort(sorted.begin(), sorted.end());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(meant.I_Cm_F, Eigen::EigenvaluesOnly);
  for (int i = 0; i < 3; ++i) {
    Number(subject, "principal moment", i, sorted[i], solver.eigenvalues()[i],
           rounding + kMomentCutoff);
  }
}

void Comparison::Number(const ComparedElement& subject, std::string_view what, int position,
                        double compiled, double meant, double tolerance) {
  // Uses !(x <= y) instead of x > y, because NaN must be a difference.
  if (!(std::abs(compiled - meant) <= tolerance)) {
    Difference(subject, what, position, compiled, meant);
  }
}

void Comparison::Vector(const ComparedElement& subject, std::string_view what,
                        const mjtNum* compiled, const Eigen::Vector3d& meant, double tolerance) {
  for (int i = 0; i < 3; ++i) Number(subject, what, i, compiled[i], meant[i], tolerance);
}

void Comparison::Quaternion(const ComparedElement& subject, const mjtNum* compiled,
                            const Eigen::Quaterniond& meant) {
  // q and -q are the same rotation.
  const double sign = compiled::QuaternionAt(compiled, 0).dot(meant) < 0 ? -1 : 1;
  const Eigen::Vector4d wxyz = model::Wxyz(meant);
  for (int i = 0; i < 4; ++i) Number(subject, "quat", i, compiled[i], sign * wxyz[i], kRelative);
}

void Comparison::Difference(const ComparedElement& subject, std::string_view what, int position,
                            double compiled, double meant) {
  const auto text = [](double x) {
    return std::isfinite(x) ? expr::NumberText(x) : std::string(x != x ? "nan" : "infinity");
  };
  const std::string place = position < 0 ? "" : fmt::format(" {}", position + 1);
  std::string compiled_text = text(compiled);
  std::string meant_text = text(meant);
  if (compiled_text == meant_text) {  // the numbers differ only in further digits
    compiled_text = expr::ExactNumberText(compiled);
    meant_text = expr::ExactNumberText(meant);
  }
  AddMismatch(subject.mark,
              fmt::format("MuJoCo compiled {}{} of {} '{}{}' as {}, not {}", what, place,
                          subject.kind, subject.name, subject.suffix, compiled_text, meant_text),
              findings_);
}

}  // namespace mjforge::validate
