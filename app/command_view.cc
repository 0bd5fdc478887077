// `mjforge view`: opens an object in MuJoCo's own viewer.
#include <fmt/format.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>

#include "commands.h"
#include "options.h"
#include "temporary_folder.h"
#include "usage.h"

namespace mjforge::app {
namespace {

using diag::Code;

constexpr int kCannotRun = 127;  // exit status of shells for a command that cannot be run

std::filesystem::path FindInPath(std::string_view program) {
  const char* variable = std::getenv("PATH");
  std::string_view rest = variable == nullptr ? "" : variable;
  while (!rest.empty()) {
    const std::filesystem::path file = std::filesystem::path(diag::CutAt(':', rest)) / program;
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0)
      return std::filesystem::absolute(file, error);
  }
  return {};
}

sigset_t WatchedSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&signals, signal);
  return signals;
}

// Replaces the child process by the viewer; does not return.
[[noreturn]] void ExecViewer(const std::filesystem::path& viewer, const std::filesystem::path& file,
                             const std::filesystem::path& folder, const sigset_t& signals) {
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGXFSZ, SIG_DFL);
  ::sigprocmask(SIG_SETMASK, &signals, nullptr);
  if (::chdir(folder.c_str()) == 0) ::execl(viewer.c_str(), viewer.c_str(), file.c_str(), nullptr);
  ::_exit(kCannotRun);
}

// Waits until the process ends and returns its wait status. Passes signals on to the process; sets
// `interrupted` if a signal was passed on. The second signal becomes SIGKILL.
int WaitFor(pid_t process, const sigset_t& watched, bool& interrupted) {
  int status = 0;
  while (::waitpid(process, &status, WNOHANG) == 0) {
    int signal = 0;
    if (::sigwait(&watched, &signal) != 0 || signal == SIGCHLD) continue;
    ::kill(process, interrupted ? SIGKILL : signal);
    interrupted = true;
  }
  return status;
}

std::string DescribeExit(int status) {
  if (WIFSIGNALED(status)) return fmt::format("signal {} killed it", WTERMSIG(status));
  if (WEXITSTATUS(status) == kCannotRun) return "it cannot be run";
  return fmt::format("exit status {}", WEXITSTATUS(status));
}

// Finds MuJoCo's viewer in PATH, by its name in Debian or by its name in MuJoCo's releases. Returns
// nullopt and adds a finding if there is no viewer or no display.
std::optional<std::filesystem::path> FindViewer(diag::Findings& findings) {
  for (const std::string_view program : {"mujoco-simulate", "simulate"}) {
    const std::filesystem::path file = FindInPath(program);
    if (file.empty()) continue;
    if (IsSet("DISPLAY") || IsSet("WAYLAND_DISPLAY")) return file;
    findings.Add(Code::kPictureNoDisplay, {},
                 "there is no display for MuJoCo's viewer: neither DISPLAY nor WAYLAND_DISPLAY "
                 "is set",
                 "'mjforge preview' draws without one");
    return std::nullopt;
  }
  findings.Add(Code::kPictureNoViewer, {},
               "MuJoCo's viewer is not installed: there is no 'mujoco-simulate' in PATH",
               "install the package libmujoco-samples");
  return std::nullopt;
}

// Runs the viewer in `folder` and waits until it ends. Passes SIGINT, SIGTERM and SIGHUP on to the
// viewer, the second signal as SIGKILL.
ExitStatus RunViewer(const std::filesystem::path& viewer, const std::filesystem::path& file,
                     const std::filesystem::path& folder, diag::Findings& findings) {
  const sigset_t watched = WatchedSignals();
  sigset_t before;
  ::sigprocmask(SIG_BLOCK, &watched, &before);
  const pid_t process = ::fork();
  if (process == 0) ExecViewer(viewer, file, folder, before);
  bool interrupted = false;
  const int status = process < 0 ? 0 : WaitFor(process, watched, interrupted);
  if (process < 0) {
    findings.Add(Code::kPictureNoViewer, {},
                 fmt::format("cannot start MuJoCo's viewer '{}': {}", viewer.string(),
                             std::generic_category().message(errno)));
  } else if (status != 0 && !interrupted) {
    findings.Add(Code::kPictureNoViewer, {},
                 fmt::format("MuJoCo's viewer '{}' failed: {}", viewer.filename().string(),
                             DescribeExit(status)));
  }
  // Signals stay blocked, because the program ends soon.
  return interrupted ? ExitStatus::kInterrupted : StatusOf(findings);
}

ExitStatus ViewFile(const std::string& file, Console& console) {
  if (!validate::Loader().Load(file, console.sources, console.findings))
    return ExitStatus::kFindings;
  const auto viewer = FindViewer(console.findings);
  const auto folder = viewer ? MakeTemporaryFolder(console.findings) : nullptr;
  if (!folder) return ExitStatus::kFindings;
  const std::optional<std::string> adapted = validate::Loader::AdaptedText(file);
  if (!adapted) {
    return RunViewer(*viewer, std::filesystem::absolute(file), *folder, console.findings);
  }
  const std::filesystem::path shown = *folder / std::filesystem::path(file).filename();
  if (!output::WriteFile(shown, *adapted, false, console.findings)) return ExitStatus::kInputOutput;
  return RunViewer(*viewer, shown, *folder, console.findings);
}

ExitStatus ViewVariant(const ObjectOptions& options, Console& console) {
  const std::optional<forge::Recipe> recipe = LoadRecipe(options.what, options.spec, console);
  if (!recipe) return ExitStatus::kFindings;
  const forge::Options generation = {.seed = options.spec.seed,
                                     .place_seed = options.spec.place_seed,
                                     .target = mjcf::Target::kScene};
  forge::Variant variant;
  forge::Generator(*recipe, console.sources, generation).Make(options.index, variant);
  console.findings.Append(variant.findings);
  if (!variant.ok()) return ExitStatus::kFindings;
  const auto viewer = FindViewer(console.findings);
  const auto folder = viewer ? MakeTemporaryFolder(console.findings) : nullptr;
  if (!folder) return ExitStatus::kFindings;
  const std::string name = variant.record.name + ".xml";
  if (!output::ObjectFolder(*folder, {}).Write(name, variant.document, console.findings))
    return ExitStatus::kInputOutput;
  return RunViewer(*viewer, *folder / name, *folder, console.findings);
}

}  // namespace

Action AddView(CLI::App& command) {
  auto options = std::make_shared<ObjectOptions>();
  AddObjectOptions(command, *options, "A spec or a FILE.xml");
  return [options](Console& console) {
    const bool is_file = options->what.ends_with(".xml");
    const std::string wrong =
        is_file ? RefuseSpecOptions(options->what, options->spec, options->index > 0, "--index")
                : "";
    if (!wrong.empty()) return WrongUsage(wrong, "view");
    const ExitStatus status =
        is_file ? ViewFile(options->what, console) : ViewVariant(*options, console);
    return Worse(status, console.Report());
  };
}

}  // namespace mjforge::app
