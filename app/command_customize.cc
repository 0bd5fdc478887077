// `mjforge customize`: serves a page with a control for every parameter of a spec on localhost.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <boost/asio/signal_set.hpp>
#include <csignal>
#include <memory>

#include "commands.h"
#include "completion.h"
#include "mjforge/customize/customize.h"
#include "options.h"
#include "page_server.h"
#include "temporary_folder.h"
#include "usage.h"

namespace mjforge::app {
namespace {

struct CustomizeOptions : ObjectOptions {
  std::uint64_t port = 0;  // 0: any free port
  bool no_open = false;
  Seconds time_limit{60};
};

constexpr std::uint64_t kMostPorts = 65535;

// Returns true if the spec exists. A spec with errors counts, because errors can be corrected while
// its page is open. Otherwise adds findings and returns false.
bool SpecExists(const CustomizeOptions& options, Console& console) {
  Console silent{MessageOptions()};
  SpecOptions bare;
  if (LoadRecipe(options.what, bare, silent) || silent.sources.size() > 0) return true;
  console.findings.Append(std::move(silent.findings));
  return false;
}

WorkerMaker MakeWorkerOf(const CustomizeOptions& options) {
  return [options]() -> Worker {
    const auto studio = std::make_shared<customize::Studio>(
        customize::Start{.reference = options.what,
                         .load = LoadOptionsOf(options.spec),
                         .seed = options.spec.seed,
                         .index = options.index,
                         .place_seed = options.spec.place_seed});
    return [studio](std::string_view request) {
      const customize::Reply reply = studio->Answer(request);
      return EncodeAnswer(reply.files, reply.json, reply.picture);
    };
  };
}

// Writes an HTML file that redirects a browser to `address`, which contains a secret token. The
// browser is started with this file, because other users can read the arguments of a program but
// not the file.
bool WriteRedirect(const std::filesystem::path& file, const std::string& address,
                   diag::Findings& findings) {
  return output::WriteFile(file,
                           fmt::format("<!doctype html>\n<meta charset=\"utf-8\">\n"
                                       "<meta http-equiv=\"refresh\" content=\"0; url={0}\">\n"
                                       "<a href=\"{0}\">mjforge customize</a>\n",
                                       address),
                           false, findings);
}

// Opens a file in the browser of the desktop. Runs the browser in a child of a child, so that this
// process need not wait for the browser's end.
void OpenInBrowser(const std::filesystem::path& file) {
  const ::pid_t child = ::fork();
  if (child == 0) {
    if (::fork() == 0) {
      ::setsid();
      const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
      ::execlp("xdg-open", "xdg-open", file.c_str(), nullptr);
    }
    ::_exit(0);
  }
  if (child > 0) ::waitpid(child, nullptr, 0);
}

ExitStatus Customize(const CustomizeOptions& options, Console& console) {
  if (options.what == "-" || options.what.ends_with(".xml"))
    return WrongUsage(fmt::format("'{}' is not a spec in a file", options.what), "customize");
  if (!SpecExists(options, console)) return console.Report();
  boost::asio::io_context io(1);
  PageServer server(io, MakeWorkerOf(options), options.time_limit);
  if (const std::string why_not = server.Listen(static_cast<std::uint16_t>(options.port));
      !why_not.empty()) {
    PrintError(fmt::format("error: cannot listen at port {}: {}", options.port, why_not));
    console.PrintLine("  hint: without --port a free one is chosen");
    return ExitStatus::kInputOutput;
  }
  boost::asio::signal_set signals(io, SIGINT, SIGTERM, SIGHUP);
  signals.async_wait([&](const boost::system::error_code&, int) { io.stop(); });
  if (const ExitStatus status = PrintBytes(server.Address() + "\n"); status != ExitStatus::kDone)
    return status;
  console.PrintLine("mjforge: note: serving this page until Ctrl-C");
  std::shared_ptr<const std::filesystem::path> folder;
  if (!options.no_open && (IsSet("DISPLAY") || IsSet("WAYLAND_DISPLAY"))) {
    folder = MakeTemporaryFolder(console.findings);
    if (folder && WriteRedirect(*folder / "customize.html", server.Address(), console.findings))
      OpenInBrowser(*folder / "customize.html");
  }
  io.run();
  return console.Report();
}

}  // namespace

Action AddCustomize(CLI::App& command) {
  auto options = std::make_shared<CustomizeOptions>();
  AddArgument(command, "SPEC", options->what, "A file, or a name in the catalogue", kSpecs);
  AddWholeNumber(command, "--index", options->index, "The variant to begin with");
  AddSpecOptions(command, options->spec);
  AddWholeNumber(command, "--port", options->port, "Port of the page [a free one]", 1, kMostPorts)
      ->option_text("N");
  command.add_flag("--no-open", options->no_open, "Only print the address; open no browser");
  AddTimeLimit(command, options->time_limit, "Time for each answer, s");
  return [options](Console& console) { return Customize(*options, console); };
}

}  // namespace mjforge::app
