#include "golden/shell.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <regex>

#include "harness/source_folder.h"

namespace mjforge::golden {

harness::CommandResult RunLine(const std::string& line, const std::filesystem::path& folder,
                               bool merged) {
  const char* path = std::getenv("PATH");
  const std::string programs = harness::MjforgeProgram().parent_path().string();
  const harness::Command command{
      .program = "sh",
      .arguments = {"-c", merged ? "{ " + line + "\n} 2>&1" : line},
      .environment = {{"PATH", path == nullptr ? programs : programs + ":" + path},
                      // A build outside of the source tree does not find them.
                      {"MJFORGE_PATH", (harness::SourceFolder() / "specs").string()}},
      .folder = folder};
  harness::CommandResult result = command.Run();
  INFO("running: " << line);
  REQUIRE_FALSE(result.timed_out);
  return result;
}

std::string WithoutTimes(const std::string& text) {
  static const std::regex kSeconds("\\([0-9]+\\.[0-9] s(, [0-9]+/s)?\\)");
  return std::regex_replace(text, kSeconds, "(N s)");
}

bool HasAnotherMujoco() {
  static const bool has_another =
      RunLine("mjforge --version", std::filesystem::temp_directory_path(), true)
          .out.find("\nMuJoCo 2.") == std::string::npos;
  return has_another;
}

}  // namespace mjforge::golden
