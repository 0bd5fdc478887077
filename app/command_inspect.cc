#include "inspect.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "inspect_batch.h"
#include "json.h"
#include "mjforge/expr/expr.h"
#include "options.h"
#include "usage.h"

namespace mjforge::app {
namespace {

struct InspectOptions {
  std::string what;
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  std::string contains;
  bool sweep = false;
  bool json = false;
  SpecOptions spec;
  ReportOptions report;
};

// "0.1,-2,3e-1"
std::optional<Eigen::Vector3d> ParsePoint(std::string_view text) {
  Eigen::Vector3d point;
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = text.substr(0, text.find(','));
    const bool last = word.size() == text.size();
    const std::optional<double> number = expr::ParseNumber(word);
    if (!number || last != (i == 2)) return std::nullopt;
    point[i] = *number;
    if (!last) text.remove_prefix(word.size() + 1);
  }
  return point;
}

ExitStatus PrintContains(const model::Object& object, const InspectOptions& options) {
  const bool inside = model::Contains(object, *ParsePoint(options.contains));
  if (!options.json) return Print(inside ? "inside\n" : "outside\n");
  Json json;
  json.StartObject();
  json.Member("contains", inside);
  json.EndObject();
  return Print(json.Line());
}

ExitStatus InspectSpec(const InspectOptions& options) {
  Console console(options.report);
  diag::Sources sources;
  diag::Findings findings;
  const std::optional<forge::Recipe> recipe =
      forge::LoadRecipe(options.what, MakeLoadOptions(options.spec), sources, findings);
  forge::Variant variant;
  if (recipe) {
    forge::Options generator_options;
    generator_options.seed = options.seed;
    generator_options.validation = forge::Validation::kNone;
    forge::Generator(*recipe, sources, generator_options).Make(options.index, variant);
    findings.Append(variant.findings);
  }
  std::optional<validate::Sweep> sweep;
  if (options.sweep && variant.object) {
    sweep = validate::Loader().SweepJoints(variant.document, *variant.object, findings);
  }
  const ExitStatus status = StatusOf(findings);
  console.Show(std::move(findings), sources);
  if (!variant.object) return status;
  if (!options.contains.empty()) return Worse(status, PrintContains(*variant.object, options));
  return Worse(status, Print(options.json ? InspectJson(*recipe, variant, sweep)
                                          : InspectTables(*recipe, variant, sweep)));
}

ExitStatus InspectFile(const InspectOptions& options) {
  if (!options.contains.empty()) return WrongUsage("--contains takes a spec", "inspect");
  diag::Sources sources;
  diag::Findings findings;
  validate::Loader loader;
  const std::optional<validate::CompiledModel> model = loader.Load(options.what, sources, findings);
  std::optional<validate::Sweep> sweep;
  if (options.sweep && model && findings.empty()) {
    sweep = loader.SweepJoints(options.what, sources, findings);
  }
  const ExitStatus status = StatusOf(findings);
  Console(options.report).Show(std::move(findings), sources);
  if (!model) return Worse(status, ExitStatus::kFindings);
  return Worse(status,
               Print(options.json ? InspectJson(*model, sweep) : InspectTables(*model, sweep)));
}

}  // namespace

Action AddInspect(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("inspect", "Show parameters and one variant, or a batch");
  auto options = std::make_shared<InspectOptions>();
  command.add_option("WHAT", options->what, "A spec, a FILE.xml, or the folder of a batch")
      ->required()
      ->option_text(" ");
  AddWholeNumber(command, "-s,--seed", options->seed, "Seed of all draws");
  AddWholeNumber(command, "--index", options->index, "The variant to show");
  AddSpecOptions(command, options->spec);
  CLI::Option* contains =
      command
          .add_option("--contains", options->contains, "Say whether a point (m) is inside a part")
          ->option_text("X,Y,Z");
  command.add_flag("--sweep", options->sweep, "Move the joints; show what gets into what")
      ->option_text(" ")
      ->excludes(contains);
  command.add_flag("--json", options->json, "One JSON object");
  AddReportOptions(command, options->report);
  AddExamples(command,
              "  mjforge inspect hammer\n"
              "  mjforge inspect hammer --index 41 --seed 7 --json\n"
              "  mjforge inspect hammer --contains 0,0,0.05\n"
              "  mjforge inspect robot.xml --sweep\n"
              "  mjforge inspect out/hammer_000041.xml\n"
              "  mjforge inspect out/ --json");
  return [options] {
    if (!options->contains.empty() && !ParsePoint(options->contains)) {
      return WrongUsage(fmt::format("--contains: '{}' is not of the form X,Y,Z", options->contains),
                        "inspect");
    }
    if (const auto manifest = FindManifest(options->what)) {
      if (options->sweep || !options->contains.empty())
        return WrongUsage("--sweep and --contains take one object, not a batch", "inspect");
      Console console(options->report);
      return InspectBatch(*manifest, options->json, console);
    }
    return options->what.ends_with(".xml") ? InspectFile(*options) : InspectSpec(*options);
  };
}

}  // namespace mjforge::app
