// Starts programs with posix_spawn, with files as standard streams and a timeout.

#include "harness/command.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>

extern char** environ;  // NOLINT: POSIX's name

namespace mjforge::harness {

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// Returns a temporary file for a standard stream. Unlike pipes, files never block, in any order of
// reading and writing.
File NewFile(std::string_view text = "") {
  File file(std::tmpfile());
  REQUIRE(file != nullptr);
  REQUIRE(std::fwrite(text.data(), 1, text.size(), file.get()) == text.size());
  std::rewind(file.get());
  return file;
}

std::string TextOf(const File& file) {
  std::string text;
  std::array<char, 65536> block;
  std::rewind(file.get());
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), file.get())) {
    text.append(block.data(), size);
  }
  return text;
}

std::vector<std::string> EnvironmentOf(const Command& command) {
  std::map<std::string, std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) continue;
    variables.emplace(text.substr(0, equals), text.substr(equals + 1));
  }
  for (const char* name : {"NO_COLOR", "MJFORGE_PATH", "LANG", "LC_ALL", "LC_NUMERIC"}) {
    variables.erase(name);
  }
  for (const auto& [name, value] : command.environment) variables[name] = value;
  std::vector<std::string> entries;
  for (const auto& [name, value] : variables) entries.push_back(name + "=" + value);
  return entries;
}

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

class SpawnSettings {
 public:
  SpawnSettings(const std::filesystem::path& folder, const std::array<int, 4>& files) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    for (int i = 0; i < 4; ++i) {
      posix_spawn_file_actions_adddup2(&actions_, files[static_cast<std::size_t>(i)], i);
    }
    // Start a new process group, so that a timeout also kills the children of the program.
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  pid_t Start(const Command& command) const {
    std::vector<std::string> arguments = command.arguments;
    arguments.insert(arguments.begin(), command.program.string());
    std::vector<std::string> environment = EnvironmentOf(command);
    pid_t process = 0;
    const int error = posix_spawnp(&process, command.program.c_str(), &actions_, &attributes_,
                                   Pointers(arguments).data(), Pointers(environment).data());
    INFO("starting " << command.program << ": " << std::strerror(error));
    REQUIRE(error == 0);
    return process;
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

// Returns false on a timeout. The program holds the other end of the pipe until it ends.
bool EndsInTime(int pipe_end, std::chrono::milliseconds timeout) {
  pollfd watched{pipe_end, POLLIN, 0};
  int ready = 0;
  do {
    ready = ::poll(&watched, 1, static_cast<int>(timeout.count()));
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

}  // namespace

CommandResult Command::Run() const {
  const File in = NewFile(input);
  const File out = NewFile();
  const File err = NewFile();
  std::array<int, 2> alive;
  REQUIRE(::pipe2(alive.data(), O_CLOEXEC) == 0);
  const pid_t process =
      SpawnSettings(folder, {fileno(in.get()), fileno(out.get()), fileno(err.get()), alive[1]})
          .Start(*this);
  ::close(alive[1]);

  CommandResult result;
  result.timed_out = !EndsInTime(alive[0], timeout);
  ::close(alive[0]);
  if (result.timed_out) ::kill(-process, SIGKILL);
  int status = 0;
  REQUIRE(::waitpid(process, &status, 0) == process);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = TextOf(out);
  result.err = TextOf(err);
  return result;
}

}  // namespace mjforge::harness
