// Tests mass properties and bounds of random trees of bodies, some with nested specs, against
// MuJoCo's compiled model.

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>

#include <mujoco/mujoco.h>

#include "harness/effort.h"
#include "harness/random.h"
#include "harness/source_folder.h"
#include "mjforge/assemble/assemble.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using harness::Random;

std::string NumberText(Random& random, double lo, double hi) {
  return expr::NumberText(random.Uniform(lo, hi));
}

std::string VectorText(Random& random, double lo, double hi) {
  std::string text = "[" + NumberText(random, lo, hi);
  for (int i = 0; i < 2; ++i) text += ", " + NumberText(random, lo, hi);
  return text + "]";
}

std::string PartText(Random& random, const std::string& name) {
  constexpr const char* kTypes[] = {"box", "sphere", "cylinder", "capsule", "ellipsoid"};
  constexpr int kSizes[] = {3, 1, 2, 2, 3};
  const int type = random.Integer(5);
  std::string size;
  for (int i = 0; i < kSizes[type]; ++i) {
    size += (i == 0 ? "" : ", ") + expr::NumberText(std::pow(10, random.Uniform(-2, -0.5)));
  }
  return "{name: " + name + ", type: " + kTypes[type] + ", size: [" + size +
         "], pos: " + VectorText(random, -0.3, 0.3) + ", euler: " + VectorText(random, -3, 3) +
         ", density: " + NumberText(random, 100, 8000) + "}";
}

// Returns a spec of up to seven bodies, each with any earlier body as parent and up to three
// joints.
std::string SpecText(Random& random, const std::string& name, const std::string& nested) {
  std::string text = "mjforge: 1\nname: " + name + "\njoints: none\nparts: [" +
                     PartText(random, "root_part") + "]\nbodies:\n";
  const int count = 1 + random.Integer(7);
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    text += "- {name: b" + n + ", pos: " + VectorText(random, -1, 1) +
            ", euler: " + VectorText(random, -3, 3);
    if (i > 0 && random.Integer(4) != 0) text += ", parent: b" + std::to_string(random.Integer(i));
    if (!nested.empty() && random.Integer(3) == 0) {
      text += ", spec: " + nested;
    } else {
      text += ", parts: [" + PartText(random, "p" + n) + ", " + PartText(random, "q" + n) + "]";
    }
    text += ", joints: [";
    for (int k = random.Integer(3); k > 0; --k) {
      text += "{name: j" + n + "_" + std::to_string(k) +
              ", type: " + (random.Integer(2) == 0 ? "hinge" : "slide") +
              ", axis: " + VectorText(random, 0.1, 1) + ", pos: " + VectorText(random, -1, 1) +
              "},";
    }
    text += "]}\n";
  }
  return text;
}

Matrix3d PointInertia(double mass, const Vector3d& r) {
  return mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
}

struct Whole {
  MassProperties mass;
  Box3 box;
};

// Sums over MuJoCo's bodies and geoms in the world frame.
Whole WholeOf(const mjModel& m) {
  const std::unique_ptr<mjData, decltype(&mj_deleteData)> data(mj_makeData(&m), &mj_deleteData);
  mj_kinematics(&m, data.get());
  mj_comPos(&m, data.get());
  Whole whole;
  whole.mass.mass = m.body_subtreemass[1];
  whole.mass.p_FCm = Vector3d(data->subtree_com + 3);
  for (int i = 1; i < m.nbody; ++i) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R(data->ximat + 9 * i);
    const Vector3d moments(m.body_inertia + 3 * i);
    whole.mass.I_Cm_F +=
        R * moments.asDiagonal() * R.transpose() +
        PointInertia(m.body_mass[i], Vector3d(data->xipos + 3 * i) - whole.mass.p_FCm);
  }
  for (int g = 0; g < m.ngeom; ++g) {
    if (m.geom_contype[g] == 0) continue;
    constexpr GeomType kTypes[] = {GeomType::kSphere, GeomType::kCapsule, GeomType::kEllipsoid,
                                   GeomType::kCylinder, GeomType::kBox};
    Shape shape;
    shape.type = kTypes[m.geom_type[g] - mjGEOM_SPHERE];
    shape.size = Vector3d(m.geom_size + 3 * g);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R(data->geom_xmat + 9 * g);
    whole.box.Add(BoundsOf(
        shape, {.p = Vector3d(data->geom_xpos + 3 * g), .q = Eigen::Quaterniond(Matrix3d(R))}));
  }
  return whole;
}

// Makes objects of specs that may nest the specs of a folder.
class ObjectMaker {
 public:
  std::optional<Object> Make(const std::string& text) {
    diag::Findings findings;
    const auto spec = spec::LoadSpecText("tree.yaml", text, folder_, {}, sources_, findings);
    std::optional<Object> object;
    if (spec != nullptr) {
      auto values = sample::Sample(*spec, {.seed = 1}, sample::kRootStream, {}, findings);
      object = assemble::Assembler().Assemble(*values, {}, findings);
    }
    for (const diag::Finding& finding : findings) {
      UNSCOPED_INFO(diag::RenderText(finding, sources_, false));
    }
    return object;
  }
  explicit ObjectMaker(std::filesystem::path folder) : folder_(std::move(folder)) {}

 private:
  std::filesystem::path folder_;
  diag::Sources sources_;
};

}  // namespace

TEST_CASE("mass, centre, inertia and bounds of random trees are MuJoCo's") {
  Random random(20261121);
  engine::Engine engine;
  mjcf::MjcfDocument document;
  ObjectMaker objects(harness::SourceFolder() / "tests/property");
  std::size_t bodies = 0;
  for (int i = 0; i < harness::Effort(300); ++i) {
    const std::string text = SpecText(random, "tree", "nested_tree.yaml");
    INFO(text);
    const std::optional<Object> object = objects.Make(text);
    REQUIRE(object);
    bodies += object->bodies.size();
    mjcf::WriteMjcf(*object, mjcf::Target::kMujoco, {}, document);
    const engine::Loaded loaded = engine.LoadText(document.text);
    INFO(loaded.error);
    REQUIRE(loaded.model);
    const Whole theirs = WholeOf(*loaded.model);
    const MassProperties& ours = object->mass_properties;
    CHECK(std::abs(ours.mass - theirs.mass.mass) <= 1e-9 * ours.mass);
    // MJCF has ten significant digits.
    CHECK((ours.p_FCm - theirs.mass.p_FCm).norm() <= 1e-9);
    // MuJoCo's principal moments are exact, but its axes have errors up to 1e-6 (mju_eig3 stops
    // there), which do not affect the trace.
    const double trace = theirs.mass.I_Cm_F.trace();
    CHECK(std::abs(ours.I_Cm_F.trace() - trace) <= 2e-9 * trace);
    CHECK((ours.I_Cm_F - theirs.mass.I_Cm_F).norm() <= 3e-6 * trace);
    CHECK((object->bounds.aabb.min - theirs.box.min).norm() <= 2e-9);
    CHECK((object->bounds.aabb.max - theirs.box.max).norm() <= 2e-9);
  }
  CHECK(bodies > static_cast<std::size_t>(harness::Effort(1200, 60)));
}

TEST_CASE("bodies move with their joints as MuJoCo's do") {
  Random random(20261123);
  engine::Engine engine;
  mjcf::MjcfDocument document;
  ObjectMaker objects(harness::SourceFolder() / "tests/property");
  std::size_t moved = 0;
  for (int i = 0; i < harness::Effort(100); ++i) {
    std::string text = SpecText(random, "tree", "nested_tree.yaml");
    text +=
        "- {name: last, parent: b0, parts: [{name: l, type: sphere, size: 1}], joints: [{name: "
        "turns, "
        "type: ball, pos: [0.1, 0.2, 0.3]}, {name: slides, type: slide, axis: [1, 2, 3], ref: "
        "0.4}]}\n";
    INFO(text);
    const std::optional<Object> object = objects.Make(text);
    REQUIRE(object);
    mjcf::WriteMjcf(*object, mjcf::Target::kMujoco, {}, document);
    const engine::Loaded loaded = engine.LoadText(document.text);
    INFO(loaded.error);
    REQUIRE(loaded.model);
    const mjModel& m = *loaded.model;
    const std::unique_ptr<mjData, decltype(&mj_deleteData)> data(mj_makeData(&m), &mj_deleteData);
    std::vector<std::pair<std::string, sample::Numbers>> positions;
    for (int j = 0; j < m.njnt; ++j) {
      if (random.Integer(4) == 0 || m.jnt_type[j] == mjJNT_FREE) continue;
      auto& [name, numbers] = positions.emplace_back();
      name = m.names + m.name_jntadr[j];
      mjtNum* const qpos = data->qpos + m.jnt_qposadr[j];
      const int count = m.jnt_type[j] == mjJNT_BALL ? 4 : 1;
      for (int k = 0; k < count; ++k) qpos[k] = random.Uniform(-2, 2);
      if (count == 4) mju_normalize4(qpos);
      for (int k = 0; k < count; ++k) numbers.emplace_back(qpos[k]);
    }
    moved += positions.size();
    mj_kinematics(&m, data.get());
    const std::vector<Pose> poses = SubtreePoses(object->bodies, 0, positions);
    for (std::size_t b = 0; b < poses.size(); ++b) {
      const int id = mj_name2id(&m, mjOBJ_BODY, object->bodies[b].name.c_str());
      REQUIRE(id > 0);
      CHECK((poses[b].p - Vector3d(data->xpos + 3 * id)).norm() < 1e-8);
      const mjtNum* q = data->xquat + 4 * id;
      CHECK(poses[b].q.angularDistance(Eigen::Quaterniond(q[0], q[1], q[2], q[3])) < 1e-8);
    }
  }
  CHECK(moved > static_cast<std::size_t>(harness::Effort(200, 10)));
}

}  // namespace mjforge::model
