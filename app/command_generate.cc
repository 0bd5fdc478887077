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
#include "completion.h"
#include "family_option_conflicts.h"
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

struct GenerateOptions : BatchOptions {
  std::string output;
  std::uint64_t per_archive = 10'000;
  std::string shard;
  std::string target = "mujoco";
  std::string assets = "inline";
  std::string validate = "load";
  std::string on_invalid = "fail";
  std::string sampler = "random";
  std::string layout = "any";
  std::string durability = "batch";
  bool verbose = false;
  MakeOptions make;
};

constexpr std::uint64_t kMaxShards = 99'999;  // file names have five digits for a shard

// Parses the index and the count of a shard: "3/8".
std::optional<output::Shard> ParseShard(std::string_view text, std::string& why_not) {
  const std::size_t slash = text.find('/');
  const std::optional<std::uint64_t> index = output::ReadIndex(text.substr(0, slash));
  const std::optional<std::uint64_t> count =
      slash == text.npos ? std::nullopt : output::ReadIndex(text.substr(slash + 1));
  if (!index || !count || *count == 0 || *count > kMaxShards) {
    why_not = fmt::format("--shard: '{}' is not of the form I/N, N up to {}", text, kMaxShards);
    return std::nullopt;
  }
  if (*index >= *count) {
    why_not = fmt::format("--shard {}: shards count from 0, so the last one is {}/{}", text,
                          *count - 1, *count);
    return std::nullopt;
  }
  return output::Shard{*index, *count};
}

// Returns the message for an option that the destination does not support; empty if there is none.
std::string FindConflict(const GenerateOptions& options, const batch::Request& request) {
  const Kind kind = request.destination.kind;
  const bool is_one = kind == Kind::kFile || kind == Kind::kStandardOutput;
  if (is_one && request.count > 1)
    return fmt::format("-o {} takes one variant, -n asks for {}", options.output, request.count);
  if (kind != Kind::kFolder && options.specs.size() > 1)
    return fmt::format("-o {} takes one spec, {} are given", options.output, options.specs.size());
  if (kind == Kind::kStandardOutput && request.variant.assets == mjcf::AssetForm::kFiles)
    return "--assets files: standard output cannot carry them; write to a file, a folder or an "
           "archive";
  if (is_one && request.resume) return fmt::format("-o {} has nothing to resume", options.output);
  if (is_one && !request.shard.IsWhole())
    return fmt::format("-o {} writes one variant, which has no shards", options.output);
  if (kind == Kind::kArchive && !request.shard.IsWhole()) {
    return fmt::format(
        "--shard: '{}' is one archive; shards fill a folder or a series, such as '{}'",
        options.output, std::string(options.output).insert(options.output.find(".tar"), "_%05d"));
  }
  return {};
}

// Returns an error message if --each contradicts other options; otherwise an empty text.
std::string FindEachConflict(const GenerateOptions& options, const batch::Request& request) {
  if (!request.variant.each) return {};
  const Kind kind = request.destination.kind;
  if (kind == Kind::kFile || kind == Kind::kStandardOutput)
    return fmt::format("--each writes several files: -o {} must be a folder or an archive",
                       options.output);
  if (!mjcf::RulesOf(request.variant.target).has_scene) return {};
  std::vector<std::string_view> targets = mjcf::TargetNames();
  std::erase(targets, options.target);
  return fmt::format("--each: files for --target {} have a floor of their own; the targets are {}",
                     options.target, fmt::join(targets, ", "));
}

// Returns an error message if --layout contradicts other options; otherwise an empty text.
std::string FindLayoutConflict(const GenerateOptions& options, const batch::Request& request) {
  if (request.variant.layout == manifest::Layout::kAny) return {};
  if (request.variant.validation == manifest::Validation::kNone)
    return fmt::format(
        "--layout {} reads structures from the models that MuJoCo loads, and "
        "--validate none loads none",
        options.layout);
  const Kind kind = request.destination.kind;
  if (request.variant.layout == manifest::Layout::kSplit &&
      (kind == Kind::kFile || kind == Kind::kStandardOutput))
    return fmt::format("--layout split makes folders: -o {} must be a folder or an archive",
                       options.output);
  return {};
}

std::string FindMakeConflict(const GenerateOptions& options, const batch::Request& request) {
  const MakeOptions& make = options.make;
  if (!make.wanted()) return {};
  if (options.specs.size() > 1) return "-MD takes one spec";
  if (request.resume) return "-MD and --resume: the inputs of kept variants are not known";
  if (!request.shard.IsWhole()) return "-MD and --shard: a shard is not a target by itself";
  if (request.destination.kind == Kind::kStandardOutput &&
      (make.file.empty() || make.targets.empty())) {
    return "-MD with -o - needs -MF and -MT";
  }
  return {};
}

void AddOutputOptions(CLI::App& command, GenerateOptions& options) {
  command
      .add_option("-o,--output", options.output,
                  "Folder [./NAME/], .xml, .npz, .tar[.zst], %d.tar -")
      ->option_text("OUT")
      ->check(Offers("."));
  AddWholeNumber(command, "--per-archive", options.per_archive, "Variants in each archive", 1);
  command.add_option("--shard", options.shard, "Part I (from 0) of the N parts of the batch")
      ->option_text("I/N");
  command.add_flag("--resume", options.request.resume, "Continue what an earlier run left");
  command.add_flag("--verify", options.request.verify,
                   "With --resume: read finished archives, too");
  AddWord(command, "--durability", options.durability, output::kDurabilities,
          "What outlives a power cut");
  command.add_flag("--if-changed", options.request.if_changed, "Leave unchanged files alone");
  command.add_flag("--force", options.request.force, "Overwrite files that mjforge did not make");
}

void AddGenerateOptions(CLI::App& command, GenerateOptions& options) {
  AddBatchOptions(command, options);
  AddWholeNumber(command, "--first", options.request.first, "Index of the first variant");
  AddOutputOptions(command, options);
  command.add_option("--name", options.request.variant.name, "The object's name; ${index} allowed")
      ->option_text("TEXT");
  AddWord(command, "--target", options.target, mjcf::TargetNames(), "For");
  command.add_flag("--each", options.request.variant.each, "Each object of a scene as a file");
  command.add_flag("--mocap", options.request.variant.mocap, "In a family: fixed bodies are mocap");
  command.add_flag("--pad", options.request.variant.pad,
                   "In a family: geoms that a variant lacks are null");
  AddWord(command, "--assets", options.assets, mjcf::kAssetForms, "Meshes and textures");
  AddWord(command, "--validate", options.validate, manifest::kValidations, "MuJoCo's verdict");
  AddProfile(command, options.spec.settings, [&options] { options.validate = "physics"; });
  AddWord(command, "--on-invalid", options.on_invalid, manifest::kOnInvalid, "Invalid variants");
  AddWord(command, "--layout", options.layout, manifest::kLayouts, "Structures of compiled models");
  AddWord(command, "--sampler", options.sampler, sample::MethodNames(), "Spread of draws");
  AddWholeNumber(command, "--batch", options.request.variant.batch,
                 "Variants the draws are spread over", 1)
      ->option_text("N [-n]");
  AddMakeOptions(command, options.make);
  command.add_flag("-v,--verbose", options.verbose, "Print a line per variant");
}

// Converts the options to a request. The caller sets the folder, because the spec may name it.
// Returns nullopt and sets `why_not` if options contradict each other.
std::optional<batch::Request> RequestOf(const GenerateOptions& options, std::string& why_not) {
  batch::Request request = RequestOf(static_cast<const BatchOptions&>(options));
  request.variant.target = *mjcf::FindTarget(options.target);
  request.variant.assets = *manifest::Find<mjcf::AssetForm>(options.assets);
  request.variant.sampler = *sample::FindMethod(options.sampler);
  request.variant.validation = *manifest::Find<forge::Validation>(options.validate);
  request.variant.layout = *manifest::Find<manifest::Layout>(options.layout);
  request.variant.on_invalid = *manifest::Find<forge::OnInvalid>(options.on_invalid);
  request.durability =
      options.durability == "none" ? output::Durability::kNone : output::Durability::kBatch;
  request.all_or_nothing = options.make.wanted();
  const auto destination = output::ParseDestination(options.output, options.per_archive, why_not);
  if (!destination) {
    why_not = fmt::format("-o {}: {}", options.output, why_not);
    return std::nullopt;
  }
  request.destination = *destination;
  if (!options.shard.empty()) {
    const std::optional<output::Shard> shard = ParseShard(options.shard, why_not);
    if (!shard) return std::nullopt;
    request.shard = *shard;
  }
  // The index after the last index must not overflow.
  if (request.count > std::numeric_limits<std::uint64_t>::max() - request.first) {
    why_not = "--first and -n go beyond the largest index";
  } else if (request.variant.batch > sample::kMaxBatch) {
    why_not = fmt::format("draws are spread over at most {} variants", sample::kMaxBatch);
  } else {
    why_not = FindConflict(options, request);
    if (why_not.empty()) why_not = FindMakeConflict(options, request);
    if (why_not.empty()) why_not = FindEachConflict(options, request);
    if (why_not.empty()) why_not = FindLayoutConflict(options, request);
    if (why_not.empty()) why_not = FindFamilyConflict(options.output, request);
  }
  return why_not.empty() ? std::optional(std::move(request)) : std::nullopt;
}

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
// program.
const std::atomic<bool>& CatchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = OnInterrupt;
  action.sa_flags = static_cast<int>(SA_NODEFER | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return interrupted;
}

// A run of `mjforge generate`.
class Generation {
 public:
  Generation(const GenerateOptions& options, batch::Request request, Console& console)
      : options_(options), request_(std::move(request)), console_(console) {
    request_.stop = &CatchInterrupts();
  }

  ExitStatus operator()() {
    KeepMemory();
    ExitStatus status = Load();
    if (status != ExitStatus::kDone) return status;
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
        console_.PrintLine(Counted(count, "variant", "variants") + " kept");
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
                           std::filesystem::path(options_.specs[0]).is_absolute(),
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
    console_.PrintLine(fmt::format("{} of {} in {}: {}",
                                   Counted(summary.count, "variant", "variants"), recipe.spec->name,
                                   place, CountsText(summary, start)));
    const bool is_batch = request.destination.kind != Kind::kFile;
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
