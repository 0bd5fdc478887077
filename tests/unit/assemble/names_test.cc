// Tests of valid names, quoted texts and duplicate names.

#include "mjforge/assemble/names.h"

#include <catch2/catch.hpp>

namespace mjforge::assemble {
namespace {

TEST_CASE("a name is a letter, then letters, digits and underscores") {
  for (const std::string_view good : {"a", "Z", "wall_3", "aB9_"}) CHECK(IsName(good));
  for (const std::string_view bad :
       {"", "3a", "_a", "a-b", "a/b", "a b", "..", "a\n", "\xC3\xA9"}) {
    CHECK_FALSE(IsName(bad));
  }
}

TEST_CASE("quoted text stays on one line and of a sensible length") {
  CHECK(Quoted("a\nb\x07") == "'a\\nb\\x07'");
  CHECK(Quoted(std::string(200, 'x')) == "'" + std::string(80, 'x') + "...'");
}

model::Part PartNamed(std::string name, std::uint32_t line, model::Role role = model::Role::kBoth) {
  model::Part part;
  part.name = std::move(name);
  part.role = role;
  part.mark = {.file = 1, .line = line, .column = 5};
  return part;
}

diag::Findings Check(std::vector<model::Part> parts) {
  model::Object object;
  object.bodies.emplace_back().parts = std::move(parts);
  diag::Findings findings;
  CheckUniqueNames(object, findings);
  return findings;
}

TEST_CASE("a duplicate part name is reported at the second part with a note at the first") {
  const diag::Findings findings = Check({PartNamed("a", 1), PartNamed("b", 2), PartNamed("a", 3)});
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kModelDuplicateName);
  CHECK(findings[0].message == "two parts are named 'a'");
  CHECK(findings[0].mark.line == 3);
  REQUIRE(findings[0].notes.size() == 1);
  CHECK(findings[0].notes[0].mark.line == 1);
}

TEST_CASE("repeats of one entry are one finding with advice") {
  const diag::Findings findings = Check({PartNamed("a", 1), PartNamed("a", 1), PartNamed("a", 1)});
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "two parts are named 'a'");
  CHECK(findings[0].hint == "put the variable of 'for' into the name, as in wall_${i}");
  CHECK(findings[0].notes.empty());
}

TEST_CASE("a part may not take the name of another's visual twin") {
  const diag::Findings findings = Check({PartNamed("a", 1), PartNamed("a_vis", 2)});
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "two parts are named 'a_vis'");
  CHECK(findings[0].hint == "part 'a' has a visual twin of that name");
}

TEST_CASE("a part that only collides has no twin") {
  CHECK(Check({PartNamed("a", 1, model::Role::kCollision),
               PartNamed("a_vis", 2, model::Role::kVisual)})
            .empty());
}

}  // namespace
}  // namespace mjforge::assemble
