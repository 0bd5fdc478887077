// Random bodies of primitives: what model/ computes against what MuJoCo compiles.

#include <cstdlib>
#include <cstring>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <mujoco/mujoco.h>

#include "mjforge/expr/expr.h"
#include "mjforge/model/model.h"

namespace mjforge::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double Uniform(double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(engine_()) / 4294967296.0;
  }
  Vector3d Vector(double lo, double hi) {
    return {Uniform(lo, hi), Uniform(lo, hi), Uniform(lo, hi)};
  }
  int Integer(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 engine_;
};

struct Solid {
  Shape shape;
  Pose X_BG;
  double density = 0;
};

// Every type, sizes over two decades; now and then an orientation along the axes.
Solid RandomSolid(Random& random) {
  Solid solid;
  solid.shape.type = static_cast<GeomType>(random.Integer(5));
  for (int i = 0; i < SizeCount(solid.shape.type); ++i) {
    solid.shape.size(i) = std::pow(10, random.Uniform(-2, 0));
  }
  solid.X_BG.p = random.Vector(-0.5, 0.5);
  const Vector3d angles = random.Integer(8) == 0
                              ? Vector3d(M_PI / 2 * random.Integer(4), 0, 0)
                              : random.Vector(-M_PI, M_PI);
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

[[noreturn]] void ThrowError(const char* message) { throw std::runtime_error(message); }
void IgnoreWarning(const char* /*message*/) {}

// MuJoCo, loading texts of one body from memory.
class Compiler {
 public:
  Compiler() : files_(static_cast<mjVFS*>(std::calloc(1, sizeof(mjVFS))), &std::free) {
    mju_user_error = ThrowError;
    mju_user_warning = IgnoreWarning;
    mj_defaultVFS(files_.get());
  }

  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> Load(const std::string& geoms) {
    const std::string text =
        "<mujoco><compiler angle=\"radian\"/><size njmax=\"100\" nconmax=\"10\"/><worldbody>"
        "<body name=\"b\"><freejoint/>" +
        geoms + "</body></worldbody></mujoco>";
    mj_deleteFileVFS(files_.get(), "m.xml");
    REQUIRE(mj_makeEmptyFileVFS(files_.get(), "m.xml", static_cast<int>(text.size())) == 0);
    const int file = mj_findFileVFS(files_.get(), "m.xml");
    std::memcpy(files_->filedata[file], text.data(), text.size());
    char error[1000] = "";
    mjModel* model = mj_loadXML("m.xml", files_.get(), error, sizeof(error));
    INFO(error << "\n" << text);
    REQUIRE(model != nullptr);
    return {model, &mj_deleteModel};
  }

  ~Compiler() { mj_deleteFileVFS(files_.get(), "m.xml"); }

 private:
  std::unique_ptr<mjVFS, decltype(&std::free)> files_;
};

constexpr int kBody = 1;  // 0 is the world

MassProperties MassOfBody(const mjModel& model) {
  const mjtNum* q = model.body_iquat + 4 * kBody;
  const Matrix3d R = Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  const Vector3d inertia(model.body_inertia + 3 * kBody);
  return {.mass = model.body_mass[kBody],
          .p_FCm = Vector3d(model.body_ipos + 3 * kBody),
          .I_Cm_F = R * inertia.asDiagonal() * R.transpose()};
}

TEST_CASE("mass, centre of mass and inertia of random bodies are MuJoCo's") {
  Compiler compiler;
  Random random(20240501);
  std::size_t solids = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string geoms;
    MassProperties ours;
    for (int k = random.Integer(8); k >= 0; --k) {
      const Solid solid = RandomSolid(random);
      geoms += GeomText(solid);
      ours = Combine(ours, InFrame(solid.X_BG, MassOf(solid.shape, solid.density)));
      ++solids;
    }
    const auto model = compiler.Load(geoms);
    const MassProperties theirs = MassOfBody(*model);
    INFO("body " << i << ": " << geoms);
    CHECK(std::abs(ours.mass - theirs.mass) <= 1e-9 * theirs.mass);
    CHECK((ours.p_FCm - theirs.p_FCm).norm() <= 1e-9);
    CHECK((ours.I_Cm_F - theirs.I_Cm_F).norm() <= 1e-9 * theirs.I_Cm_F.norm());
  }
  CHECK(solids > 4000);
}

// A point of the surface of a compiled geom: at angles (u, v) and, for solids
// with flat ends, at the end (+1 or -1).
Vector3d SurfacePoint(int type, const mjtNum* size, double u, double v, double end) {
  const Vector3d ball(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
  switch (type) {
    case mjGEOM_SPHERE: return size[0] * ball;
    case mjGEOM_CAPSULE: return size[0] * ball + Vector3d(0, 0, ball.z() >= 0 ? size[1] : -size[1]);
    case mjGEOM_ELLIPSOID: return Vector3d(size).cwiseProduct(ball);
    case mjGEOM_CYLINDER:
      return {size[0] * std::cos(u), size[0] * std::sin(u), end * size[1]};
    default:
      return {std::copysign(size[0], std::cos(u)), std::copysign(size[1], std::sin(u)),
              end * size[2]};
  }
}

struct Extent {
  Box3 box;
  double radius = 0;
};

// From points of the compiled geoms' surfaces, `steps` round.
Extent SampleExtent(const mjModel& model, int steps) {
  Extent extent;
  for (int g = 0; g < model.ngeom; ++g) {
    const mjtNum* q = model.geom_quat + 4 * g;
    const Matrix3d R = Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    const Vector3d p(model.geom_pos + 3 * g);
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; j <= steps / 2; ++j) {
        const double u = 2 * M_PI * (i + 0.5) / steps;
        const double v = M_PI * (2.0 * j / steps - 0.5);
        const Vector3d point =
            R * SurfacePoint(model.geom_type[g], model.geom_size + 3 * g, u, v, j % 2 ? 1 : -1) + p;
        extent.box.Add({.min = point, .max = point});
        extent.radius = std::max(extent.radius, point.head<2>().norm());
      }
    }
  }
  return extent;
}

// Sampling at angles of at most 2 pi / 128 misses the true extent of a shape of
// size s (at most 2 here) by at most s (1 - cos(2 pi / 128)) in each of the two angles.
TEST_CASE("boxes and radii of random bodies hold MuJoCo's geoms and no more") {
  Compiler compiler;
  Random random(20240502);
  const double slack = 2 * 2 * (1 - std::cos(2 * M_PI / 128));
  for (int i = 0; i < 1000; ++i) {
    std::string geoms;
    Extent ours;
    for (int k = random.Integer(3); k >= 0; --k) {
      const Solid solid = RandomSolid(random);
      geoms += GeomText(solid);
      ours.box.Add(BoundsOf(solid.shape, solid.X_BG));
      ours.radius = std::max(ours.radius, HorizontalRadius(solid.shape, solid.X_BG));
    }
    const Extent sampled = SampleExtent(*compiler.Load(geoms), 128);
    INFO("body " << i << ": " << geoms);
    CHECK((sampled.box.max - ours.box.max).maxCoeff() <= 1e-9);
    CHECK((ours.box.min - sampled.box.min).maxCoeff() <= 1e-9);
    CHECK(sampled.radius <= ours.radius + 1e-9);
    CHECK((ours.box.max - sampled.box.max).maxCoeff() <= slack);
    CHECK((sampled.box.min - ours.box.min).maxCoeff() <= slack);
    CHECK(ours.radius <= sampled.radius + slack);
  }
}

// The rotation MuJoCo makes of an attribute of a geom.
Matrix3d CompiledRotation(Compiler& compiler, const std::string& attribute) {
  const auto model = compiler.Load("<geom type=\"box\" size=\"1 1 1\"" + attribute + "/>");
  const mjtNum* q = model->geom_quat;
  return Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

TEST_CASE("every way to write an orientation means what it means in MuJoCo") {
  Compiler compiler;
  Random random(20240503);
  for (int i = 0; i < 200; ++i) {
    const Vector3d a = random.Vector(-3, 3);
    const Vector3d b = i % 20 == 0 ? Vector3d(0, 0, i % 40 == 0 ? 1 : -1) : random.Vector(-1, 1);
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

TEST_CASE("the volume of a convex prism is MuJoCo's") {
  Compiler compiler;
  Random random(20240504);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> polygon;
    const int corners = 3 + random.Integer(8);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * M_PI * k / corners;
      polygon.push_back(std::cos(angle) * 0.3 + 0.1);
      polygon.push_back(std::sin(angle) * 0.2);
    }
    std::string why_not;
    const std::optional<TriangleMesh> mesh = MakePrism(polygon, random.Uniform(0.1, 1), why_not);
    REQUIRE(mesh);
    std::vector<double> vertices;
    for (const Vector3d& v : mesh->vertices) vertices.insert(vertices.end(), v.begin(), v.end());
    const std::string text =
        "<geom type=\"mesh\" mesh=\"m\" density=\"1000\"/></body></worldbody>"
        "<asset><mesh name=\"m\"" +
        Attribute("vertex", vertices) + "/></asset><worldbody><body>";
    const auto model = compiler.Load(text);
    const MassProperties ours = MassOf({.type = GeomType::kMesh, .mesh = &*mesh}, 1000);
    // MuJoCo keeps vertices as floats.
    CHECK(model->body_mass[kBody] == Approx(ours.mass).epsilon(1e-5));
    CHECK((Vector3d(model->body_ipos + 3 * kBody) - ours.p_FCm).norm() < 1e-6);
  }
}

}  // namespace
}  // namespace mjforge::model
