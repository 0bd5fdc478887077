#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "mjforge/forge/forge.h"
#include "options.h"
#include "usage.h"
#include "viewer.h"

namespace mjforge::app {
namespace {

struct ViewOptions {
  std::string what;
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  SpecOptions spec;
  ReportOptions report;

  bool is_file() const { return what.ends_with(".xml"); }
};

class View {
 public:
  explicit View(const ViewOptions& options) : options_(options), console_(options.report) {}

  ExitStatus operator()() {
    ExitStatus status = options_.is_file() ? ShowFile() : ShowVariant();
    status = Worse(status, StatusOf(findings_));
    console_.Show(std::move(findings_), sources_);
    return status;
  }

 private:
  ExitStatus ShowFile() {
    if (!validate::Loader().Load(options_.what, sources_, findings_)) return ExitStatus::kFindings;
    const auto viewer = FindViewer(findings_);
    const auto folder = viewer ? TemporaryFolder::Make(findings_) : std::nullopt;
    if (!folder) return ExitStatus::kFindings;
    return RunViewer(*viewer, std::filesystem::absolute(options_.what), folder->path(), findings_);
  }

  ExitStatus ShowVariant() {
    const std::optional<forge::Recipe> recipe =
        forge::LoadRecipe(options_.what, MakeLoadOptions(options_.spec), sources_, findings_);
    if (!recipe) return ExitStatus::kFindings;
    forge::Options options;
    options.seed = options_.seed;
    options.target = mjcf::Target::kScene;
    forge::Variant variant;
    forge::Generator(*recipe, sources_, options).Make(options_.index, variant);
    findings_.Append(variant.findings);
    if (!variant.ok()) return ExitStatus::kFindings;
    const auto viewer = FindViewer(findings_);
    const auto folder = viewer ? TemporaryFolder::Make(findings_) : std::nullopt;
    if (!folder) return ExitStatus::kFindings;
    const std::string name = variant.record.name + ".xml";
    if (!output::ObjectFolder(folder->path(), {}).Write(name, variant.document, findings_))
      return ExitStatus::kInputOutput;
    return RunViewer(*viewer, folder->path() / name, folder->path(), findings_);
  }

  const ViewOptions& options_;
  Console console_;
  diag::Sources sources_;
  diag::Findings findings_;
};

}  // namespace

Action AddView(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("view", "Open an object in MuJoCo's own viewer");
  auto options = std::make_shared<ViewOptions>();
  command.add_option("WHAT", options->what, "A spec or a FILE.xml")->required()->option_text(" ");
  AddWholeNumber(command, "-s,--seed", options->seed, "Seed of all draws");
  AddWholeNumber(command, "--index", options->index, "The variant to show");
  AddSpecOptions(command, options->spec);
  AddReportOptions(command, options->report);
  AddExamples(command,
              "  mjforge view hammer --index 41\n"
              "  mjforge view robot.xml");
  return [options] {
    const bool has_settings =
        !options->spec.settings.empty() || !options->spec.parameter_files.empty();
    if (options->is_file() && (has_settings || options->seed != 0 || options->index != 0))
      return WrongUsage("--seed, --index, --set, --root and --params take a spec, not a file",
                        "view");
    return View(*options)();
  };
}

}  // namespace mjforge::app
