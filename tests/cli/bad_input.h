// Fixture for tests of invalid input.

#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <string_view>

#include "harness/command.h"

namespace mjforge {

inline int CountOf(std::string_view text, std::string_view word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + word.size())) {
    ++count;
  }
  return count;
}

/// Checks that invalid input causes exactly one finding and that no file is written.
class BadInputTest : public harness::ProgramTest {
 protected:
  /// Writes s.yaml with this text and generates from it.
  harness::CommandResult Generate(std::string_view text) const {
    folder().Write("s.yaml", text);
    return Run({"generate", "s.yaml", "-o", "out"});
  }

  /// Checks for exactly one error, with this code, and that the folder has no new files.
  void CheckOneFinding(const harness::CommandResult& result, int status,
                       const std::string& code) const {
    INFO(result.err.substr(0, 2000));
    CHECK(result.status == status);
    CHECK(CountOf(result.err, " error: ") == 1);
    CHECK(CountOf(result.err, "[" + code + "]\n") == 1);
    CHECK(result.out.empty());
    CHECK_FALSE(std::filesystem::exists(folder() / "out"));
  }
  void CheckSpec(std::string_view text, const std::string& code) const {
    INFO(text.substr(0, 500));
    CheckOneFinding(Generate(text), 1, code);
  }
};

}  // namespace mjforge
