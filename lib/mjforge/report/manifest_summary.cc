// Summary of a manifest: counting of records and their findings, and the choice of variants to
// show.

#include "mjforge/report/manifest_summary.h"

#include <fmt/format.h>
#include <rapidjson/document.h>

#include <algorithm>
#include <set>

namespace mjforge::report {
namespace {

using manifest::Record;

// Largest number of different codes of findings. Only manifests of other programs have more.
constexpr std::size_t kMaxCodes = 200;

std::string Member(const rapidjson::Value& object, const char* key) {
  const auto member = object.FindMember(key);
  if (member == object.MemberEnd() || !member->value.IsString()) return {};
  return {member->value.GetString(), member->value.GetStringLength()};
}

std::string PlaceOf(const rapidjson::Value& finding) {
  std::string place = Member(finding, "file");
  for (const char* key : {"line", "column"}) {
    const auto number = finding.FindMember(key);
    if (place.empty() || number == finding.MemberEnd() || !number->value.IsUint64()) break;
    place += fmt::format(":{}", number->value.GetUint64());
  }
  return place;
}

std::optional<double> TimeToRest(const Record& record) {
  return MeasureOf(MeasureId::kTimeToRest).of(record);
}

// Orders records by descending time to rest, then by index.
bool IsSlower(const Record& a, const Record& b) {
  const double time_a = TimeToRest(a).value_or(0);
  const double time_b = TimeToRest(b).value_or(0);
  return time_a != time_b ? time_a > time_b : a.index < b.index;
}

}  // namespace

std::vector<RecordedFinding> FindingsOf(const Record& record) {
  std::vector<RecordedFinding> findings;
  for (const std::string& json : record.findings) {
    if (diag::IsNestedTooDeep(json)) continue;
    rapidjson::Document document;
    document.Parse<rapidjson::kParseIterativeFlag>(json.data(), json.size());
    if (document.HasParseError() || !document.IsObject()) continue;
    findings.push_back({Member(document, "severity"), Member(document, "code"), PlaceOf(document),
                        Member(document, "message"), Member(document, "hint")});
  }
  return findings;
}

ManifestSummary::ManifestSummary(std::size_t shown)
    : measures(Measures().size()),
      points(kMaxPoints),
      shown_(shown),
      failed_(shown),
      good_(shown) {}

void ManifestSummary::Add(const Record& record) {
  if (!first) first = record;
  ++variants;
  last_index = record.index;
  statuses.Add(record.status);
  if (other_batch.empty()) other_batch = manifest::DifferenceOfBatch(record, *first);
  const bool is_bad = record.status != manifest::Status::kOk;
  params.Add(record.params, is_bad);
  structures.Add(record);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (const std::optional<double> value = Measures()[i].of(record))
      measures[i].Add(*value, is_bad);
  }
  if (record.physics) tests.Add(*record.physics);
  if (const std::optional<double> size = SizeOf(record))
    points.Add(record.index, {*size, record.mass_properties.mass, is_bad});
  AddFindings(record);
  (is_bad ? failed_ : good_).Add(record.index, record);
  AddSlow(record);
}

void ManifestSummary::Append(const ManifestSummary& next) {
  if (!next.first) return;
  if (!first) first = next.first;
  if (other_batch.empty()) other_batch = manifest::DifferenceOfBatch(*next.first, *first);
  if (other_batch.empty()) other_batch = next.other_batch;
  variants += next.variants;
  last_index = next.last_index;
  statuses.ok += next.statuses.ok;
  statuses.failed += next.statuses.failed;
  statuses.skipped += next.statuses.skipped;
  for (const auto& [code, tally] : next.codes) {
    if (codes.size() >= kMaxCodes && !codes.contains(code)) continue;
    const auto [known, is_new] = codes.emplace(code, tally);
    if (!is_new) known->second.variants += tally.variants;
  }
  params.Append(next.params);
  structures.Append(next.structures);
  for (std::size_t i = 0; i < measures.size(); ++i) measures[i].Append(next.measures[i]);
  tests.Append(next.tests);
  points.Append(next.points);
  failed_.Append(next.failed_);
  good_.Append(next.good_);
  for (const Record& record : next.slow_) AddSlow(record);
}

void ManifestSummary::AddFindings(const Record& record) {
  std::set<std::string> seen;
  for (RecordedFinding& finding : FindingsOf(record)) {
    if (!seen.insert(finding.code).second) continue;
    CodeTally& tally = codes[finding.code];
    if (tally.variants++ > 0) continue;
    tally.example = std::move(finding);
    tally.index = record.index;
  }
}

void ManifestSummary::AddSlow(const Record& record) {
  const std::size_t most = shown_ / 4;
  if (record.status != manifest::Status::kOk || most == 0 || !TimeToRest(record)) return;
  if (slow_.size() == most) {
    if (!IsSlower(record, slow_.front())) return;
    std::pop_heap(slow_.begin(), slow_.end(), IsSlower);
    slow_.pop_back();
  }
  slow_.push_back(record);
  std::push_heap(slow_.begin(), slow_.end(), IsSlower);
}

std::vector<ShownVariant> ManifestSummary::Choose() const {
  std::vector<ShownVariant> chosen;
  std::set<std::uint64_t> taken;
  const auto add = [&](ShownVariant::Reason reason, const std::vector<Record>& records) {
    for (const Record& record : records) {
      if (chosen.size() < shown_ && taken.insert(record.index).second)
        chosen.push_back({reason, record});
    }
  };
  // Half of the shown variants are failed or skipped ones; more if there are too few good variants.
  const auto good = static_cast<std::size_t>(std::min<std::uint64_t>(good_.seen(), shown_));
  add(ShownVariant::Reason::kFailed, failed_.Take(std::max(shown_ / 2, shown_ - good)));
  std::vector<Record> slow = slow_;
  std::sort(slow.begin(), slow.end(), IsSlower);
  slow.resize(std::min<std::size_t>(slow.size(), std::min<std::uint64_t>(shown_, variants) / 4));
  add(ShownVariant::Reason::kSlow, slow);
  const std::size_t room = shown_ - chosen.size();
  // Takes more than needed, because some items of the sample are among the slow variants.
  std::vector<Record> others = good_.Take(room + slow.size());
  std::erase_if(others, [&](const Record& record) { return taken.contains(record.index); });
  std::vector<Record> spread;
  for (std::size_t i = 0; i < std::min(room, others.size()); ++i)
    spread.push_back(others[i * others.size() / std::min(room, others.size())]);
  add(ShownVariant::Reason::kSample, spread);
  return chosen;
}

}  // namespace mjforge::report
