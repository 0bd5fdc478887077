// Sections of a report that describe the whole batch, and that fill the template page.html.

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/forge/forge.h"
#include "mjforge/report/manifest_summary.h"
#include "mjforge/report/report.h"
#include "mjforge/report/templates.h"

namespace mjforge::report {

/// Data of a batch that a page shows.
struct Batch {
  ManifestSummary summary;
  std::optional<forge::Recipe> recipe;       // nullopt if the spec is missing or has changed
  std::optional<ParameterTallies> expected;  // nullopt without a recipe
  std::string spec_text;                     // empty without a recipe, or if the text is too long
  std::vector<std::string> notices;
};

/// Seeds and indices of draws: the seeds are consecutive from `seed` on, the indices are spread
/// evenly from `first` to `first + span`.
struct DrawRange {
  std::uint64_t seed = 0;
  std::uint64_t first = 0;
  std::uint64_t span = 0;
};
/// Draws the parameters of a spec 20,000 times, or fewer if many draws are rejected. Does not count
/// draws that fail.
ParameterTallies DrawParameters(const spec::ObjectSpec& spec, const DrawRange& range);

/// Estimates the expected distributions of the parameters by DrawParameters() with other seeds than
/// the batch and indices spread over the batch. This is correct even if ranges depend on other
/// parameters or requirements reject draws. Returns empty tallies if the manifest has no records.
ParameterTallies DrawExpected(const forge::Recipe& recipe, const ManifestSummary& summary);

/// Adds the title, numbers of variants by status, facts and notices.
void AddOverview(Dictionary& page, const Request& request, const Batch& batch);
/// Adds sentences above all others, unless there are none.
void ShowNotices(Dictionary& page, const std::vector<std::string>& notices);
/// Adds the text of the spec's file `file`, unless it is empty.
void ShowSpecText(Dictionary& parent, const std::string& file, const std::string& text);

// Functions that add the sections of the page's body.
void AddFindings(Dictionary& body, const ManifestSummary& summary);
void AddParameters(Dictionary& body, const Batch& batch);
/// Adds a panel with a chart for each parameter that `is_shown` accepts, at the marker PANELS of
/// the template.
void AddParameterPanels(Dictionary& parent, const Batch& batch,
                        const std::function<bool(const ParameterTally&)>& is_shown);
void AddMassAndSize(Dictionary& body, const ManifestSummary& summary);
void AddPhysics(Dictionary& body, const ManifestSummary& summary);

/// Returns the spec's parameter with this name; null if the spec was not loaded or has no such
/// parameter.
const spec::Parameter* ParameterOf(const Batch& batch, const std::string& name);
/// Returns a parameter's unit as a page shows it; empty for the unit 1 and for null.
std::string UnitText(const spec::Parameter* parameter);

}  // namespace mjforge::report
