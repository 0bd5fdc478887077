#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "json.h"
#include "mjforge/forge/forge.h"
#include "options.h"

namespace mjforge::app {
namespace {

struct ValidateOptions {
  std::vector<std::string> files;
  bool json = false;
  ReportOptions report;
};

std::string Count(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string Line(const std::string& file, const std::optional<validate::CompiledModel>& model,
                 bool ok) {
  if (!model) return fmt::format("{}: failed\n", file);
  return fmt::format(
      "{}: {}, {}, {}, {}, {:.6g} kg\n", file, ok ? "ok" : "failed",
      Count(model->bodies.size(), "body", "bodies"), Count(model->joints.size(), "joint", "joints"),
      Count(static_cast<std::size_t>(model->geoms), "geom", "geoms"), model->mass_properties.mass);
}

std::string JsonLine(const std::string& file, const std::optional<validate::CompiledModel>& model,
                     const diag::Findings& findings, const diag::Sources& sources) {
  Json json;
  json.StartObject();
  json.Member("file", file);
  json.Member("ok", model.has_value() && !findings.HasErrors());
  if (model) {
    json.Member("nbody", model->bodies.size() + 1);
    json.Member("njnt", model->joints.size());
    json.Member("ngeom", static_cast<std::size_t>(model->geoms));
    json.Member("mass", model->mass_properties.mass);
  }
  json.Key("findings");
  json.StartArray();
  for (const diag::Finding& finding : findings) json.Raw(diag::RenderJson(finding, sources));
  json.EndArray();
  json.EndObject();
  return json.Line();
}

ExitStatus ValidateFile(const std::string& file, const ValidateOptions& options,
                        validate::Loader& loader) {
  diag::Sources sources;
  diag::Findings findings;
  const std::optional<validate::CompiledModel> model = loader.Load(file, sources, findings);
  const ExitStatus status = StatusOf(findings);
  const ExitStatus printed = Print(options.json ? JsonLine(file, model, findings, sources)
                                                : Line(file, model, status == ExitStatus::kDone));
  if (!options.json) Console(options.report).Show(std::move(findings), sources);
  return Worse(printed, model ? status : Worse(status, ExitStatus::kFindings));
}

}  // namespace

Action AddValidate(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("validate", "Load MJCF files in MuJoCo");
  auto options = std::make_shared<ValidateOptions>();
  command.add_option("FILE", options->files, "Any MJCF file")->required()->option_text("...");
  command.add_flag("--json", options->json, "One JSON object a file, findings included");
  AddReportOptions(command, options->report);
  AddExamples(command,
              "  mjforge validate out/*.xml\n"
              "  mjforge validate robot.xml --json");
  return [options] {
    validate::Loader loader;
    ExitStatus status = ExitStatus::kDone;
    for (const std::string& file : options->files) {
      status = Worse(status, ValidateFile(file, *options, loader));
    }
    return status;
  };
}

}  // namespace mjforge::app
