// `mjforge validate`: loads MJCF files in MuJoCo and simulates them with --physics.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <concepts>
#include <memory>
#include <numbers>

#include "child_process.h"
#include "commands.h"
#include "json_output.h"
#include "mjforge/forge/forge.h"
#include "options.h"

namespace mjforge::app {
namespace {

struct ValidateOptions {
  Seconds time_limit{60};
  std::vector<std::string> files;
  bool physics = false;
  std::vector<std::string> settings;
  bool json = false;
};

// Result of loading and simulating a file.
struct FileResult {
  std::optional<validate::CompiledModel> model;
  std::optional<physics::Result> physics;
  diag::Findings findings;

  bool ok() const { return model.has_value() && !findings.HasErrors(); }
};

// Returns the measurements of a simulated file: "; at rest after 0.19 s, tilt 0.1 deg, drift 0.2
// mm, 4 contacts, 16 rows; 2 joints driven".
std::string Behaviour(const physics::Result& result) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::string text = "; not dropped";
  if (result.dropped) {
    text = fmt::format("; {} after {:g} s, tilt {:.3g} deg, drift {:.3g} mm",
                       result.at_rest ? "at rest" : "still moving", result.time,
                       kDegrees * result.tilt, 1000 * result.drift);
  }
  if (result.dropped || result.nefc > 0)
    text += fmt::format(", at most {} and {}", Counted(result.ncon, "contact"),
                        Counted(result.nefc, "row"));
  if (!result.joints.empty())
    text += fmt::format("; {} driven", Counted(result.joints.size(), "joint"));
  if (result.stability)
    text += fmt::format("; topples beyond {:.3g} deg", kDegrees * result.stability->angle);
  if (result.holds)
    text +=
        fmt::format("; holds {} of {}", result.holds->held, Counted(result.holds->balls, "ball"));
  if (result.settled)
    text +=
        fmt::format("; {} of {} where they start", result.settled->bodies - result.settled->moved,
                    Counted(result.settled->bodies, "body stays", "bodies stay"));
  if (result.fits)
    text += fmt::format("; {} of {} into place", result.fits->fit,
                        Counted(result.fits->tried, "thing goes", "things go"));
  if (!result.grasps.empty()) {
    const auto held = std::ranges::count(result.grasps, true, &physics::Result::Grasp::held);
    text += fmt::format("; held in {} of {}", held, Counted(result.grasps.size(), "way"));
  }
  if (const auto& tests = result.simready) {
    text += fmt::format("; ground_drop {}, slope_drop {}, full_range_sweep {}, self_collision {}",
                        tests->ground_drop, tests->slope_drop, tests->full_range_sweep,
                        tests->self_collision);
  }
  return text;
}

std::string Line(const std::string& file, const FileResult& result) {
  const auto& model = result.model;
  if (!model) return fmt::format("{}: failed\n", file);
  return fmt::format("{}: {}, {}, {}, {}, {:.6g} kg{}\n", file, result.ok() ? "ok" : "failed",
                     Counted(model->object.bodies.size(), "body", "bodies"),
                     Counted(model->joints, "joint"), Counted(model->geoms, "geom"),
                     model->object.mass_properties.mass,
                     result.physics ? Behaviour(*result.physics) : "");
}

std::string FileJson(const std::string& file, const FileResult& result,
                     const diag::Sources& sources) {
  return JsonLine([&](diag::Json& json) {
    json.Member("file", file);
    json.Member("ok", result.ok());
    if (result.model) {
      json.Member("nbody", result.model->object.bodies.size() + 1);
      json.Member("njnt", result.model->joints);
      json.Member("ngeom", result.model->geoms);
      json.Member("mass", result.model->object.mass_properties.mass);
    }
    if (result.physics) {
      json.Key("physics");
      json.Raw(manifest::PhysicsJson(*result.physics));
    }
    json.List("findings", result.findings,
              [&](const diag::Finding& finding) { json.Raw(diag::RenderJson(finding, sources)); });
  });
}

// Loader and simulator for all files, one after the other. `laboratory` is nullopt without
// --physics.
struct Validators {
  validate::Loader loader;
  std::optional<physics::Laboratory> laboratory;
  model::Checks checks;
};

ExitStatus ReportFile(const std::string& file, FileResult result, const diag::Sources& sources,
                      const ValidateOptions& options, const Console& console) {
  ExitStatus status = StatusOf(result.findings);
  if (!result.model) status = Worse(status, ExitStatus::kFindings);
  const std::string name = file == "-" ? "<stdin>" : file;
  if (options.json) return Worse(status, PrintBytes(FileJson(name, result, sources)));
  if (!console.quiet()) status = Worse(status, Print(Line(OneLine(name), result)));
  console.Show(std::move(result.findings), sources);
  return status;
}

ExitStatus ValidateFile(const std::string& file, const ValidateOptions& options,
                        Validators& validators, const Console& console) {
  diag::Sources sources;
  FileResult result;
  result.model = validators.loader.Load(file, sources, result.findings);
  if (result.ok() && validators.laboratory)
    result.physics =
        validators.laboratory->Examine(file, validators.checks, sources, result.findings);
  return ReportFile(file, std::move(result), sources, options, console);
}

ExitStatus ValidateFiles(const ValidateOptions& options, Console& console) {
  Validators validators;
  if (options.physics) validators.laboratory.emplace();
  const auto checks =
      forge::LoadChecks(MakeSettings(options.settings), console.sources, console.findings);
  if (!checks) return Worse(console.Report(), ExitStatus::kFindings);
  validators.checks = *checks;
  const auto validate = [&](std::size_t i) {
    const std::string& file = options.files[i];
    return ValidateFile(file, options, validators, console);
  };
  const auto crashed = [&](std::size_t i, const std::string& end) {
    FileResult result;
    AddCrashFinding(options.files[i], end, result.findings);
    return ReportFile(options.files[i], std::move(result), {}, options, console);
  };
  return RunInChild(options.files.size(), options.time_limit, validate, crashed);
}

}  // namespace

Action AddValidate(CLI::App& command) {
  auto options = std::make_shared<ValidateOptions>();
  AddArguments(command, "FILE", options->files, "Any MJCF file, or - (stdin)", ".xml");
  CLI::Option* physics =
      command.add_flag("--physics", options->physics, "Simulate each: does it behave?");
  AddSettings(command, options->settings, "Set a threshold: checks.NAME=VALUE");
  command.get_option("--set")->needs(physics);
  AddProfile(command, options->settings, [options] { options->physics = true; });
  AddTimeLimit(command, options->time_limit);
  command.add_flag("--json", options->json, "One JSON object per file, findings included");
  return [options](Console& console) { return ValidateFiles(*options, console); };
}

}  // namespace mjforge::app
