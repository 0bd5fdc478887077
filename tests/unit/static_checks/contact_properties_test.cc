// Contact bits and margins of parts.
#include "mjforge/static_checks/static_checks.h"

#include <catch2/catch.hpp>

namespace mjforge::static_checks {
namespace {

using Strings = std::vector<std::string>;

Strings CodesOf(const std::vector<model::Part>& parts) {
  model::Object object;
  object.bodies.emplace_back().parts = parts;
  diag::Findings findings;
  const model::Checks checks;
  Reporter reporter(checks, findings);
  CheckContacts(object, reporter);
  Strings codes;
  for (const diag::Finding& finding : findings) codes.emplace_back(diag::CodeName(finding.code));
  return codes;
}

model::Part Board(std::vector<std::pair<const char*, double>> numbers) {
  model::Part part;
  part.name = "board";
  for (const auto& [name, number] : numbers)
    part.attributes.push_back({.name = name, .numbers = {number}, .text = {}});
  return part;
}

}  // namespace

TEST_CASE("a part of a solid collides with something") {
  CHECK(CodesOf({Board({})}).empty());
  CHECK(CodesOf({Board({{"contype", 0}})}).empty());
  model::Part ghost = Board({{"contype", 0}, {"conaffinity", 0}});
  CHECK(CodesOf({ghost}) == Strings{"physics/no-contact"});
  ghost.role = model::Role::kVisual;
  CHECK(CodesOf({ghost}).empty());
  ghost.role = model::Role::kCollision;
  CHECK(CodesOf({ghost}) == Strings{"physics/no-contact"});
  ghost.as_is = true;  // a geom of a file is meant as it is
  CHECK(CodesOf({ghost}).empty());
}

TEST_CASE("things touch where they collide") {
  CHECK(CodesOf({Board({{"margin", 0.0009}})}).empty());
  CHECK(CodesOf({Board({{"margin", 0.02}})}) == Strings{"physics/margin"});
  CHECK(CodesOf({Board({{"margin", 0.02}, {"gap", 0.02}})}).empty());
}

TEST_CASE("the pieces of a part have one finding") {
  model::Part piece = Board({{"margin", 0.02}});
  piece.piece_of = "bowl";
  CHECK(CodesOf({piece, piece, piece}) == Strings{"physics/margin"});
}

}  // namespace mjforge::static_checks
