// Loads models of objects and files, adds floors, and runs the tests that the checks request.
#include "mjforge/physics/physics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string_view>

#include "mjforge/backport/backport.h"
#include "mjforge/bytes/bytes.h"
#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/behaviour.h"
#include "mjforge/physics/floor.h"
#include "mjforge/physics/gripper.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/joint_drive.h"
#include "mjforge/physics/model_checks.h"
#include "mjforge/physics/probe_checks.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"
#include "mjforge/xml/xml.h"

namespace mjforge::physics {
namespace {

using diag::Code;

constexpr std::string_view kFloorName = "mjforge-floor";
// Free joint of the root, and a negligible mass for the root. The root and its only child may be
// massless, and MuJoCo rejects moving bodies that are lighter than mjMINVAL (1e-15).
constexpr std::string_view kFree =
    R"(<joint name="mjforge-free" type="free"/>)"
    R"(<inertial pos="0 0 0" mass="1e-14" diaginertia="1e-14 1e-14 1e-14"/>)";

std::string FloorElement(std::string_view name) {
  return fmt::format(R"(<geom name="{}" type="plane" size="0 0 1"/>)", name);
}

/// Returns the text of a document with the free joint that the host (the program for which the
/// document was written) would add. Adds no line ends, which would change line numbers; neither
/// does WithSurroundings().
std::string WithFreeRoot(const mjcf::MjcfDocument& document) {
  std::string text = document.text;
  if (document.world_position == std::string::npos || !document.host_adds_free_joint) return text;
  return text.insert(text.find('\n', document.world_position) + 1, kFree);
}

/// Returns the text of a document with a floor, and with the free joint that the host would add.
std::string WithSurroundings(const mjcf::MjcfDocument& document) {
  std::string text = WithFreeRoot(document);
  if (document.world_position == std::string::npos) return text;
  return text.insert(document.world_position, FloorElement(kFloorName));
}

/// Rounds to four digits, and numbers below 1e-9 to 0, because further digits depend on the last
/// bits of a long simulation.
double Rounded(double number) {
  if (std::abs(number) < 1e-9) return 0;
  return expr::ParseNumber(fmt::format("{:.3e}", number)).value_or(number);
}

void Round(Result& result) {
  const auto round = [](auto&... numbers) { ((numbers = Rounded(numbers)), ...); };
  round(result.time, result.drift, result.tilt, result.speed, result.penetration, result.sink,
        result.energy_gain, result.overlap);
  if (result.settled) round(result.settled->distance, result.settled->angle);
  if (result.stability) round(result.stability->angle, result.stability->energy);
  for (Result::Grasp& grasp : result.grasps) {
    for (double& number : grasp.pos) round(number);
    for (double& number : grasp.quat) round(number);
    round(grasp.width);
  }
  for (Result::Joint& joint : result.joints)
    round(joint.overshoot, joint.reach, joint.penetration, joint.return_error);
  for (Result::Equality& equality : result.equalities) round(equality.error, equality.share);
}

/// Returns true if a model has free bodies but no plane.
bool LacksFloor(const mjModel& m) {
  return std::count(m.jnt_type, m.jnt_type + m.njnt, mjJNT_FREE) > 0 &&
         std::count(m.geom_type, m.geom_type + m.ngeom, mjGEOM_PLANE) == 0;
}

/// Returns a name for the floor that no geom of the model has.
std::string FloorName(const mjModel& m) {
  std::string name(kFloorName);
  while (mj_name2id(&m, mjOBJ_GEOM, name.c_str()) >= 0) name += '-';
  return name;
}

std::filesystem::path FolderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

/// Returns an MJCF text that includes `file` and adds a floor with the name `floor`; the text must
/// be loaded in the folder of the file. If `file` is empty, returns `text` with the floor.
std::string WithFloor(const std::filesystem::path& file, std::string text, std::string_view model,
                      const std::string& floor) {
  const std::string world = fmt::format("<worldbody>{}</worldbody>", FloorElement(floor));
  if (!file.empty()) {
    // compiled::StartOf() finds the start pose by the model's name.
    return fmt::format(R"(<mujoco model="{}"><include file="{}"/>{}</mujoco>)",
                       xml::EscapeXml(model), xml::EscapeXml(file.string()), world);
  }
  const std::size_t end = text.rfind("</mujoco");
  if (end != text.npos) text.insert(end, world);
  return text;
}

/// Adds an error about a file that MuJoCo rejects, or that was not passed to MuJoCo because of a
/// fault in the file. `what` names the change that was made to the file, for the message; `start`
/// is the first place in the file.
void AddFileRefusal(std::string_view what, const engine::Loaded& loaded,
                    const diag::Sources& sources, diag::SourceMark start, std::string hint,
                    diag::Findings& findings) {
  if (loaded.fault) {
    findings.Add(loaded.fault->code, xml::MarkOfLine(sources, start.file, loaded.fault->line),
                 loaded.error);
    return;
  }
  findings.Add(Code::kMujocoError, start,
               fmt::format("MuJoCo refused the model{}: {}", what,
                           engine::ParseRefusal(loaded.error).reason),
               std::move(hint));
}

/// Returns the result of a simulation. If MuJoCo fails, adds a finding and returns nullopt.
template <typename Simulation>
auto Guarded(const model::Object& object, diag::SourceMark mark, diag::Findings& findings,
             const Simulation& simulate) -> decltype(simulate()) {
  try {
    return simulate();
  } catch (const std::bad_alloc&) {
    throw;  // this is no failure of MuJoCo
  } catch (const BuffersTooLarge&) {
    findings.Warn(Code::kMujocoOlder, mark,
                  fmt::format("'{}' is not simulated: MuJoCo {} has no room for its contacts",
                              object.name, engine::Version()),
                  "simulate it with a later release, or make its collision geoms simpler");
  } catch (const std::exception& error) {
    findings.Add(
        Code::kMujocoError, mark,
        fmt::format("MuJoCo cannot simulate the object: {}", engine::OneLine(error.what())));
  }
  return std::nullopt;
}

diag::SourceMark MarkOf(const model::Object& object) {
  return object.bodies.empty() ? diag::SourceMark{} : object.bodies.front().mark;
}

}  // namespace

struct Laboratory::Impl {
  engine::Engine engine;
  Workspace workspace;

  /// Loads the model from a text to which probe bodies were added.
  using Load = std::function<engine::Loaded(const std::string& text)>;

  std::optional<Result> Examine(mjModel& m, const model::Object& object, diag::SourceMark mark,
                                const model::Checks& checks, diag::Findings& findings,
                                std::string_view text, const Load& load) {
    static_checks::Reporter reporter(checks, findings);
    return Guarded(object, mark, findings, [&]() -> std::optional<Result> {
      Result result;
      const ModelTest test = {m, workspace, object, mark, reporter, result};
      CheckBehaviour(test);
      result.overlap = static_checks::CheckProportions(object, mark, reporter);
      static_checks::CheckContacts(object, reporter);
      CheckFrictionCones(test);
      const std::span<const mjtNum> start = compiled::StartOf(m);
      const auto probe = [&](const std::string& with_probes, void (*check)(const ProbeTest&)) {
        const engine::Loaded loaded = load(with_probes);
        if (!loaded.model) throw std::runtime_error(engine::ParseRefusal(loaded.error).reason);
        check({{*loaded.model, workspace, object, mark, reporter, result}, start});
      };
      if (checks.settled) CheckSettled(test);
      if (checks.holds) probe(WithBalls(text, *checks.holds), CheckContainment);
      if (!checks.fits.empty()) probe(WithPegs(text, checks), CheckPegInHole);
      if (checks.grasps) probe(WithGripper(text, *checks.grasps), CheckGrasps);
      Round(result);
      return result;
    });
  }

  /// Loads the model of a document with a floor. If MuJoCo rejects the model, adds a finding and
  /// returns null.
  engine::Model LoadOnFloor(const mjcf::MjcfDocument& document, diag::SourceMark mark,
                            diag::Findings& findings) {
    engine::Loaded loaded = engine.LoadText(WithSurroundings(document), document.assets);
    if (!loaded.model) {
      findings.Add(Code::kMujocoError, mark,
                   fmt::format("MuJoCo refused the object on a floor: {}",
                               engine::ParseRefusal(loaded.error).reason));
      return nullptr;
    }
    // Lowers the floor of an object that is fixed to the world, because free bodies of the object
    // may be lower than the floor.
    const int floor = mj_name2id(loaded.model.get(), mjOBJ_GEOM, kFloorName.data());
    if (floor >= 0 && !document.host_adds_free_joint && loaded.model->body_dofnum[1] == 0)
      LevelFloor(*loaded.model, floor);
    return std::move(loaded.model);
  }
};

Laboratory::Laboratory() : impl_(std::make_unique<Impl>()) {}
Laboratory::~Laboratory() = default;

std::optional<Result> Laboratory::Examine(const mjcf::MjcfDocument& document,
                                          const model::Object& object, diag::Findings& findings) {
  const diag::SourceMark mark = MarkOf(object);
  const engine::Model model = impl_->LoadOnFloor(document, mark, findings);
  if (!model) return std::nullopt;
  return impl_->Examine(*model, object, mark, object.checks, findings, WithFreeRoot(document),
                        [&](const std::string& text) { return impl_->engine.LoadText(text); });
}

std::optional<Film> Laboratory::Record(const mjcf::MjcfDocument& document,
                                       const model::Object& object, const std::string& joint,
                                       std::size_t frames, diag::Findings& findings) {
  const diag::SourceMark mark = MarkOf(object);
  const engine::Model model = impl_->LoadOnFloor(document, mark, findings);
  if (!model) return std::nullopt;
  FilmRecorder recorder;
  diag::Findings of_checks;  // discarded, because Examine() reports them
  static_checks::Reporter reporter(object.checks, of_checks);
  return Guarded(object, mark, findings, [&]() -> std::optional<Film> {
    const int id = joint.empty() ? -1 : mj_name2id(model.get(), mjOBJ_JOINT, joint.c_str());
    if (joint.empty()) {
      Result unused;
      RecordDrop({*model, impl_->workspace, object, mark, reporter, unused}, recorder);
    } else if (!JointChecks(*model, object.name, object.checks).Verify(reporter) || id < 0 ||
               !RecordDrive(*model, impl_->workspace.For(*model), object.name, object.checks, id,
                            recorder)) {
      findings.Add(Code::kPictureBadJointValue, mark,
                   fmt::format("joint '{}' has no range through which it can be driven", joint));
      return std::nullopt;
    }
    return recorder.Finish(frames);
  });
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
    AddFileRefusal(what, loaded, sources, start, std::move(hint), findings);
    return std::nullopt;
  };
  engine::Loaded loaded = backport::LoadFile(impl_->engine, file, *xml);
  if (!loaded.model) return refused("", loaded, {});
  const model::Object object =
      compiled::ObjectOf(*loaded.model, start, compiled::Nameless::kNumbered);
  if (LacksFloor(*loaded.model)) {
    const std::string floor = FloorName(*loaded.model);
    const bool is_text = xml->backported || file == bytes::kStandardInput;
    loaded = impl_->engine.LoadTextIn(
        FolderOf(file), WithFloor(is_text ? "" : file.filename(), text, object.name, floor));
    if (!loaded.model)
      return refused(" with a floor", loaded, "a plane in the file would be used instead");
    LevelFloor(*loaded.model, mj_name2id(loaded.model.get(), mjOBJ_GEOM, floor.c_str()));
  }
  return impl_->Examine(*loaded.model, object, start, checks, findings, text,
                        [&](const std::string& changed) {
                          return impl_->engine.LoadTextIn(FolderOf(file), changed);
                        });
}

}  // namespace mjforge::physics
