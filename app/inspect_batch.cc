#include "inspect_batch.h"

#include <fmt/format.h>

#include <algorithm>

#include "json.h"
#include "mjforge/expr/expr.h"
#include "mjforge/forge/forge.h"
#include "table.h"

namespace mjforge::app {
namespace {

using manifest::Record;
using manifest::Statistics;

// More values than this are too many for a line of a table.
constexpr std::size_t kShownValues = 12;

bool IsSpecName(const std::string& what) {
  for (const std::filesystem::path& folder : forge::SearchPath()) {
    for (const std::string& name : spec::ListSpecs(folder)) {
      if (name == what || name.ends_with("/" + what)) return true;
    }
  }
  return false;
}

struct Batch {
  Statistics statistics;
  std::optional<Record> first;
};

std::optional<Batch> ReadBatch(const std::filesystem::path& file, diag::Sources& sources,
                               diag::Findings& findings) {
  using Outcome = manifest::RecordReader::Outcome;
  auto lines = manifest::RecordReader::Open(file, sources, findings);
  if (!lines) return std::nullopt;
  Batch batch;
  Record record;
  Outcome outcome = lines->Next(record);
  for (; outcome == Outcome::kRecord; outcome = lines->Next(record)) {
    batch.statistics.Add(record);
    if (!batch.first) batch.first = record;
  }
  if (outcome == Outcome::kBadLine) return std::nullopt;
  return batch;
}

std::string Counts(const std::map<std::string, std::uint64_t>& counts) {
  std::string text;
  for (const auto& [what, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  return text;
}

// "box 51 (51.0 %), cylinder 49 (49.0 %)"
std::string ValuesText(const Statistics::Parameter& parameter) {
  std::uint64_t total = 0;
  for (const auto& [value, count] : parameter.values) total += count;
  std::string text;
  const std::size_t shown = std::min(parameter.values.size(), kShownValues);
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& [value, count] = parameter.values[i];
    text += fmt::format("{}{} {} ({:.1f} %)", i == 0 ? "" : ", ", value, count,
                        100 * static_cast<double>(count) / static_cast<double>(total));
  }
  if (parameter.values.size() > shown)
    text += fmt::format(", and {} more", parameter.values.size() - shown);
  return text;
}

void AddRow(Table& table, const std::string& name, const Statistics::Numbers* numbers,
            const std::string& values) {
  const auto text = [&](double value) { return fmt::format("{:.6g}", value); };
  if (numbers == nullptr || numbers->count == 0) {
    table.Add({name, "", "", "", "", values});
  } else {
    table.Add({name, text(numbers->min), text(numbers->mean), text(numbers->max),
               text(numbers->StandardDeviation()), values});
  }
}

std::string Tables(const Batch& batch) {
  const Statistics& statistics = batch.statistics;
  std::string text;
  if (const std::optional<Record>& first = batch.first) {
    text += fmt::format("batch of {}, seed {}, target {}, validate {}{}{}\n", first->spec,
                        first->seed, first->target, first->validate,
                        first->sampler.empty() ? "" : ", sampler ", first->sampler);
  }
  text += fmt::format("{} variants: {}\n", statistics.variants(),
                      statistics.variants() == 0 ? "none" : Counts(statistics.statuses()));
  Table codes({"finding", "variants"});
  for (const auto& [code, count] : statistics.codes()) codes.Add({code, fmt::format("{}", count)});
  if (!codes.empty()) text += "\n" + codes.Render();
  Table table({"parameter", "min", "mean", "max", "std", "drawn"});
  for (const Statistics::Parameter& parameter : statistics.Parameters()) {
    const std::string values = ValuesText(parameter);
    if (parameter.numbers.empty()) AddRow(table, parameter.name, nullptr, values);
    for (std::size_t i = 0; i < parameter.numbers.size(); ++i) {
      const std::string name =
          parameter.numbers.size() == 1 ? parameter.name : fmt::format("{}.{}", parameter.name, i);
      AddRow(table, name, &parameter.numbers[i], values);
    }
  }
  if (statistics.mass().count > 0) {
    AddRow(table, "(mass, kg)", &statistics.mass(), "");
    if (statistics.attempts().max > 0) AddRow(table, "(attempt)", &statistics.attempts(), "");
  }
  for (const auto& [name, unit, numbers] : statistics.physics())
    AddRow(table, fmt::format("({}{}{})", name, unit.empty() ? "" : ", ", unit), &numbers, "");
  return table.empty() ? text : text + "\n" + table.Render();
}

void Write(Json& json, const Statistics::Numbers& numbers) {
  json.StartObject();
  json.Member("count", numbers.count);
  json.Member("min", numbers.min);
  json.Member("mean", numbers.mean);
  json.Member("max", numbers.max);
  json.Member("std", numbers.StandardDeviation());
  json.EndObject();
}

template <typename Pairs>
void WriteCounts(Json& json, std::string_view key, const Pairs& counts) {
  json.Key(key);
  json.StartObject();
  for (const auto& [what, count] : counts) json.Member(what, count);
  json.EndObject();
}

std::string AsJson(const Batch& batch) {
  const Statistics& statistics = batch.statistics;
  Json json;
  json.StartObject();
  if (const std::optional<Record>& first = batch.first) {
    json.Member("spec", first->spec);
    json.Member("spec_sha256", first->spec_sha256);
    json.Member("seed", first->seed);
    json.Member("target", first->target);
    json.Member("validate", first->validate);
    json.Member("sampler", first->sampler.empty() ? "random" : first->sampler);
  }
  json.Member("variants", statistics.variants());
  WriteCounts(json, "status", statistics.statuses());
  WriteCounts(json, "findings", statistics.codes());
  json.Key("parameters");
  json.StartArray();
  for (const Statistics::Parameter& parameter : statistics.Parameters()) {
    json.StartObject();
    json.Member("name", parameter.name);
    json.Key("numbers");
    json.StartArray();
    for (const Statistics::Numbers& numbers : parameter.numbers) Write(json, numbers);
    json.EndArray();
    WriteCounts(json, "values", parameter.values);
    json.Member("more_values", parameter.more_values);
    json.EndObject();
  }
  json.EndArray();
  json.Key("mass");
  Write(json, statistics.mass());
  json.Key("attempt");
  Write(json, statistics.attempts());
  json.Key("physics");
  json.StartObject();
  for (const auto& [name, unit, numbers] : statistics.physics()) {
    json.Key(name);
    Write(json, numbers);
  }
  json.EndObject();
  json.EndObject();
  return json.Line();
}

}  // namespace

std::optional<std::filesystem::path> FindManifest(const std::string& what) {
  if (what.ends_with(".jsonl") || what.ends_with(".jsonl.part")) return what;
  std::error_code ignored;
  if (!std::filesystem::is_directory(what, ignored)) return std::nullopt;
  if (!what.ends_with('/') && IsSpecName(what)) return std::nullopt;
  return std::filesystem::path(what) / "manifest.jsonl";
}

ExitStatus InspectBatch(const std::filesystem::path& manifest, bool json, Console& console) {
  diag::Sources sources;
  diag::Findings findings;
  const std::optional<Batch> batch = ReadBatch(manifest, sources, findings);
  const ExitStatus status = StatusOf(findings);
  console.Show(std::move(findings), sources);
  if (!batch) return status;
  return Print(json ? AsJson(*batch) : Tables(*batch));
}

}  // namespace mjforge::app
