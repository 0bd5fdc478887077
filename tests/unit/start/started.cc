#include "started.h"

#include <optional>

#include <catch2/catch.hpp>

#include "mjforge/assemble/assemble.h"
#include "mjforge/spec/spec.h"
#include "mjforge/start/start.h"

namespace mjforge::start {

model::Object Assembled(const std::string& body) {
  diag::Sources sources;
  diag::Findings findings;
  const auto spec = spec::LoadSpecText("thing.yaml", "mjforge: 1\nname: thing\n" + body, ".", {},
                                       sources, findings);
  std::optional<model::Object> object;
  if (spec != nullptr) {
    auto values = sample::Sample(*spec, {.seed = 1}, sample::kRootStream, {}, findings);
    assemble::Assembler assembler;
    if (values) object = assembler.Assemble(*values, {}, findings);
  }
  std::string messages;
  for (const diag::Finding& finding : findings) messages += finding.message + "\n";
  INFO(messages);
  REQUIRE(object);
  return *std::move(object);
}

model::Object Started(const std::string& body) {
  model::Object object = Assembled(body);
  REQUIRE(FindObstacles(object).empty());
  MoveZeroToStart(object);
  return object;
}

std::vector<std::string> Obstacles(const std::string& body) {
  std::vector<std::string> lines;
  for (const Obstacle& obstacle : FindObstacles(Assembled(body))) {
    lines.push_back(std::to_string(obstacle.mark.line) + ": " + obstacle.reason);
    if (!obstacle.remedy.empty()) lines.back() += " (" + obstacle.remedy + ")";
  }
  return lines;
}

std::vector<double> NumbersIn(const model::Object& object, std::string_view section,
                              const std::string& element, std::string_view attribute) {
  for (const model::Element& one : model::ElementsOf(object, section)) {
    if (one.name != element) continue;
    const auto* found = model::FindAttribute(one.attributes, attribute);
    if (found != nullptr) return {found->numbers.begin(), found->numbers.end()};
  }
  return {};
}

}  // namespace mjforge::start
