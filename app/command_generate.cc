#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <set>

#include "commands.h"
#include "generate_options.h"
#include "interrupt.h"
#include "progress_bar.h"
#include "usage.h"

namespace mjforge::app {
namespace {

using Kind = output::Destination::Kind;
using Clock = std::chrono::steady_clock;

ExitStatus StatusOf(const batch::Summary& summary) {
  if (summary.interrupted) return ExitStatus::kInterrupted;
  if (summary.output_failed) return ExitStatus::kInputOutput;
  const bool nothing = summary.ok == 0 && summary.skipped > 0;
  return summary.failed > 0 || nothing ? ExitStatus::kFindings : ExitStatus::kDone;
}

// "97 ok, 3 failed (0.2 s)"
std::string Counts(const batch::Summary& summary, Clock::time_point start) {
  std::string text = fmt::format("{} ok", summary.ok);
  if (summary.failed > 0) text += fmt::format(", {} failed", summary.failed);
  if (summary.skipped > 0) text += fmt::format(", {} skipped", summary.skipped);
  if (summary.kept > 0) text += fmt::format(", {} of them kept", summary.kept);
  if (summary.interrupted) text += ", interrupted";
  if (summary.output_failed) text += ", stopped: output failed";
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  text += fmt::format(" ({:.1f} s", seconds);
  const auto made = static_cast<double>(summary.done() - summary.kept);
  if (seconds >= 1 && made >= 100) text += fmt::format(", {:.0f}/s", made / seconds);
  return text + ")";
}

// The run of one `generate`.
class Run {
 public:
  Run(const GenerateOptions& options, batch::Request request)
      : options_(options), request_(std::move(request)), console_(options.report) {
    request_.stop = &CatchInterrupts();
  }

  ExitStatus operator()() {
    KeepMemory();
    Load();
    if (status_ != ExitStatus::kDone) return status_;
    for (const forge::Recipe& recipe : recipes_) {
      status_ = Worse(status_, Make(recipe));
      if (status_ >= ExitStatus::kInputOutput) break;
    }
    return status_;
  }

 private:
  // Buffers of some hundred kilobytes come and go with every chunk. Given back to the
  // system each time, their pages cost as much as what is in them.
  static void KeepMemory() {
    constexpr int kKept = 64 << 20;
    ::mallopt(M_MMAP_THRESHOLD, kKept);
    ::mallopt(M_TRIM_THRESHOLD, kKept);
  }

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

  std::filesystem::path FolderOf(const forge::Recipe& recipe) const {
    const bool own_name = options_.specs.size() == 1 && !options_.name.empty() &&
                          options_.name.find('$') == std::string::npos;
    const std::string name = own_name ? options_.name : recipe.spec->name;
    if (options_.output.empty()) return name;
    if (options_.specs.size() == 1) return options_.output;
    return std::filesystem::path(options_.output) / name;
  }

  ExitStatus Make(const forge::Recipe& recipe) {
    const auto start = Clock::now();
    batch::Request request = request_;
    if (request.destination.kind == Kind::kFolder) request.destination.path = FolderOf(recipe);
    ProgressBar bar(!options_.report.quiet);
    batch::Watch watch;
    watch.progress = [&](const batch::Summary& summary) { bar.Show(summary); };
    if (console_.verbose()) {
      watch.variant = [&](const batch::Done& done) {
        bar.Clear();
        Say(done, request.destination);
      };
    }
    batch::Summary summary = batch::Run(recipe, sources_, request, watch);
    bar.Clear();
    ExitStatus status = StatusOf(summary);
    if (status == ExitStatus::kDone && options_.make.wanted() &&
        !WriteDependencies(options_.make, request.destination, FilesOf(recipe, summary),
                           std::filesystem::path(options_.specs[0]).is_absolute(),
                           summary.findings)) {
      status = ExitStatus::kInputOutput;
    }
    console_.Show(summary.findings, sources_, summary.more_findings);
    if (request.destination.kind == Kind::kStandardOutput)
      return Worse(status, Print(summary.text));
    Say(recipe, request, summary, start);
    return status;
  }

  void Say(const batch::Done& done, const output::Destination& destination) {
    std::string place = fmt::format("{} {}", done.name, done.index);
    if (!done.place.empty())
      place =
          destination.kind == Kind::kFolder ? (destination.path / done.place).string() : done.place;
    console_.Say(fmt::format("{}: {}, attempt {}", place, NameOf(done.status), done.attempt));
  }

  void Say(const forge::Recipe& recipe, const batch::Request& request,
           const batch::Summary& summary, Clock::time_point start) {
    std::string place = request.destination.path.string();
    if (request.destination.kind == Kind::kFolder && !place.ends_with('/')) place += '/';
    if (!request.shard.IsWhole()) place += fmt::format(", shard {}", options_.shard);
    console_.Say(fmt::format("{} variant{} of {} in {}: {}", summary.count,
                             summary.count == 1 ? "" : "s", recipe.spec->name, place,
                             Counts(summary, start)));
    const bool is_batch = request.destination.kind != Kind::kFile;
    if (is_batch && (summary.interrupted || summary.output_failed) && summary.done() > 0)
      console_.Say("  hint: the same command with --resume goes on from there");
  }

  std::set<std::string> FilesOf(const forge::Recipe& recipe, const batch::Summary& summary) const {
    std::set<std::string> files = summary.inputs;
    for (const std::filesystem::path& file : recipe.spec->files) files.insert(file.string());
    files.insert(options_.spec.parameter_files.begin(), options_.spec.parameter_files.end());
    return files;
  }

  const GenerateOptions& options_;
  batch::Request request_;
  Console console_;
  diag::Sources sources_;
  std::vector<forge::Recipe> recipes_;
  ExitStatus status_ = ExitStatus::kDone;
};

}  // namespace

Action AddGenerate(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("generate", "Make variants of objects");
  auto options = std::make_shared<GenerateOptions>();
  AddGenerateOptions(command, *options);
  AddExamples(command,
              "  mjforge generate hammer -n 100 --seed 7 -o out/\n"
              "  mjforge generate mug.yaml --set 'height=8cm .. 12cm' -o mug.xml\n"
              "  mjforge generate hammer -n 1000000 -o 'hammers_%05d.tar.zst'");
  return [options] {
    std::string why_not;
    std::optional<batch::Request> request = RequestOf(*options, why_not);
    if (!request) return WrongUsage(why_not, "generate");
    return Run(*options, *std::move(request))();
  };
}

}  // namespace mjforge::app
