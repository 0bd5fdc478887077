// `mjforge inspect` of a batch: statistics of its manifest.
#include <fmt/format.h>

#include <algorithm>

#include "inspect.h"
#include "json_output.h"
#include "mjforge/report/report.h"
#include "options.h"
#include "structures.h"
#include "text_table.h"

namespace mjforge::app {
namespace {

using manifest::Record;
using report::ManifestSummary;
using report::ParameterTally;
using report::Statistics;

constexpr std::size_t kShownValues = 12;  // largest number of values in a line of a table

bool IsSpecName(const std::string& what) {
  for (const std::filesystem::path& folder : forge::SearchPath()) {
    for (const std::string& name : spec::ListSpecs(folder)) {
      if (name == what || name.ends_with("/" + what)) return true;
    }
  }
  return false;
}

std::string StatusesText(const ManifestSummary& batch) {
  std::string text;
  for (const manifest::Status status : manifest::kStatusesByName) {
    if (const std::uint64_t count = batch.statuses.Of(status); count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, NameOf(status));
  }
  return text.empty() ? "none" : text;
}

// Returns the values that were drawn for the variants that are ok, with the count of each value.
std::vector<std::pair<std::string, std::uint64_t>> ValuesOf(const ParameterTally& parameter) {
  std::vector<std::pair<std::string, std::uint64_t>> values;
  for (const auto& [value, counts] : parameter.Values()) {
    if (counts.good() > 0) values.emplace_back(value, counts.good());
  }
  return values;
}

// Returns values with counts and shares: "box 51 (51.0 %), cylinder 49 (49.0 %)".
std::string ValuesText(const ParameterTally& parameter) {
  const auto values = ValuesOf(parameter);
  std::uint64_t total = 0;
  for (const auto& [value, count] : values) total += count;
  const std::size_t shown = std::min(values.size(), kShownValues);
  std::string text = diag::Joined(std::span(values).first(shown), ", ", [&](const auto& value) {
    const double share = static_cast<double>(value.second) / static_cast<double>(total);
    return fmt::format("{} {} ({:.1f} %)", value.first, value.second, 100 * share);
  });
  if (values.size() > shown) text += fmt::format(", and {} more", values.size() - shown);
  return text;
}

void AddRow(TextTable& table, const std::string& name, const Statistics& numbers,
            const std::string& values = {}) {
  const auto text = [&](double value) {
    return numbers.count == 0 ? "" : fmt::format("{:.6g}", value);
  };
  table.Add({name, text(numbers.min), text(numbers.mean), text(numbers.max),
             text(numbers.StandardDeviation()), values});
}

void AddMeasures(const ManifestSummary& batch, TextTable& table) {
  const Statistics& mass = batch.Of(report::MeasureId::kMass).good;
  const Statistics& attempts = batch.Of(report::MeasureId::kAttempts).good;
  if (mass.count > 0) AddRow(table, "(mass, kg)", mass);
  if (attempts.max > 0) AddRow(table, "(attempt)", attempts);
  for (const report::Measure& measure : report::Measures()) {
    const Statistics& numbers = batch.Of(measure.id).good;
    if (!measure.is_physics || numbers.count == 0) continue;
    AddRow(table,
           fmt::format("({}{}{})", measure.key, measure.unit.empty() ? "" : ", ", measure.unit),
           numbers);
  }
}

std::string Tables(const ManifestSummary& batch, const BatchStructures& structures) {
  std::string text;
  if (const std::optional<Record>& first = batch.first) {
    text += OneLine(fmt::format("batch of {}, seed {}, target {}, validate {}{}{}", first->spec,
                                first->seed, first->target, NameOf(first->validate),
                                first->sampler.empty() ? "" : ", sampler ", first->sampler)) +
            "\n";
  }
  text += fmt::format("{} variants: {}\n", batch.variants, StatusesText(batch));
  text += StructuresText(structures);
  TextTable codes({"finding", "variants"});
  for (const auto& [code, tally] : batch.codes)
    codes.Add({code, fmt::format("{}", tally.variants)});
  if (!codes.empty()) text += "\n" + codes.Render();
  TextTable table({"parameter", "min", "mean", "max", "std", "drawn"});
  for (const ParameterTally& parameter : batch.params.list()) {
    const std::string values = ValuesText(parameter);
    const std::size_t count = parameter.numbers.size();
    if (count == 0) AddRow(table, parameter.name, {}, values);
    for (std::size_t i = 0; i < count; ++i) {
      AddRow(table, parameter.NameOf(i), parameter.numbers[i].good, values);
    }
  }
  AddMeasures(batch, table);
  return table.empty() ? text : text + "\n" + table.Render();
}

void Write(diag::Json& json, const Statistics& numbers) {
  json.Member("count", numbers.count);
  json.Member("min", numbers.min);
  json.Member("mean", numbers.mean);
  json.Member("max", numbers.max);
  json.Member("std", numbers.StandardDeviation());
}

void Write(diag::Json& json, std::string_view key, const Statistics& numbers) {
  json.Object(key, [&] { Write(json, numbers); });
}

void Write(diag::Json& json, const ParameterTally& parameter) {
  json.Member("name", parameter.name);
  json.Each("numbers", parameter.numbers,
            [&](const report::NumberTally& numbers) { Write(json, numbers.good); });
  json.Object("values", [&] { json.Members(ValuesOf(parameter)); });
  json.Member("more_values", parameter.more_texts);
}

void WriteCounts(diag::Json& json, const ManifestSummary& batch) {
  json.Member("variants", batch.variants);
  json.Object("status", [&] {
    for (const manifest::Status status : manifest::kStatusesByName) {
      if (const std::uint64_t count = batch.statuses.Of(status); count > 0)
        json.Member(NameOf(status), count);
    }
  });
  json.Object("findings", [&] {
    for (const auto& [code, tally] : batch.codes) json.Member(code, tally.variants);
  });
}

std::string AsJson(const ManifestSummary& batch, const BatchStructures& structures) {
  return JsonLine([&](diag::Json& json) {
    if (const std::optional<Record>& first = batch.first) {
      json.Member("spec", first->spec);
      json.Member("spec_sha256", first->spec_sha256);
      json.Member("seed", first->seed);
      json.Member("target", first->target);
      json.Member("validate", NameOf(first->validate));
      json.Member("sampler", first->sampler.empty() ? "random" : first->sampler);
    }
    WriteCounts(json, batch);
    WriteStructures(json, structures);
    json.Each("parameters", batch.params.list(),
              [&](const ParameterTally& parameter) { Write(json, parameter); });
    Write(json, "mass", batch.Of(report::MeasureId::kMass).good);
    Write(json, "attempt", batch.Of(report::MeasureId::kAttempts).good);
    json.Object("physics", [&] {
      for (const report::Measure& measure : report::Measures()) {
        const Statistics& numbers = batch.Of(measure.id).good;
        if (measure.is_physics && numbers.count > 0) Write(json, measure.key, numbers);
      }
    });
  });
}

}  // namespace

std::optional<std::filesystem::path> FindManifest(const std::string& what) {
  const bool is_folder = bytes::IsFolder(what);
  if (is_folder && !what.ends_with('/') && IsSpecName(what)) return std::nullopt;
  const std::optional<std::filesystem::path> manifest = output::ManifestOf(what);
  const bool is_batch =
      manifest && (is_folder || output::IsManifest(what) || bytes::Exists(*manifest));
  return is_batch ? manifest : std::nullopt;
}

ExitStatus InspectBatch(const std::filesystem::path& manifest, bool json, Console& console) {
  diag::Sources sources;
  diag::Findings findings;
  std::uint64_t bad_lines = 0;
  const std::optional<ManifestSummary> batch =
      report::Summarize(manifest, 0, sources, findings, bad_lines);
  const ExitStatus status = StatusOf(findings);
  console.Show(std::move(findings), sources);
  if (!batch || bad_lines > 0) return status;
  const BatchStructures structures = CompareStructures(*batch, manifest.parent_path());
  return json ? PrintBytes(AsJson(*batch, structures)) : Print(Tables(*batch, structures));
}

}  // namespace mjforge::app
