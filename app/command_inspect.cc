// `mjforge inspect`: shows a spec's parameters and one variant, an MJCF file, or a batch.
#include "inspect.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "child_process.h"
#include "commands.h"
#include "json_output.h"
#include "mjforge/expr/expr.h"
#include "options.h"
#include "usage.h"

namespace mjforge::app {
namespace {

struct InspectOptions : ObjectOptions {
  std::string contains;
  Seconds time_limit{60};
  bool sweep = false;
  bool json = false;
};

// Parses the three coordinates of a point: "0.1,-2,3e-1".
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
  return PrintBytes(JsonLine([&](diag::Json& json) { json.Member("contains", inside); }));
}

ExitStatus InspectSpec(const InspectOptions& options, Console& console) {
  const std::optional<forge::Recipe> recipe = LoadRecipe(options.what, options.spec, console);
  forge::Variant variant;
  if (recipe) {
    const forge::Options generation = {.seed = options.spec.seed,
                                       .place_seed = options.spec.place_seed,
                                       .validation = forge::Validation::kNone};
    forge::Generator(*recipe, console.sources, generation).Make(options.index, variant);
    console.findings.Append(variant.findings);
  }
  std::optional<validate::Sweep> sweep;
  if (options.sweep && variant.object)
    sweep = validate::Loader().SweepJoints(variant.document, *variant.object, console.findings);
  const ExitStatus status = console.Report();
  if (!variant.object) return status;
  if (!options.contains.empty()) return Worse(status, PrintContains(*variant.object, options));
  return Worse(status, options.json ? PrintBytes(InspectJson(*recipe, variant, sweep))
                                    : Print(InspectTables(*recipe, variant, sweep)));
}

ExitStatus InspectFile(const InspectOptions& options, Console& console) {
  if (!options.contains.empty()) return WrongUsage("--contains takes a spec", "inspect");
  validate::Loader loader;
  const auto model = loader.Load(options.what, console.sources, console.findings);
  std::optional<validate::Sweep> sweep;
  if (options.sweep && model && !console.findings.HasErrors())
    sweep = loader.SweepJoints(options.what, console.sources, console.findings);
  const ExitStatus status = console.Report();
  if (!model) return Worse(status, ExitStatus::kFindings);
  return Worse(status, options.json ? PrintBytes(InspectJson(*model, sweep))
                                    : Print(InspectTables(*model, sweep)));
}

ExitStatus Inspect(const InspectOptions& options, Console& console) {
  if (!options.contains.empty() && !ParsePoint(options.contains)) {
    return WrongUsage(fmt::format("--contains: '{}' is not of the form X,Y,Z", options.contains),
                      "inspect");
  }
  const auto manifest = FindManifest(options.what);
  const bool is_file = !manifest && IsMjcf(options.what);
  if (manifest && (options.sweep || !options.contains.empty()))
    return WrongUsage("--sweep and --contains take one object, not a batch", "inspect");
  const std::string wrong = manifest || is_file ? RefuseSpecOptions(options.what, options.spec,
                                                                    options.index > 0, "--index")
                                                : "";
  if (!wrong.empty()) return WrongUsage(wrong, "inspect");
  if (manifest) return InspectBatch(*manifest, options.json, console);
  return RunInChild(options.what, options.time_limit, console, [&] {
    return is_file ? InspectFile(options, console) : InspectSpec(options, console);
  });
}

}  // namespace

Action AddInspect(CLI::App& command) {
  auto options = std::make_shared<InspectOptions>();
  AddObjectOptions(command, *options, "A spec, a FILE.xml, or the folder of a batch");
  CLI::Option* contains =
      command
          .add_option("--contains", options->contains, "Say whether a point (m) is inside a part")
          ->option_text("X,Y,Z");
  command.add_flag("--sweep", options->sweep, "Move the joints; show which bodies collide")
      ->option_text(" ")
      ->excludes(contains);
  AddTimeLimit(command, options->time_limit);
  command.add_flag("--json", options->json, "One JSON object");
  return [options](Console& console) { return Inspect(*options, console); };
}

}  // namespace mjforge::app
