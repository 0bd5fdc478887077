// Runs the mjforge that was built with these tests.

#include <catch2/catch.hpp>
#include <utility>

#include "harness/command.h"

namespace mjforge::harness {

std::filesystem::path MjforgeProgram() { return MJFORGE_PROGRAM; }

CommandResult ProgramTest::Run(std::vector<std::string> arguments, std::string input,
                               std::map<std::string, std::string> environment) const {
  const Command command{.program = MjforgeProgram(),
                        .arguments = std::move(arguments),
                        .input = std::move(input),
                        .environment = std::move(environment),
                        .folder = folder_.path()};
  CommandResult result = command.Run();
  REQUIRE_FALSE(result.timed_out);
  return result;
}

}  // namespace mjforge::harness
