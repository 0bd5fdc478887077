#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mjforge/expr/expr.h"
#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {
namespace {

// Whole numbers are counted one by one while they are this few.
constexpr std::size_t kMaxWholeNumbers = 40;

struct Measure {
  std::string_view name;
  std::string_view unit;
  double (*of)(const physics::Result&);
};

constexpr Measure kMeasures[] = {
    {"time", "s", [](const physics::Result& r) { return r.time; }},
    {"drift", "m", [](const physics::Result& r) { return r.drift; }},
    {"tilt", "rad", [](const physics::Result& r) { return r.tilt; }},
    {"penetration", "m", [](const physics::Result& r) { return r.penetration; }},
    {"sink", "m", [](const physics::Result& r) { return r.sink; }},
    {"ncon", "", [](const physics::Result& r) { return static_cast<double>(r.ncon); }},
    {"nefc", "", [](const physics::Result& r) { return static_cast<double>(r.nefc); }},
    {"overlap", "", [](const physics::Result& r) { return r.overlap; }},
};

std::string CodeOf(const std::string& finding) {
  rapidjson::Document document;
  document.Parse(finding.data(), finding.size());
  if (!document.IsObject()) return {};
  if (!document.HasMember("code") || !document["code"].IsString()) return {};
  return document["code"].GetString();
}

}  // namespace

void Statistics::Numbers::Add(double value) {
  min = count == 0 ? value : std::min(min, value);
  max = count == 0 ? value : std::max(max, value);
  ++count;
  const auto n = static_cast<double>(count);
  const double distance = value - mean;
  // The largest numbers of both signs have no distance that is a number.
  mean += std::isfinite(distance) ? distance / n : value / n - mean / n;
  m2 += distance * (value - mean);
}

double Statistics::Numbers::StandardDeviation() const {
  return count == 0 ? 0 : std::sqrt(m2 / static_cast<double>(count));
}

void Statistics::Add(const Record& record) {
  ++variants_;
  ++statuses_[record.status];
  std::set<std::string> codes;
  for (const std::string& finding : record.findings) codes.insert(CodeOf(finding));
  for (const std::string& code : codes) ++codes_[code];
  if (record.status != "ok") return;
  mass_.Add(record.mass_properties.mass);
  attempts_.Add(static_cast<double>(record.attempt));
  if (record.physics) AddPhysics(*record.physics);
  for (std::size_t i = 0; i < record.params.size(); ++i) {
    AddParameter(TallyOf(record.params[i].first, i), record.params[i].second);
  }
}

void Statistics::AddPhysics(const physics::Result& result) {
  if (physics_.empty()) {
    for (const Measure& measure : kMeasures) physics_.push_back({measure.name, measure.unit, {}});
  }
  for (std::size_t i = 0; i < physics_.size(); ++i)
    physics_[i].numbers.Add(kMeasures[i].of(result));
}

Statistics::Tally& Statistics::TallyOf(const std::string& name, std::size_t position) {
  // The same place in every record of a batch; a search where it is not.
  if (position < tallies_.size() && tallies_[position].name == name) return tallies_[position];
  const auto known = std::find_if(tallies_.begin(), tallies_.end(),
                                  [&](const Tally& tally) { return tally.name == name; });
  if (known != tallies_.end()) return *known;
  Tally& tally = tallies_.emplace_back();
  tally.name = name;
  return tally;
}

void Statistics::AddParameter(Tally& tally, const sample::ParameterValue& value) {
  const auto count_text = [&](const std::string& text) {
    if (tally.texts.size() < kMaxValues || tally.texts.contains(text)) {
      ++tally.texts[text];
    } else {
      tally.more_values = true;
    }
  };
  if (const auto* text = std::get_if<std::string>(&value)) {
    count_text(*text);
  } else if (const auto* flag = std::get_if<bool>(&value)) {
    count_text(*flag ? "true" : "false");
  } else if (const auto* number = std::get_if<double>(&value)) {
    tally.numbers.resize(1);
    tally.numbers[0].Add(*number);
    tally.all_whole = tally.all_whole && *number == std::round(*number);
    if (tally.all_whole && tally.whole.size() <= kMaxWholeNumbers) ++tally.whole[*number];
  } else {
    const auto& vector = std::get<std::vector<double>>(value);
    tally.numbers.resize(std::max(tally.numbers.size(), vector.size()));
    for (std::size_t i = 0; i < vector.size(); ++i) tally.numbers[i].Add(vector[i]);
    tally.all_whole = false;
  }
}

std::vector<Statistics::Parameter> Statistics::Parameters() const {
  std::vector<Parameter> parameters;
  for (const Tally& tally : tallies_) {
    Parameter& parameter = parameters.emplace_back();
    parameter.name = tally.name;
    parameter.numbers = tally.numbers;
    parameter.more_values = tally.more_values;
    if (tally.all_whole && tally.whole.size() <= kMaxWholeNumbers) {
      for (const auto& [value, count] : tally.whole)
        parameter.values.emplace_back(expr::NumberText(value), count);
    }
    parameter.values.insert(parameter.values.end(), tally.texts.begin(), tally.texts.end());
  }
  return parameters;
}

}  // namespace mjforge::manifest
