#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <concepts>
#include <memory>
#include <numbers>

#include "child.h"
#include "commands.h"
#include "completion.h"
#include "json.h"
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

/// What is known of a file.
struct Verdict {
  std::optional<validate::CompiledModel> model;
  std::optional<physics::Result> physics;
  diag::Findings findings;

  bool ok() const { return model.has_value() && !findings.HasErrors(); }
};

std::string Count(std::integral auto count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

// "; at rest after 0.19 s, tilt 0.1 deg, drift 0.2 mm, 4 contacts, 16 rows; 2 joints driven"
std::string Behaviour(const physics::Result& result) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::string text = "; not dropped";
  if (result.dropped) {
    text = fmt::format("; {} after {:g} s, tilt {:.3g} deg, drift {:.3g} mm",
                       result.at_rest ? "at rest" : "still moving", result.time,
                       kDegrees * result.tilt, 1000 * result.drift);
  }
  if (result.dropped || result.nefc > 0)
    text += fmt::format(", at most {} and {}", Count(result.ncon, "contact", "contacts"),
                        Count(result.nefc, "row", "rows"));
  if (!result.joints.empty())
    text += fmt::format("; {} driven", Count(result.joints.size(), "joint", "joints"));
  if (result.stability)
    text += fmt::format("; topples beyond {:.3g} deg", kDegrees * result.stability->angle);
  if (result.holds)
    text += fmt::format("; holds {} of {}", result.holds->held,
                        Count(result.holds->balls, "ball", "balls"));
  if (result.fits)
    text += fmt::format("; {} of {} into place", result.fits->fit,
                        Count(result.fits->tried, "thing goes", "things go"));
  if (!result.grasps.empty()) {
    const auto held = std::ranges::count(result.grasps, true, &physics::Result::Grasp::held);
    text += fmt::format("; held in {} of {}", held, Count(result.grasps.size(), "way", "ways"));
  }
  if (const auto& tests = result.simready) {
    text += fmt::format("; ground_drop {}, slope_drop {}, full_range_sweep {}, self_collision {}",
                        tests->ground_drop, tests->slope_drop, tests->full_range_sweep,
                        tests->self_collision);
  }
  return text;
}

std::string Line(const std::string& file, const Verdict& verdict) {
  const auto& model = verdict.model;
  if (!model) return fmt::format("{}: failed\n", file);
  return fmt::format("{}: {}, {}, {}, {}, {:.6g} kg{}\n", file, verdict.ok() ? "ok" : "failed",
                     Count(model->object.bodies.size(), "body", "bodies"),
                     Count(model->joints, "joint", "joints"), Count(model->geoms, "geom", "geoms"),
                     model->object.mass_properties.mass,
                     verdict.physics ? Behaviour(*verdict.physics) : "");
}

std::string JsonLine(const std::string& file, const Verdict& verdict,
                     const diag::Sources& sources) {
  Json json;
  json.StartObject();
  json.Member("file", file);
  json.Member("ok", verdict.ok());
  if (verdict.model) {
    json.Member("nbody", verdict.model->object.bodies.size() + 1);
    json.Member("njnt", verdict.model->joints);
    json.Member("ngeom", verdict.model->geoms);
    json.Member("mass", verdict.model->object.mass_properties.mass);
  }
  if (verdict.physics) {
    json.Key("physics");
    json.Raw(manifest::PhysicsJson(*verdict.physics));
  }
  json.Key("findings");
  json.StartArray();
  for (const diag::Finding& finding : verdict.findings)
    json.Raw(diag::RenderJson(finding, sources));
  json.EndArray();
  json.EndObject();
  return json.Line();
}

/// Who looks at the files; the laboratory only where it was asked for.
struct Judges {
  validate::Loader loader;
  std::optional<physics::Laboratory> laboratory;
  model::Checks checks;
};

ExitStatus Tell(const std::string& file, Verdict verdict, const diag::Sources& sources,
                const ValidateOptions& options, const Console& console) {
  ExitStatus status = StatusOf(verdict.findings);
  if (!verdict.model) status = Worse(status, ExitStatus::kFindings);
  const std::string name = file == "-" ? "<stdin>" : file;
  if (options.json) return Worse(status, Print(JsonLine(name, verdict, sources)));
  if (!console.quiet()) status = Worse(status, Print(Line(name, verdict)));
  console.Show(std::move(verdict.findings), sources);
  return status;
}

ExitStatus ValidateFile(const std::string& file, const ValidateOptions& options, Judges& judges,
                        const Console& console) {
  diag::Sources sources;
  Verdict verdict;
  verdict.model = judges.loader.Load(file, sources, verdict.findings);
  if (verdict.ok() && judges.laboratory)
    verdict.physics = judges.laboratory->Examine(file, judges.checks, sources, verdict.findings);
  return Tell(file, std::move(verdict), sources, options, console);
}

ExitStatus ValidateFiles(const ValidateOptions& options, Console& console) {
  Judges judges;
  if (options.physics) judges.laboratory.emplace();
  const auto checks =
      forge::LoadChecks(MakeSettings(options.settings), console.sources, console.findings);
  if (!checks) return Worse(console.Tell(), ExitStatus::kFindings);
  judges.checks = *checks;
  const auto validate = [&](std::size_t i) {
    const std::string& file = options.files[i];
    return ValidateFile(file, options, judges, console);
  };
  const auto crashed = [&](std::size_t i, const std::string& end) {
    Verdict verdict;
    AddCrash(options.files[i], end, verdict.findings);
    return Tell(options.files[i], std::move(verdict), {}, options, console);
  };
  return InChild(options.files.size(), options.time_limit, validate, crashed);
}

}  // namespace

Action AddValidate(CLI::App& command) {
  auto options = std::make_shared<ValidateOptions>();
  command.add_option("FILE", options->files, "Any MJCF file, or - (stdin)")
      ->required()
      ->option_text("...")
      ->check(Offers(".xml"));
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
