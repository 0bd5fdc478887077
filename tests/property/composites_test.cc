// Tests mass properties and bounds of random bodies of primitives against MuJoCo's compiled model.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "harness/random.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/model/model.h"

namespace mjforge::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

using harness::Random;

Vector3d RandomVector(Random& random, double lo, double hi) {
  return {random.Uniform(lo, hi), random.Uniform(lo, hi), random.Uniform(lo, hi)};
}

struct Solid {
  Shape shape;
  Pose X_BG;
  double density = 0;
};

// Returns a solid of any type with sizes over two decades, sometimes aligned with the axes.
Solid RandomSolid(Random& random) {
  Solid solid;
  solid.shape.type = static_cast<GeomType>(random.Integer(5));
  for (int i = 0; i < SizeCount(solid.shape.type); ++i) {
    solid.shape.size(i) = std::pow(10, random.Uniform(-2, 0));
  }
  solid.X_BG.p = RandomVector(random, -0.5, 0.5);
  const Vector3d angles = random.Integer(8) == 0 ? Vector3d(M_PI / 2 * random.Integer(4), 0, 0)
                                                 : RandomVector(random, -M_PI, M_PI);
  solid.X_BG.q = FromEuler(angles);
  solid.density = random.Uniform(100, 8000);
  return solid;
}

template <typename Numbers>
std::string Attribute(std::string_view name, const Numbers& numbers) {
  std::string text = " " + std::string(name) + "=\"";
  for (const double number : numbers) {
    if (text.back() != '"') text += ' ';
    expr::AppendExactNumber(text, number);
  }
  return text + "\"";
}

std::string GeomText(const Solid& solid) {
  const Quaterniond& q = solid.X_BG.q;
  const std::vector<double> size(solid.shape.size.begin(),
                                 solid.shape.size.begin() + SizeCount(solid.shape.type));
  return "<geom type=\"" + std::string(GeomTypeName(solid.shape.type)) + "\"" +
         Attribute("size", size) + Attribute("pos", solid.X_BG.p) +
         Attribute("quat", Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())) +
         Attribute("density", std::vector<double>{solid.density}) + "/>";
}

// Compiles bodies from memory with MuJoCo.
class Compiler {
 public:
  /// Returns the model of one free body with `content`.
  engine::Model Load(const std::string& content) {
    const std::string text =
        "<mujoco><compiler angle=\"radian\"/><size njmax=\"10\" nconmax=\"1\" "
        "nstack=\"100000\"/><worldbody><body name=\"b\"><freejoint/>" +
        content + "</body></worldbody></mujoco>";
    engine::Loaded loaded = engine_.LoadText(text);
    INFO(loaded.error << "\n" << text);
    REQUIRE(loaded.model);
    return std::move(loaded.model);
  }

 private:
  engine::Engine engine_;
};

constexpr int kBody = 1;  // body 0 is the world

Matrix3d PointInertia(double mass, const Vector3d& r) {
  return mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
}

// Writes the dense joint-space inertia matrix, nv x nv, in all releases of MuJoCo.
template <class Model, class Data>
void FullInertia(const Model& m, const Data& d, mjtNum* inertia) {
  if constexpr (requires { mj_fullM(&m, &d, inertia); }) {
    mj_fullM(&m, &d, inertia);
  } else {
    mj_fullM(&m, inertia, d.qM);
  }
}

// Returns the inertia about the body's origin, along its axes: the angular block of the joint-space
// inertia matrix of a free joint in its zero position.
Matrix3d InertiaOfMotion(const mjModel& model) {
  const std::unique_ptr<mjData, decltype(&mj_deleteData)> data(mj_makeData(&model), &mj_deleteData);
  mj_kinematics(&model, data.get());
  mj_comPos(&model, data.get());
  mj_crb(&model, data.get());
  REQUIRE(model.nv == 6);
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> M;
  FullInertia(model, *data, M.data());
  return M.bottomRightCorner<3, 3>();
}

// Compares one body of all solids. MuJoCo's principal axes have errors up to 1e-6 (mju_eig3 stops
// there); the principal moments, which are compared, have the square of that error.
void CheckOneBody(Compiler& compiler, const std::string& geoms, const MassProperties& ours) {
  const auto model = compiler.Load(geoms);
  CHECK(std::abs(ours.mass - model->body_mass[kBody]) <= 1e-9 * ours.mass);
  CHECK((ours.p_FCm - Vector3d(model->body_ipos + 3 * kBody)).norm() <= 1e-9);
  Vector3d theirs(model->body_inertia + 3 * kBody);
  std::sort(theirs.begin(), theirs.end());
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(ours.I_Cm_F).eigenvalues();
  CHECK((moments - theirs).norm() <= 1e-9 * theirs.norm());
}

// Compares one body per solid, welded together, for which MuJoCo sums full inertia matrices.
void CheckWelded(Compiler& compiler, const std::string& bodies, const MassProperties& ours) {
  const Matrix3d about_B = ours.I_Cm_F + PointInertia(ours.mass, ours.p_FCm);
  const Matrix3d theirs = InertiaOfMotion(*compiler.Load(bodies));
  CHECK((about_B - theirs).norm() <= 1e-9 * theirs.norm());
}

TEST_CASE("the mass and centre and inertia of random bodies are MuJoCo's") {
  Compiler compiler;
  Random random(20240501);
  std::size_t solids = 0;
  for (int i = 0; i < harness::Effort(1000); ++i) {
    std::string geoms;
    std::string bodies;
    MassProperties ours;
    for (int k = random.Integer(8); k >= 0; --k) {
      const Solid solid = RandomSolid(random);
      const std::string geom = GeomText(solid);
      geoms += geom;
      bodies += bodies.empty() ? geom : "<body>" + geom + "</body>";
      ours = Combine(ours, InFrame(solid.X_BG, MassOf(solid.shape, solid.density)));
      ++solids;
    }
    INFO("body " << i << ": " << geoms);
    CheckOneBody(compiler, geoms, ours);
    CheckWelded(compiler, bodies, ours);
  }
  CHECK(solids > static_cast<std::size_t>(harness::Effort(4000)));
}

// Compiled geom. Points of its surface are parametrized by angles u and v and, for flat ends, by
// the end +1 or -1.
struct CompiledGeom {
  CompiledGeom(const mjModel& model, int g)
      : type(model.geom_type[g]), size(model.geom_size + 3 * g), p(model.geom_pos + 3 * g) {
    const mjtNum* q = model.geom_quat + 4 * g;
    R = Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  }

  Vector3d SurfacePoint(double u, double v, double end) const {
    const Vector3d ball(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
    return R * InOwnFrame(ball, u, end) + p;
  }

  Vector3d InOwnFrame(const Vector3d& ball, double u, double end) const {
    switch (type) {
      case mjGEOM_SPHERE:
        return size[0] * ball;
      case mjGEOM_CAPSULE:
        return size[0] * ball + Vector3d(0, 0, end * size[1]);
      case mjGEOM_ELLIPSOID:
        return size.cwiseProduct(ball);
      case mjGEOM_CYLINDER:
        return {size[0] * std::cos(u), size[0] * std::sin(u), end * size[1]};
      default:
        return {std::copysign(size[0], std::cos(u)), std::copysign(size[1], std::sin(u)),
                end * size[2]};
    }
  }

  int type;
  Vector3d size;
  Vector3d p;
  Matrix3d R;
};

constexpr double kSector = M_PI / 4;
constexpr int kSteps = 4;  // per sector

// Maximizes `f` in one sector by compass search from the best point of a grid. At a smooth maximum
// the error falls with the square of the step.
template <typename Function>
double SearchSector(const CompiledGeom& geom, double from, double end, const Function& f) {
  double best = -1e300;
  double u = 0;
  double v = 0;
  const auto test = [&](double new_u, double new_v) {
    const double value = f(geom.SurfacePoint(new_u, new_v, end));
    if (value <= best) return false;
    best = value;
    u = new_u;
    v = new_v;
    return true;
  };
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < 2 * kSteps; ++j) {
      test(from + kSector * (i + 0.5) / kSteps, M_PI * ((j + 0.5) / (2 * kSteps) - 0.5));
    }
  }
  for (double step = kSector / kSteps; step > 1e-5;) {
    const double u0 = u;
    const double v0 = v;
    bool better = false;
    for (const double d : {-step, step}) better |= test(u0 + d, v0) | test(u0, v0 + d);
    if (!better) step /= 2;
  }
  return best;
}

template <typename Function>
double Largest(const mjModel& model, const Function& f) {
  double best = -1e300;
  for (int g = 0; g < model.ngeom; ++g) {
    const CompiledGeom geom(model, g);
    for (const double end : {-1.0, 1.0}) {
      for (int sector = 0; sector < 8; ++sector) {
        best = std::max(best, SearchSector(geom, sector * kSector, end, f));
      }
    }
  }
  return best;
}

TEST_CASE("the box and radius of random bodies are those of MuJoCo's geoms") {
  Compiler compiler;
  Random random(20240502);
  for (int i = 0; i < harness::Effort(300); ++i) {
    std::string geoms;
    Box3 box;
    double radius = 0;
    for (int k = random.Integer(3); k >= 0; --k) {
      const Solid solid = RandomSolid(random);
      geoms += GeomText(solid);
      box.Add(BoundsOf(solid.shape, solid.X_BG));
      radius = std::max<double>(radius, HorizontalRadius(solid.shape, solid.X_BG));
    }
    INFO("body " << i << ": " << geoms);
    const auto model = compiler.Load(geoms);
    const int axis = i % 3;  // test one axis per body, and the radius of every other body
    const auto up = Largest(*model, [axis](const Vector3d& point) { return point(axis); });
    const auto down = Largest(*model, [axis](const Vector3d& point) { return -point(axis); });
    CHECK(std::abs(up - box.max(axis)) <= 1e-9);
    CHECK(std::abs(down + box.min(axis)) <= 1e-9);
    if (i % 2 == 0) continue;
    const auto far = Largest(*model, [](const Vector3d& point) { return point.head<2>().norm(); });
    CHECK(std::abs(far - radius) <= 1e-9);
  }
}

// Returns the rotation that MuJoCo compiles from an attribute of a geom.
Matrix3d CompiledRotation(Compiler& compiler, const std::string& attribute) {
  const auto model = compiler.Load("<geom type=\"box\" size=\"1 1 1\"" + attribute + "/>");
  const mjtNum* q = model->geom_quat;
  return Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

TEST_CASE("every way to write an orientation means what it means in MuJoCo") {
  Compiler compiler;
  Random random(20240503);
  for (int i = 0; i < 200; ++i) {
    const Vector3d a = RandomVector(random, -3, 3);
    const Vector3d b =
        i % 20 == 0 ? Vector3d(0, 0, i % 40 == 0 ? 1 : -1) : RandomVector(random, -1, 1);
    const double angle = random.Uniform(-4, 4);
    Eigen::Matrix<double, 6, 1> both;
    both << a, b;
    const auto differs = [&compiler](const std::string& attribute, const Quaterniond& q) {
      return (CompiledRotation(compiler, attribute) - q.toRotationMatrix()).norm();
    };
    CHECK(differs(Attribute("euler", a), FromEuler(a)) < 1e-12);
    CHECK(differs(Attribute("axisangle", Eigen::Vector4d(a.x(), a.y(), a.z(), angle)),
                  FromAxisAngle(a, angle)) < 1e-12);
    CHECK(differs(Attribute("xyaxes", both), FromXyAxes(a, b)) < 1e-12);
    CHECK(differs(Attribute("zaxis", b), FromZAxis(b)) < 1e-12);
  }
}

}  // namespace
}  // namespace mjforge::model
