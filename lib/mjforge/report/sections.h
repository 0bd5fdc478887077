#pragma once

// What a page says of a batch as a whole: numbers -> the holes of page.html.

#include <optional>
#include <string>
#include <vector>

#include "mjforge/forge/forge.h"
#include "mjforge/report/gather.h"
#include "mjforge/report/report.h"
#include "mjforge/report/templates.h"

namespace mjforge::report {

/// All that is known.
struct Batch {
  Gathered gathered;
  std::optional<forge::Recipe> recipe;    // if the spec is still what it was
  std::optional<ParameterTallies> asked;  // with the recipe
  std::string spec_text;                  // with the recipe; empty if it is too long
  std::vector<std::string> notices;
};

/// What the spec asks for, found by drawing its parameters afresh. This is right for every
/// distribution, for ranges that depend on other parameters, and for requirements. The indices are
/// the batch's, spread evenly; the seeds are different. Draws that fail are not counted.
ParameterTallies Ask(const forge::Recipe& recipe, const Gathered& gathered);

/// Title, statuses, facts and notices.
void AddOverview(Dictionary& page, const Request& request, const Batch& batch);

// Sections of the body.
void AddFindings(Dictionary& body, const Gathered& gathered);
void AddParameters(Dictionary& body, const Batch& batch);
void AddMassAndSize(Dictionary& body, const Gathered& gathered);
void AddPhysics(Dictionary& body, const Gathered& gathered);

/// The spec's parameter of that name; null without a recipe.
const spec::Parameter* ParameterOf(const Batch& batch, const std::string& name);
/// Its unit, as a page shows it; empty for the unit 1 and for null.
std::string UnitText(const spec::Parameter* parameter);

}  // namespace mjforge::report
