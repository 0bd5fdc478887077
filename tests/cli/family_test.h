// Runs of `generate` that make families, and the arrays of these.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "harness/command.h"
#include "harness/npz.h"

namespace mjforge {

class FamilyTest : public harness::ProgramTest {
 protected:
  // Runs `generate` with these arguments; fails the test unless the status is as expected.
  harness::CommandResult Generate(std::vector<std::string> arguments, int status = 0) const {
    arguments.insert(arguments.begin(), {"generate", "-q", "--seed", "7"});
    harness::CommandResult result = Run(std::move(arguments));
    INFO(result.err);
    CHECK(result.status == status);
    return result;
  }
  std::map<std::string, harness::NpyArray> Arrays(const std::string& file) const {
    return harness::NpzByName(folder().Read(file));
  }
  nlohmann::json Facts(const std::string& file) const {
    return nlohmann::json::parse(Arrays(file).at("family").bytes);
  }
};

// Returns the number of an element in the names beside an array.
inline std::size_t NumberOf(const std::map<std::string, harness::NpyArray>& arrays,
                            const std::string& field, const std::string& element) {
  const std::vector<std::string> names = arrays.at(field + ".names").Texts();
  const auto found = std::ranges::find(names, element);
  REQUIRE(found != names.end());
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace mjforge
