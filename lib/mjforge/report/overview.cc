// Overview of a batch in a report: title, numbers of variants by status, facts and notices.

#include <fmt/format.h>

#include "mjforge/report/page_sections.h"

namespace mjforge::report {
namespace {

// Width of the bar that shows the shares of the statuses, in units of its SVG.
constexpr double kBarWidth = 1000;

void AddStatuses(Dictionary& page, const ManifestSummary& summary) {
  if (summary.variants == 0) return;
  Dictionary& statuses = Section(page, "STATUSES");
  std::string text;
  double x = 0;
  using manifest::Status;
  for (const Status which : {Status::kOk, Status::kFailed, Status::kSkipped}) {
    const std::string_view status = NameOf(which);
    const std::uint64_t count = summary.statuses.Of(which);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", CountText(count), status);
    Dictionary& tile = Section(statuses, "TILE");
    Set(tile, "STATUS", status);
    Set(tile, "NUMBER", CountText(count));
    Set(tile, "SHARE", ShareText(count, summary.variants));
    if (count == 0) continue;
    Dictionary& piece = Section(statuses, "PIECE");
    const double width = kBarWidth * Share(count, summary.variants);
    Set(piece, "STATUS", status);
    Set(piece, "X", x);
    Set(piece, "WIDTH", width);
    x += width;
  }
  Set(statuses, "SUMMARY", text);
}

void AddFact(Dictionary& page, std::string_view key, std::string_view value) {
  if (value.empty()) return;
  Dictionary& fact = Section(page, "FACT");
  Set(fact, "KEY", key);
  Set(fact, "VALUE", value);
  if (value.size() > 40) Section(fact, "WIDE");
}

void AddFacts(Dictionary& page, const ManifestSummary& summary) {
  if (!summary.first) return;
  const manifest::Record& record = *summary.first;
  AddFact(page, "Spec", Clean(record.spec));
  AddFact(page, "Seed", fmt::format("{}", record.seed));
  AddFact(page, "Indices",
          summary.variants == 1 ? fmt::format("{}", record.index)
                                : fmt::format("{} to {}", record.index, summary.last_index));
  AddFact(page, "Target", Clean(record.target));
  AddFact(page, "Validated by",
          record.validate == manifest::Validation::kNone ? "nothing" : NameOf(record.validate));
  if (record.on_invalid != manifest::OnInvalid::kFail)
    AddFact(page, "If invalid", NameOf(record.on_invalid));
  AddFact(page, "Sampler", record.sampler.empty() ? "random" : Clean(record.sampler));
  for (const auto& [name, text] : record.settings)
    AddFact(page, "Set", Clean(fmt::format("{} = {}", name, text)));
  AddFact(page, "SHA-256 of the spec", Clean(record.spec_sha256));
}

}  // namespace

void AddOverview(Dictionary& page, const Request& request, const Batch& batch) {
  const ManifestSummary& summary = batch.summary;
  const std::string name = batch.recipe    ? batch.recipe->spec->name
                           : summary.first ? summary.first->spec
                                           : std::string("Empty batch");
  Set(page, "VERSION", forge::Version());
  Set(page, "NAME", Clean(name));
  Set(page, "COUNT", CountText(summary.variants, "variant"));
  Set(page, "TITLE",
      fmt::format("{}: {} - mjforge report", Clean(name), CountText(summary.variants, "variant")));
  Set(page, "MANIFEST", Clean(request.manifest.generic_string()));
  if (batch.recipe) ShowText(page, "DESCRIPTION", Clean(batch.recipe->spec->description, 1000));
  AddStatuses(page, summary);
  AddFacts(page, summary);
  ShowNotices(page, batch.notices);
}

void ShowNotices(Dictionary& page, const std::vector<std::string>& notices) {
  if (notices.empty()) return;
  Dictionary& section = Section(page, "HAS_NOTICES");
  for (const std::string& notice : notices) ShowText(section, "NOTICE", Clean(notice, 1000));
}

void ShowSpecText(Dictionary& parent, const std::string& file, const std::string& text) {
  if (text.empty()) return;
  Dictionary& section = Section(parent, "SPEC_TEXT");
  Set(section, "FILE", Clean(file));
  Set(section, "TEXT", text);
}

const spec::Parameter* ParameterOf(const Batch& batch, const std::string& name) {
  return batch.recipe ? batch.recipe->spec->FindParameter(name) : nullptr;
}

std::string UnitText(const spec::Parameter* parameter) {
  return parameter == nullptr || parameter->unit == "1" ? "" : Clean(parameter->unit, 20);
}

}  // namespace mjforge::report
