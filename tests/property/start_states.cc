#include "start_states.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "harness/random.h"
#include "harness/source_folder.h"
#include "mjforge/compiled/compiled.h"

namespace mjforge::forge {
namespace {

constexpr int kStates = 20;

using compiled::QuaternionAt;
using Numbers = std::vector<mjtNum>;

void SetQuaternion(const Eigen::Quaterniond& q, mjtNum* out) {
  const mjtNum wxyz[] = {q.w(), q.x(), q.y(), q.z()};
  std::copy_n(wxyz, 4, out);
}

// States of a model with a keyframe, and the same states in coordinates whose zero is the keyframe.
class States {
 public:
  explicit States(const mjModel& m) : m_(m) {
    for (int j = 0; j < m.njnt; ++j) {
      if (m.jnt_type[j] == mjJNT_BALL) balls_.push_back({j, LaterTurn(j)});
    }
  }

  /// Returns a state near the keyframe; the keyframe itself for the state 0.
  Numbers Positions(int state, harness::Random& random) const {
    Numbers qpos(m_.key_qpos, m_.key_qpos + m_.nq);
    const double size = state == 0 ? 0 : 0.4;
    for (int j = 0; j < m_.njnt; ++j) {
      mjtNum* own = qpos.data() + m_.jnt_qposadr[j];
      const int type = m_.jnt_type[j];
      if (type == mjJNT_SLIDE) own[0] += random.Uniform(-size, size) / 4;
      if (type == mjJNT_HINGE) own[0] += random.Uniform(-size, size);
      for (int i = 0; type == mjJNT_FREE && i < 3; ++i) own[i] += random.Uniform(-size, size);
      if (type == mjJNT_BALL || type == mjJNT_FREE)
        Turn(size, random, own + (type == mjJNT_FREE ? 3 : 0));
    }
    return qpos;
  }

  Numbers PositionsFromStart(Numbers qpos) const {
    for (const auto& [joint, later] : balls_) {
      const int at = m_.jnt_qposadr[joint];
      const Eigen::Quaterniond start = QuaternionAt(m_.key_qpos + at, 0);
      const Eigen::Quaterniond q = QuaternionAt(qpos.data() + at, 0);
      SetQuaternion((start * later).conjugate() * q * later, qpos.data() + at);
    }
    return qpos;
  }

  /// Turns the components of ball joints, so that a vector of degrees of freedom (velocities,
  /// forces) is that of the coordinates from the start.
  Numbers DofsFromStart(const mjtNum* dofs) const {
    Numbers turned(dofs, dofs + m_.nv);
    for (const auto& [joint, later] : balls_) {
      Eigen::Map<Eigen::Vector3d> own(turned.data() + m_.jnt_dofadr[joint]);
      own = (later.conjugate() * Eigen::Vector3d(own)).eval();
    }
    return turned;
  }

 private:
  static void Turn(double size, harness::Random& random, mjtNum* q) {
    const Eigen::Vector3d axis(random.Uniform(-1, 1), random.Uniform(-1, 1), 1);
    const Eigen::Quaterniond turn = model::FromAxisAngle(axis, random.Uniform(-size, size));
    SetQuaternion((QuaternionAt(q, 0) * turn).normalized(), q);
  }

  // Returns the rotation, at the keyframe, of the joints after a ball joint of the same body.
  Eigen::Quaterniond LaterTurn(int ball) const {
    const int body = m_.jnt_bodyid[ball];
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    for (int j = ball + 1; j < m_.body_jntadr[body] + m_.body_jntnum[body]; ++j) {
      const int at = m_.jnt_qposadr[j];
      if (m_.jnt_type[j] == mjJNT_HINGE) {
        turn = turn * model::FromAxisAngle(compiled::VectorAt(m_.jnt_axis, j),
                                           m_.key_qpos[at] - m_.qpos0[at]);
      } else if (m_.jnt_type[j] == mjJNT_BALL) {
        turn = turn * QuaternionAt(m_.key_qpos + at, 0);
      }
    }
    return turn;
  }

  const mjModel& m_;
  std::vector<std::pair<int, Eigen::Quaterniond>> balls_;
};

class StartComparison {
 public:
  StartComparison(const mjModel& keyframe, const mjModel& zero, double tolerance)
      : k_(keyframe),
        z_(zero),
        tolerance_(tolerance),
        states_(keyframe),
        in_k_(compiled::MakeData(keyframe)),
        in_z_(compiled::MakeData(zero)) {}

  int Run() {
    harness::Random random(7);
    for (int state = 0; state < kStates; ++state) {
      INFO("state " << state);
      SetState(state, random);
      mj_forward(&k_, in_k_.get());
      mj_forward(&z_, in_z_.get());
      ComparePoses();
      CompareForces();
      CompareResiduals();
    }
    return compared_;
  }

 private:
  void SetState(int state, harness::Random& random) {
    const Numbers qpos = states_.Positions(state, random);
    const Numbers from_start = states_.PositionsFromStart(qpos);
    mj_resetData(&z_, in_z_.get());
    if (state == 0) Compare("qpos0", from_start.data(), in_z_->qpos, z_.nq);
    std::ranges::copy(qpos, in_k_->qpos);
    std::ranges::copy(from_start, in_z_->qpos);
    for (int i = 0; i < k_.nv; ++i) in_k_->qvel[i] = random.Uniform(-1, 1);
    std::ranges::copy(states_.DofsFromStart(in_k_->qvel), in_z_->qvel);
    for (int i = 0; i < k_.nu; ++i) in_z_->ctrl[i] = in_k_->ctrl[i] = random.Uniform(0, 1);
    for (int i = 0; i < k_.na; ++i) in_z_->act[i] = in_k_->act[i] = random.Uniform(0, 1);
  }

  void ComparePoses() {
    const mjData& a = *in_k_;
    const mjData& b = *in_z_;
    Compare("xpos", a.xpos, b.xpos, 3 * k_.nbody);
    Compare("xmat", a.xmat, b.xmat, 9 * k_.nbody);
    Compare("xipos", a.xipos, b.xipos, 3 * k_.nbody);
    for (int j = 0; j < k_.njnt; ++j) {
      // MuJoCo computes the anchor of a slide before the motion of the slide.
      if (k_.jnt_type[j] != mjJNT_SLIDE)
        Compare("xanchor", a.xanchor + 3 * j, b.xanchor + 3 * j, 3);
      if (compiled::HasOneNumber(k_, j)) Compare("xaxis", a.xaxis + 3 * j, b.xaxis + 3 * j, 3);
    }
    Compare("geom_xpos", a.geom_xpos, b.geom_xpos, 3 * k_.ngeom);
    Compare("site_xmat", a.site_xmat, b.site_xmat, 9 * k_.nsite);
    Compare("cam_xpos", a.cam_xpos, b.cam_xpos, 3 * k_.ncam);
    Compare("cam_xmat", a.cam_xmat, b.cam_xmat, 9 * k_.ncam);
    Compare("light_xpos", a.light_xpos, b.light_xpos, 3 * k_.nlight);
    Compare("light_xdir", a.light_xdir, b.light_xdir, 3 * k_.nlight);
  }

  void CompareForces() {
    const mjData& a = *in_k_;
    const mjData& b = *in_z_;
    Compare("ten_length", a.ten_length, b.ten_length, k_.ntendon);
    Compare("ten_velocity", a.ten_velocity, b.ten_velocity, k_.ntendon);
    Compare("actuator_length", a.actuator_length, b.actuator_length, k_.nu);
    Compare("actuator_velocity", a.actuator_velocity, b.actuator_velocity, k_.nu);
    Compare("actuator_force", a.actuator_force, b.actuator_force, k_.nu);
    Compare("sensordata", a.sensordata, b.sensordata, k_.nsensordata);
    const auto dofs = [&](const char* what, const mjtNum* in_k, const mjtNum* in_z) {
      Compare(what, states_.DofsFromStart(in_k).data(), in_z, k_.nv);
    };
    dofs("qfrc_passive", a.qfrc_passive, b.qfrc_passive);
    dofs("qfrc_actuator", a.qfrc_actuator, b.qfrc_actuator);
    dofs("qfrc_bias", a.qfrc_bias, b.qfrc_bias);
  }

  using Residuals = std::map<std::pair<int, int>, Numbers>;  // by type and id of the constraint
  static Residuals ResidualsOf(const mjData& d) {
    Residuals residuals;
    for (int i = 0; i < d.nefc; ++i) {
      const int type = d.efc_type[i];
      if (type == mjCNSTR_EQUALITY || type == mjCNSTR_LIMIT_JOINT || type == mjCNSTR_LIMIT_TENDON)
        residuals[{type, d.efc_id[i]}].push_back(d.efc_pos[i]);
    }
    return residuals;
  }

  // A connection that is open at the start is a weld with three more residuals, which have no
  // effect.
  void CompareResiduals() {
    const Residuals meant = ResidualsOf(*in_k_);
    Residuals made = ResidualsOf(*in_z_);
    CHECK(meant.size() == made.size());
    for (const auto& [constraint, numbers] : meant) {
      INFO("constraint of type " << constraint.first << ", id " << constraint.second);
      REQUIRE(made[constraint].size() >= numbers.size());
      Compare("efc_pos", numbers.data(), made[constraint].data(), static_cast<int>(numbers.size()));
    }
  }

  void Compare(const char* what, const mjtNum* a, const mjtNum* b, engine::Count count) {
    const std::span meant(a, static_cast<std::size_t>(count));
    double size = 1;
    for (const mjtNum number : meant) size = std::max(size, std::abs(number));
    for (std::size_t i = 0; i < meant.size(); ++i) {
      ++compared_;
      if (std::abs(b[i] - meant[i]) <= tolerance_ * size) continue;
      FAIL_CHECK(what << "[" << i << "] is " << b[i] << ", not " << meant[i] << "; difference "
                      << b[i] - meant[i]);
    }
  }

  const mjModel& k_;
  const mjModel& z_;
  double tolerance_;
  States states_;
  compiled::Data in_k_;
  compiled::Data in_z_;
  int compared_ = 0;
};

}  // namespace

StartForm::StartForm(const std::filesystem::path& file, const std::string& start,
                     std::uint64_t index) {
  diag::Sources sources;
  diag::Findings findings;
  spec::LoadOptions load;
  load.search_path = {harness::SourceFolder() / "specs"};
  load.settings = {{"root.start", start}};
  const std::optional<Recipe> recipe = LoadRecipe(file, load, sources, findings);
  INFO((findings.empty() ? "" : findings[0].message));
  REQUIRE(recipe);
  Options options;
  options.seed = 7;
  options.validation = Validation::kLoad;
  Generator(*recipe, sources, options).Make(index, variant);
  std::string messages;
  for (const diag::Finding& finding : variant.findings) messages += finding.message + "\n";
  INFO(file << ", start: " << start << "\n" << messages);
  CHECK(messages.find("MuJoCo compiled") == std::string::npos);
  if (!variant.ok()) return;
  engine::Engine engine;
  REQUIRE_FALSE(engine.SetAssets(variant.document.assets));
  engine::Loaded loaded = engine.LoadText(variant.document.text);
  INFO(loaded.error);
  REQUIRE(loaded.model);
  model = std::move(loaded.model);
  // A spec cannot have active equalities that its start violates.
  for (int i = 0; i < model->neq; ++i) (model.get()->*engine::kEqualityActive)[i] = 1;
}

int CompareStartForms(const mjModel& keyframe, const mjModel& zero, double tolerance) {
  REQUIRE(keyframe.nkey == 1);
  REQUIRE(keyframe.nq == zero.nq);
  return StartComparison(keyframe, zero, tolerance).Run();
}

}  // namespace mjforge::forge
