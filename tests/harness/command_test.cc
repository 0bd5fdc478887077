// Tests of running programs: streams, status, signals, timeouts.

#include "harness/command.h"

#include <catch2/catch.hpp>

namespace mjforge::harness {

namespace {

CommandResult Shell(const std::string& script, std::string input = {}) {
  return Command{.program = "sh", .arguments = {"-c", script}, .input = std::move(input)}.Run();
}

}  // namespace

TEST_CASE("a command's streams and exit status are captured apart") {
  const CommandResult result = Shell("echo data; echo words >&2; exit 3");
  CHECK(result.status == 3);
  CHECK(result.out == "data\n");
  CHECK(result.err == "words\n");
  CHECK_FALSE(result.timed_out);
}

TEST_CASE("a command reads its input to the end, and need not read it") {
  const std::string input(200'000, 'x');
  CHECK(Shell("cat", input).out == input);
  CHECK(Shell("exit 0", input).status == 0);
}

TEST_CASE("a command's arguments are passed as they are") {
  const Command command{.program = "printf", .arguments = {"%s|", "a b", "$HOME", ""}};
  CHECK(command.Run().out == "a b|$HOME||");
}

TEST_CASE("a command sees its own variables and no leftover of the tester's") {
  ::setenv("MJFORGE_PATH", "left over", 1);
  const Command command{.program = "sh",
                        .arguments = {"-c", "echo ${MJFORGE_PATH-unset} $WORD"},
                        .environment = {{"WORD", "given"}}};
  CHECK(command.Run().out == "unset given\n");
  ::unsetenv("MJFORGE_PATH");
}

TEST_CASE("a command works in its folder") {
  const TemporaryFolder folder;
  const Command command{
      .program = "sh", .arguments = {"-c", "echo here >file"}, .folder = folder.path()};
  CHECK(command.Run().status == 0);
  CHECK(folder.Read("file") == "here\n");
}

TEST_CASE("a command that was ended by a signal says which") {
  CHECK(Shell("kill -TERM $$").status == 128 + 15);
}

TEST_CASE("a command that does not end is killed with its children") {
  const Command command{.program = "sh",
                        .arguments = {"-c", "cat /dev/zero >/dev/null & wait"},
                        .timeout = std::chrono::milliseconds(50)};
  const CommandResult result = command.Run();
  CHECK(result.timed_out);
  CHECK(result.status == 128 + 9);
}

}  // namespace mjforge::harness
