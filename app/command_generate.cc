#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <limits>
#include <memory>
#include <set>

#include "commands.h"
#include "interrupt.h"
#include "mjforge/forge/forge.h"
#include "options.h"
#include "usage.h"

namespace mjforge::app {
namespace {

struct GenerateOptions {
  std::vector<std::string> specs;
  std::uint64_t count = 1;
  std::uint64_t seed = 0;
  std::uint64_t first = 0;
  std::string output;
  std::string name;
  std::string target = "mujoco";
  std::string validate = "load";
  std::string on_invalid = "fail";
  bool force = false;
  SpecOptions spec;
  ReportOptions report;
};

enum class Destination { kFolder, kFile, kStandardOutput };

Destination DestinationOf(const GenerateOptions& options) {
  if (options.output == "-") return Destination::kStandardOutput;
  return options.output.ends_with(".xml") ? Destination::kFile : Destination::kFolder;
}

// What is wrong with options that are right one by one; empty: nothing.
std::string Contradiction(const GenerateOptions& options) {
  if (options.count - 1 > std::numeric_limits<std::uint64_t>::max() - options.first) {
    return "--first and -n lead beyond the largest index";
  }
  if (options.output.ends_with(".tar") || options.output.ends_with(".zst")) {
    return fmt::format("'{}': the output is a folder, an .xml file or -", options.output);
  }
  if (DestinationOf(options) == Destination::kFolder) return {};
  if (options.count > 1) {
    return fmt::format("-o {} takes one variant, -n asks for {}", options.output, options.count);
  }
  if (options.specs.size() > 1) {
    return fmt::format("-o {} takes one spec, {} are given", options.output, options.specs.size());
  }
  return {};
}

ExitStatus StatusOf(const forge::Summary& summary) {
  if (summary.interrupted) return ExitStatus::kInterrupted;
  if (summary.output_failed) return ExitStatus::kInputOutput;
  const bool nothing = summary.ok == 0 && summary.skipped > 0;
  return summary.failed > 0 || nothing ? ExitStatus::kFindings : ExitStatus::kDone;
}

// "97 ok, 3 failed (0.2 s)"
std::string Counts(const forge::Summary& summary, std::chrono::steady_clock::time_point start) {
  std::string text = fmt::format("{} ok", summary.ok);
  if (summary.failed > 0) text += fmt::format(", {} failed", summary.failed);
  if (summary.skipped > 0) text += fmt::format(", {} skipped", summary.skipped);
  if (summary.interrupted) text += ", interrupted";
  if (summary.output_failed) text += ", stopped: output failed";
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return text + fmt::format(" ({:.1f} s)", seconds.count());
}

// The run of one `generate`.
class Run {
 public:
  explicit Run(const GenerateOptions& options)
      : options_(options), console_(options.report), stop_(CatchInterrupts()) {}

  ExitStatus operator()() {
    Load();
    if (status_ != ExitStatus::kDone) return status_;
    if (options_.validate == "load") loader_.emplace();
    for (const forge::Recipe& recipe : recipes_) {
      status_ = Worse(status_, Make(recipe));
      if (status_ >= ExitStatus::kInputOutput) break;
    }
    return status_;
  }

 private:
  // All specs first: a mistake in the last one must not show after an hour.
  void Load() {
    diag::Findings findings;
    if (!options_.name.empty() && !forge::CheckName(options_.name, findings)) {
      console_.Show(std::move(findings), sources_);
      status_ = ExitStatus::kUsage;
      return;
    }
    const spec::LoadOptions load = MakeLoadOptions(options_.spec);
    std::set<std::string> names;
    for (const std::string& spec : options_.specs) {
      std::optional<forge::Recipe> recipe = forge::LoadRecipe(spec, load, sources_, findings);
      if (!recipe) continue;
      const std::string& name = recipe->spec->name;
      if (!names.insert(name).second) {
        findings.Add(diag::Code::kOutputBadName, {},
                     fmt::format("two specs are named '{}' and would share a folder", name),
                     "generate them one by one");
      }
      recipes_.push_back(*std::move(recipe));
    }
    status_ = app::StatusOf(findings);
    console_.Show(std::move(findings), sources_);
  }

  forge::Options GeneratorOptions() const {
    forge::Options options;
    options.seed = options_.seed;
    options.target = *mjcf::FindTarget(options_.target);
    options.name = options_.name;
    options.resample = options_.on_invalid == "resample";
    return options;
  }

  ExitStatus Make(const forge::Recipe& recipe) {
    forge::Generator generator(recipe, sources_, GeneratorOptions(), loader_ ? &*loader_ : nullptr);
    return DestinationOf(options_) == Destination::kFolder ? MakeFolder(recipe, generator)
                                                           : MakeOne(recipe, generator);
  }

  std::filesystem::path FolderOf(const forge::Recipe& recipe) const {
    const bool own_name = options_.specs.size() == 1 && !options_.name.empty() &&
                          options_.name.find('$') == std::string::npos;
    const std::string name = own_name ? options_.name : recipe.spec->name;
    if (options_.output.empty()) return name;
    if (options_.specs.size() == 1) return options_.output;
    return std::filesystem::path(options_.output) / name;
  }

  ExitStatus MakeFolder(const forge::Recipe& recipe, forge::Generator& generator) {
    const auto start = std::chrono::steady_clock::now();
    forge::Batch batch;
    batch.first = options_.first;
    batch.count = options_.count;
    batch.stop = &stop_;
    if (options_.on_invalid == "skip") batch.on_invalid = forge::OnInvalid::kSkip;
    const std::filesystem::path folder = FolderOf(recipe);
    const forge::Summary summary =
        forge::MakeFolder(generator, batch, folder, options_.force, Watch(folder));
    console_.Show(summary.findings, sources_, summary.more_findings);
    std::string place = folder.string();
    if (!place.ends_with('/')) place += '/';
    console_.Say(fmt::format("{} variant{} of {} in {}: {}", options_.count,
                             options_.count == 1 ? "" : "s", recipe.spec->name, place,
                             Counts(summary, start)));
    return StatusOf(summary);
  }

  std::function<void(const forge::Variant&)> Watch(const std::filesystem::path& folder) {
    if (!console_.verbose()) return {};
    return [this, folder](const forge::Variant& variant) {
      const output::Record& record = variant.record;
      const std::string place = record.file.empty()
                                    ? fmt::format("{} {}", record.name, record.index)
                                    : (folder / record.file).string();
      console_.Say(fmt::format("{}: {}, attempt {}", place, record.status, record.attempt));
    };
  }

  // One variant, to a file or to standard output.
  ExitStatus MakeOne(const forge::Recipe& recipe, forge::Generator& generator) {
    const auto start = std::chrono::steady_clock::now();
    const bool to_file = DestinationOf(options_) == Destination::kFile;
    forge::Batch batch;
    batch.first = options_.first;
    std::string text;
    const forge::Summary summary =
        forge::MakeBatch(generator, batch, [&](const forge::Variant& variant, auto& findings) {
          if (!variant.ok()) return true;
          if (to_file) {
            return output::WriteObject(options_.output, variant.document, options_.force, findings);
          }
          WarnOfAssets(variant.document, findings);
          text = variant.document.text;
          return true;
        });
    console_.Show(summary.findings, sources_, summary.more_findings);
    if (to_file) {
      console_.Say(fmt::format("1 variant of {} in {}: {}", recipe.spec->name, options_.output,
                               Counts(summary, start)));
    }
    return Worse(StatusOf(summary), Print(text));
  }

  static void WarnOfAssets(const mjcf::MjcfDocument& document, diag::Findings& findings) {
    if (document.assets.empty()) return;
    findings.Warn(diag::Code::kOutputCannotWrite, {},
                  fmt::format("the object needs '{}', which standard output cannot carry",
                              document.assets.front().first),
                  "write to a file or a folder to have its assets beside it");
  }

  const GenerateOptions& options_;
  Console console_;
  const std::atomic<bool>& stop_;
  diag::Sources sources_;
  std::vector<forge::Recipe> recipes_;
  std::optional<validate::Loader> loader_;
  ExitStatus status_ = ExitStatus::kDone;
};

std::vector<std::string> TargetNames() {
  std::vector<std::string> names;
  for (const mjcf::TargetRules& info : mjcf::Targets()) names.emplace_back(info.name);
  return names;
}

void AddOptions(CLI::App& command, GenerateOptions& options) {
  command.add_option("SPEC", options.specs, "A file, a name in the catalogue, or - (stdin)")
      ->required()
      ->option_text("...");
  AddWholeNumber(command, "-n,--count", options.count, "Variants to make", 1);
  AddWholeNumber(command, "-s,--seed", options.seed, "Seed of all draws");
  AddWholeNumber(command, "--first", options.first, "Index of the first variant");
  command.add_option("-o,--output", options.output, "A folder [./NAME/], FILE.xml, or - (stdout)")
      ->option_text("OUT");
  command.add_option("--name", options.name, "The object's name; ${index} allowed")
      ->option_text("TEXT");
  AddSpecOptions(command, options.spec);
  AddWord(command, "--target", options.target, TargetNames(), "For");
  AddWord(command, "--validate", options.validate, {"load", "none"}, "MuJoCo's verdict");
  AddWord(command, "--on-invalid", options.on_invalid, {"fail", "skip", "resample"},
          "Bad variants");
  command.add_flag("--force", options.force, "Overwrite files that mjforge did not make");
  AddReportOptions(command, options.report);
  AddVerboseOption(command, options.report);
}

}  // namespace

Action AddGenerate(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("generate", "Make variants of objects");
  auto options = std::make_shared<GenerateOptions>();
  AddOptions(command, *options);
  AddExamples(command,
              "  mjforge generate hammer -n 100 --seed 7 -o out/\n"
              "  mjforge generate mug.yaml --set 'height=8cm .. 12cm' -o mug.xml\n"
              "  mjforge generate hammer --first 41 -o - | less");
  return [options] {
    const std::string contradiction = Contradiction(*options);
    if (!contradiction.empty()) return WrongUsage(contradiction, "generate");
    return Run(*options)();
  };
}

}  // namespace mjforge::app
