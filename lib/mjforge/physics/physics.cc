#include "mjforge/physics/physics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "mjforge/backport/backport.h"
#include "mjforge/bytes/bytes.h"
#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/behaviour.h"
#include "mjforge/physics/fitting.h"
#include "mjforge/physics/floor.h"
#include "mjforge/physics/grasping.h"
#include "mjforge/physics/holding.h"
#include "mjforge/physics/jaws.h"
#include "mjforge/physics/proportions.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/verdict.h"
#include "mjforge/xml/xml.h"

namespace mjforge::physics {
namespace {

using diag::Code;

constexpr std::string_view kFloorName = "mjforge-floor";
// The body that the host frees may have no mass of its own, nor its only child: that of
// MuJoCo's smallest body (mjMINVAL) is lost in any object's.
constexpr std::string_view kFree =
    R"(<joint name="mjforge-free" type="free"/>)"
    R"(<inertial pos="0 0 0" mass="1e-14" diaginertia="1e-14 1e-14 1e-14"/>)";

std::string FloorElement(std::string_view name) {
  return fmt::format(R"(<geom name="{}" type="plane" size="0 0 1"/>)", name);
}

/// The document with the free root that its host gives it. Without line ends, here and below, so
/// that line numbers stay.
std::string WithFreeRoot(const mjcf::MjcfDocument& document) {
  std::string text = document.text;
  if (document.world_position == std::string::npos || !document.host_frees) return text;
  return text.insert(text.find('\n', document.world_position) + 1, kFree);
}

/// And with a floor.
std::string WithSurroundings(const mjcf::MjcfDocument& document) {
  std::string text = WithFreeRoot(document);
  if (document.world_position == std::string::npos) return text;
  return text.insert(document.world_position, FloorElement(kFloorName));
}

/// Four digits, and what is below 1e-9 is nothing: more would depend on the last bits of
/// a long simulation.
double Rounded(double number) {
  if (std::abs(number) < 1e-9) return 0;
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                 std::chars_format::scientific, 3);
  double rounded = number;
  std::from_chars(digits.data(), end.ptr, rounded);
  return rounded;
}

void Round(Result& result) {
  for (double* number : {&result.time, &result.drift, &result.tilt, &result.speed,
                         &result.penetration, &result.sink, &result.energy_gain, &result.overlap}) {
    *number = Rounded(*number);
  }
  if (result.stability) {
    result.stability->angle = Rounded(result.stability->angle);
    result.stability->energy = Rounded(result.stability->energy);
  }
  for (Result::Grasp& grasp : result.grasps) {
    for (double& number : grasp.pos) number = Rounded(number);
    for (double& number : grasp.quat) number = Rounded(number);
    grasp.width = Rounded(grasp.width);
  }
  for (Result::Joint& joint : result.joints) {
    for (double* number :
         {&joint.overshoot, &joint.reach, &joint.penetration, &joint.return_error}) {
      *number = Rounded(*number);
    }
  }
}

/// Whether something may fall, and has no plane to fall on.
bool LacksFloor(const mjModel& m) {
  return std::count(m.jnt_type, m.jnt_type + m.njnt, mjJNT_FREE) > 0 &&
         std::count(m.geom_type, m.geom_type + m.ngeom, mjGEOM_PLANE) == 0;
}

/// A name that no geom of the model has.
std::string FloorName(const mjModel& m) {
  std::string name(kFloorName);
  while (mj_name2id(&m, mjOBJ_GEOM, name.c_str()) >= 0) name += '-';
  return name;
}

std::filesystem::path FolderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

/// The file as it is, with a floor, as a text in the file's folder.
std::string WithFloor(const std::filesystem::path& file, std::string text, std::string_view model,
                      const std::string& floor) {
  const std::string world = fmt::format("<worldbody>{}</worldbody>", FloorElement(floor));
  if (file != bytes::kStandardInput) {
    // The start pose goes by the model's name.
    return fmt::format(R"(<mujoco model="{}"><include file="{}"/>{}</mujoco>)",
                       xml::EscapeXml(model), xml::EscapeXml(file.filename().string()), world);
  }
  const std::size_t end = text.rfind("</mujoco");
  if (end != text.npos) text.insert(end, world);
  return text;
}

}  // namespace

struct Laboratory::State {
  engine::Engine engine;
  Workspace workspace;

  /// Loads a text that is much like the model's own.
  using Load = std::function<engine::Loaded(const std::string& text)>;

  std::optional<Result> Examine(mjModel& m, const model::Object& object, diag::SourceMark mark,
                                const model::Checks& checks, diag::Findings& findings,
                                std::string_view text, const Load& load);
};

Laboratory::Laboratory() : state_(std::make_unique<State>()) {}
Laboratory::~Laboratory() = default;

std::optional<Result> Laboratory::State::Examine(mjModel& m, const model::Object& object,
                                                 diag::SourceMark mark, const model::Checks& checks,
                                                 diag::Findings& findings, std::string_view text,
                                                 const Load& load) {
  Verdict verdict(checks, findings);
  try {
    Result result;
    CheckBehaviour(m, workspace, object, mark, verdict, result);
    result.overlap = CheckProportions(object, mark, verdict);
    const auto loaded = [&](const std::string& with_more) {
      engine::Loaded more = load(with_more);
      if (!more.model) throw std::runtime_error(engine::ParseRefusal(more.error).reason);
      return std::move(more.model);
    };
    const std::span<const mjtNum> start = compiled::StartOf(m);
    if (checks.holds) {
      const engine::Model with_balls = loaded(WithBalls(text, *checks.holds));
      CheckHolding(*with_balls, workspace, start, object.name, verdict, result);
    }
    if (!checks.fits.empty()) {
      const engine::Model with_pegs = loaded(WithPegs(text, checks));
      CheckFitting(*with_pegs, workspace, start, object.name, verdict, result);
    }
    if (checks.grasps) {
      const engine::Model with_jaws = loaded(WithJaws(text, *checks.grasps));
      CheckGrasping(*with_jaws, workspace, start, object.name, verdict, result);
    }
    Round(result);
    return result;
  } catch (const std::bad_alloc&) {
    throw;  // not MuJoCo's fault
  } catch (const std::exception& error) {
    findings.Add(
        Code::kMujocoError, mark,
        fmt::format("MuJoCo cannot simulate the object: {}", engine::OneLine(error.what())));
    return std::nullopt;
  }
}

std::optional<Result> Laboratory::Examine(const mjcf::MjcfDocument& document,
                                          const model::Object& object, diag::Findings& findings) {
  const diag::SourceMark mark =
      object.bodies.empty() ? diag::SourceMark{} : object.bodies.front().mark;
  engine::Loaded loaded;
  if (const auto problem = state_->engine.SetAssets(document.assets)) {
    loaded.error = problem->message;
  } else {
    loaded = state_->engine.LoadText(WithSurroundings(document));
  }
  if (!loaded.model) {
    findings.Add(Code::kMujocoError, mark,
                 fmt::format("MuJoCo refused the object on a floor: {}",
                             engine::ParseRefusal(loaded.error).reason));
    return std::nullopt;
  }
  // What stands fixed with free bodies on it stands on the floor, too.
  const int floor = mj_name2id(loaded.model.get(), mjOBJ_GEOM, kFloorName.data());
  if (floor >= 0 && !document.host_frees && loaded.model->body_dofnum[1] == 0)
    LevelFloor(*loaded.model, floor);
  return state_->Examine(*loaded.model, object, mark, object.checks, findings,
                         WithFreeRoot(document),
                         [&](const std::string& text) { return state_->engine.LoadText(text); });
}

std::optional<Result> Laboratory::Examine(const std::filesystem::path& file,
                                          const model::Checks& checks, diag::Sources& sources,
                                          diag::Findings& findings) {
  diag::Findings of_reading;
  const std::optional<backport::ModelFile> xml = backport::ReadModelFile(file, sources, of_reading);
  if (!xml) {
    findings.Append(std::move(of_reading));
    return std::nullopt;
  }
  const std::string& text = xml->backported ? *xml->backported : sources.Text(xml->source);
  const diag::SourceMark start = {xml->source, 1, 1};
  const auto refused = [&](std::string_view what, const engine::Loaded& loaded, std::string hint) {
    findings.Add(Code::kMujocoError, start,
                 fmt::format("MuJoCo refused the model{}: {}", what,
                             engine::ParseRefusal(loaded.error).reason),
                 std::move(hint));
    return std::nullopt;
  };
  engine::Loaded loaded = backport::LoadFile(state_->engine, file, *xml);
  if (!loaded.model) return refused("", loaded, {});
  const model::Object object =
      compiled::ObjectOf(*loaded.model, start, compiled::Nameless::kNumbered);
  if (LacksFloor(*loaded.model)) {
    const std::string floor = FloorName(*loaded.model);
    loaded = state_->engine.LoadTextIn(FolderOf(file), WithFloor(file, text, object.name, floor));
    if (!loaded.model)
      return refused(" with a floor", loaded, "a plane in the file would be used instead");
    LevelFloor(*loaded.model, mj_name2id(loaded.model.get(), mjOBJ_GEOM, floor.c_str()));
  }
  return state_->Examine(*loaded.model, object, start, checks, findings, text,
                         [&](const std::string& changed) {
                           return state_->engine.LoadTextIn(FolderOf(file), changed);
                         });
}

}  // namespace mjforge::physics
