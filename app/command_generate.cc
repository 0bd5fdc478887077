// `mjforge generate`: writes variants of specs to files, folders, archives and families.
#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <limits>
#include <memory>
#include <set>

#include "commands.h"
#include "generate_options.h"
#include "load_time_limit.h"
#include "make_rule_options.h"
#include "options.h"
#include "progress_bar.h"
#include "structures.h"
#include "usage.h"

namespace mjforge::app {
namespace {

using Kind = output::Destination::Kind;
using Clock = std::chrono::steady_clock;

// Returns the counts and the time of a batch: "97 ok, 3 failed (0.2 s)".
std::string CountsText(const batch::Summary& summary, Clock::time_point start) {
  std::string text = fmt::format("{} ok", summary.ok);
  if (summary.failed > 0) text += fmt::format(", {} failed", summary.failed);
  if (summary.skipped > 0) text += fmt::format(", {} skipped", summary.skipped);
  if (summary.resumed > 0) text += fmt::format(", {} of them kept", summary.resumed);
  if (summary.interrupted) text += ", interrupted";
  if (summary.files_failed) text += ", stopped";
  const double seconds = Seconds(Clock::now() - start).count();
  text += fmt::format(" ({:.1f} s", seconds);
  const auto made = static_cast<double>(summary.done() - summary.resumed);
  if (seconds >= 1 && made >= 100) text += fmt::format(", {:.0f}/s", made / seconds);
  return text + ")";
}

// Set by the signal handler, which can only access global variables.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void OnInterrupt(int signal) {
  if (interrupted.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

// Installs handlers: the first SIGINT or SIGTERM sets the returned flag, the second one ends the
// program. A signal that the caller ignores remains ignored.
const std::atomic<bool>& CatchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = OnInterrupt;
  action.sa_flags = static_cast<int>(SA_NODEFER | SA_RESTART);
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction present = {};
    sigaction(signal, nullptr, &present);
    if (present.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  return interrupted;
}

// A run of `mjforge generate`.
class Generation {
 public:
  Generation(const GenerateOptions& options, batch::Request request, Console& console)
      : options_(options), request_(std::move(request)), console_(console) {}

  ExitStatus operator()() {
    KeepMemory();
    ExitStatus status = Load();
    if (status != ExitStatus::kDone) return status;
    // Until here a signal ends the program at once, because reading a pipe may take forever.
    request_.stop = &CatchInterrupts();
    for (const forge::Recipe& recipe : recipes_) {
      status = Worse(status, Make(recipe));
      if (status >= ExitStatus::kInputOutput) break;
    }
    return status;
  }

 private:
  // Keeps freed memory in the process, because every chunk of variants allocates buffers of some
  // hundred kilobytes, and mapping their pages again costs as much time as filling them.
  static void KeepMemory() {
    constexpr int kKept = 64 << 20;
    ::mallopt(M_MMAP_THRESHOLD, kKept);
    ::mallopt(M_TRIM_THRESHOLD, kKept);
  }

  // Loads all specs first, so that errors in the last spec are reported before a variant is made.
  ExitStatus Load() {
    if (!request_.variant.name.empty() &&
        !forge::CheckName(request_.variant.name, console_.findings)) {
      console_.Report();
      return ExitStatus::kUsage;
    }
    std::set<std::string> names;
    for (const std::string& spec : options_.specs) {
      const LoadTimeLimit limit(spec, request_.time_limit, console_);
      std::optional<forge::Recipe> recipe = LoadRecipe(spec, options_.spec, console_);
      if (!recipe) continue;
      const std::string& name = recipe->spec->name;
      if (!names.insert(name).second) {
        console_.findings.Add(
            diag::Code::kOutputBadName, {},
            fmt::format("two specs are named '{}' and would share a folder", name),
            "generate them one by one");
      }
      recipes_.push_back(*std::move(recipe));
    }
    return console_.Report();
  }

  std::filesystem::path FolderOf(const forge::Recipe& recipe) const {
    const bool own_name = options_.specs.size() == 1 && !request_.variant.name.empty() &&
                          request_.variant.name.find('$') == std::string::npos;
    const std::string name = own_name ? request_.variant.name : recipe.spec->name;
    if (options_.output.empty()) return name;
    if (options_.specs.size() == 1) return options_.output;
    return std::filesystem::path(options_.output) / name;
  }

  ExitStatus Make(const forge::Recipe& recipe) {
    const auto start = Clock::now();
    batch::Request request = request_;
    if (request.destination.kind == Kind::kFolder) request.destination.path = FolderOf(recipe);
    ProgressBar bar(!console_.quiet());
    batch::Observer watch;
    watch.progress = [&](const batch::Summary& summary) { bar.Show(summary); };
    if (options_.verbose) {
      watch.resumed = [&](std::uint64_t count) {
        console_.PrintLine(Counted(count, "variant") + " kept");
      };
      watch.variant = [&](const batch::FinishedVariant& done) {
        bar.Clear();
        PrintVariant(done, request.destination);
      };
    }
    if (options_.make.wanted() &&
        !MayWriteDependencies(options_.make, request.destination, request.force, console_.findings))
      return console_.Report();
    batch::Summary summary = batch::Run(recipe, console_.sources, request, watch);
    bar.Clear();
    ExitStatus status = StatusOf(summary);
    if (status == ExitStatus::kDone && options_.make.wanted() &&
        !WriteDependencies(options_.make, request.destination, FilesOf(recipe, summary),
                           std::filesystem::path(options_.specs[0]).is_absolute(), request.force,
                           summary.findings)) {
      status = ExitStatus::kInputOutput;
    }
    console_.Show(summary.findings, console_.sources, summary.more_findings);
    if (request.destination.kind == Kind::kStandardOutput)
      return Worse(status, PrintBytes(summary.text));
    PrintSummary(recipe, request, summary, start);
    if (request.variant.layout == manifest::Layout::kOne && summary.ok < summary.done())
      PrintDifferences(request.destination.Manifest(request.shard));
    return status;
  }

  void PrintVariant(const batch::FinishedVariant& done, const output::Destination& destination) {
    std::string place = fmt::format("{} {}", done.name, done.index);
    if (!done.place.empty())
      place =
          destination.kind == Kind::kFolder ? (destination.path / done.place).string() : done.place;
    console_.PrintLine(fmt::format("{}: {}, attempt {}", place, NameOf(done.status), done.attempt));
  }

  void PrintSummary(const forge::Recipe& recipe, const batch::Request& request,
                    const batch::Summary& summary, Clock::time_point start) {
    std::string place = request.destination.path.string();
    if (request.destination.kind == Kind::kFolder && !place.ends_with('/')) place += '/';
    if (!request.shard.IsWhole()) place += fmt::format(", shard {}", options_.shard);
    console_.PrintLine(fmt::format("{} of {} in {}: {}", Counted(summary.count, "variant"),
                                   recipe.spec->name, place, CountsText(summary, start)));
    // Neither a file that is in the way nor an input that was changed goes away with --resume.
    const auto remains = [](const diag::Finding& finding) {
      return finding.code == diag::Code::kOutputExists || finding.code == diag::Code::kBatchChanged;
    };
    const bool is_batch = request.destination.kind != Kind::kFile;
    if (std::ranges::any_of(summary.findings, remains)) return;
    if (is_batch && (summary.interrupted || summary.files_failed) && summary.done() > 0)
      console_.PrintLine("  hint: the same command with --resume continues from there");
  }

  // Prints the fields in which compiled models differ, with parameters that tell the models apart.
  void PrintDifferences(const std::filesystem::path& manifest) {
    diag::Sources sources;
    diag::Findings ignored;
    std::uint64_t bad_lines = 0;
    const auto batch = report::Summarize(manifest, 0, sources, ignored, bad_lines);
    if (!batch) return;
    const auto differences = CompareStructures(*batch, manifest.parent_path());
    for (const std::string& line : DifferencesText(differences)) console_.PrintLine("  " + line);
  }

  std::set<std::string> FilesOf(const forge::Recipe& recipe, const batch::Summary& summary) const {
    std::set<std::string> files = summary.inputs;
    for (const std::filesystem::path& file : recipe.spec->files) files.insert(file.string());
    files.insert(options_.spec.parameter_files.begin(), options_.spec.parameter_files.end());
    files.erase("-");  // standard input
    return files;
  }

  const GenerateOptions& options_;
  batch::Request request_;
  Console& console_;
  std::vector<forge::Recipe> recipes_;
};

}  // namespace

Action AddGenerate(CLI::App& command) {
  auto options = std::make_shared<GenerateOptions>();
  AddGenerateOptions(command, *options);
  return [options](Console& console) {
    std::string why_not;
    std::optional<batch::Request> request = RequestOf(*options, why_not);
    if (!request) return WrongUsage(why_not, "generate");
    return Generation(*options, *std::move(request), console)();
  };
}

}  // namespace mjforge::app
