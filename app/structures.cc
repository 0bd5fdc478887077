// Compares the structures in a batch (classes of variants with equal elements and types), and lists
// the differing fields with the parameters whose values tell the structures apart.
#include "structures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <span>

#include "console.h"
#include "mjforge/forge/forge.h"
#include "mjforge/structure/structure.h"
#include "text_table.h"

namespace mjforge::app {
namespace {

using report::Separator;
using report::StructureTally;

constexpr std::size_t kShownStructures = 20;
constexpr std::size_t kShownFields = 12;
constexpr std::size_t kShownSeparators = 3;

// Regenerates the first variant of each structure.
class Remaker {
 public:
  explicit Remaker(const std::filesystem::path& folder) : folder_(folder) {}

  // Makes the first variant of a structure again, and returns its structure. Returns nullopt, and
  // sets `why_not`, if the variant cannot be made as it was.
  std::optional<structure::Structure> operator()(const StructureTally& tally) {
    const manifest::Record& record = tally.first;
    diag::Findings findings;
    std::optional<forge::Options> options = forge::RecordedOptions(record, record.name, findings);
    if (!recipe_) recipe_ = forge::LoadRecordedRecipe(record, {}, folder_, sources_, findings);
    if (!options || !recipe_) return Fail(findings);
    options->validation = forge::Validation::kLoad;
    options->layout = forge::Layout::kAny;
    forge::Variant variant;
    forge::Generator(*recipe_, sources_, *options).Make(record.index, variant);
    if (variant.structure.Key() == tally.key) return std::move(variant.structure);
    why_not = fmt::format("variant {} has another structure now", record.index);
    if (record.mujoco != validate::MujocoVersion()) {
      why_not += fmt::format("; MuJoCo {} checked it, and this is {}", record.mujoco,
                             validate::MujocoVersion());
    }
    return std::nullopt;
  }

  std::string why_not;

 private:
  std::optional<structure::Structure> Fail(const diag::Findings& findings) {
    const diag::Finding* const error = findings.FirstError();
    if (why_not.empty()) why_not = error == nullptr ? "the spec cannot be loaded" : error->message;
    return std::nullopt;
  }

  const std::filesystem::path& folder_;
  diag::Sources sources_;
  std::optional<forge::Recipe> recipe_;
};

// Collects the fields in which structures differ from the first structure.
class FieldComparison {
 public:
  explicit FieldComparison(const std::vector<StructureTally>& structures)
      : structures_(structures) {}

  void Add(const structure::Structure& first, const structure::Structure& other,
           std::size_t number) {
    for (structure::Difference& difference : structure::DifferencesOf(first, other)) {
      auto found = std::ranges::find(fields_, difference.field,
                                     [](const ComparedField& field) { return field.shown.name; });
      if (found == fields_.end()) {
        found = fields_.emplace(found);
        found->shown.name = difference.field;
        found->shown.example = structure::Describe(difference);
        found->shown.elements = std::move(difference.elements);
        found->shown.is_coincidence = difference.is_coincidence;
        found->groups.resize(structures_.size());
      }
      found->shown.variants += structures_[number].variants;
      const auto group = static_cast<int>(found->contents.size()) + 1;
      found->groups[number] = found->contents.emplace(difference.contents, group).first->second;
    }
  }

  // Returns the fields that differ. For each field, structures that differ from the first structure
  // in the same way form a group; structures from index `compared` on belong to no group.
  std::vector<DifferingField> Take(std::size_t compared) {
    std::vector<DifferingField> fields;
    for (ComparedField& field : fields_) {
      field.groups.resize(compared);
      field.groups.resize(structures_.size(), -1);
      field.shown.separators = SeparatorsOf(structures_, field.groups);
      fields.push_back(std::move(field.shown));
    }
    return fields;
  }

 private:
  struct ComparedField {
    DifferingField shown;
    std::vector<int> groups;              // the group of each structure
    std::map<std::string, int> contents;  // the group of each text of a difference
  };

  const std::vector<StructureTally>& structures_;
  std::vector<ComparedField> fields_;
};

std::string SeparatorsText(const std::vector<Separator>& separators) {
  if (separators.empty()) return "no single parameter separates them";
  const std::size_t shown = std::min(separators.size(), kShownSeparators);
  std::string text =
      diag::Joined(std::span(separators).first(shown), " or ", [](const Separator& one) {
        const bool by_range = one.separation == report::Separation::kByRange;
        return one.parameter + (by_range ? " (by its range)" : "");
      });
  if (separators.size() > shown) text += fmt::format(" or {} more", separators.size() - shown);
  return text;
}

void WriteSeparators(diag::Json& json, const std::vector<Separator>& separators) {
  json.Each("parameters", separators, [&](const Separator& separator) {
    json.Member("name", separator.parameter);
    json.Member("by", separator.separation == report::Separation::kByValue ? "value" : "range");
  });
}

}  // namespace

BatchStructures CompareStructures(const report::ManifestSummary& batch,
                                  const std::filesystem::path& folder) {
  BatchStructures result;
  result.structures = batch.structures.list();
  result.more = batch.structures.more();
  result.variants = result.more;
  for (const StructureTally& tally : result.structures) result.variants += tally.variants;
  if (result.structures.size() < 2) return result;
  Remaker remake(folder);
  FieldComparison comparison(result.structures);
  const std::size_t compared = std::min(result.structures.size(), BatchStructures::kMaxCompared);
  const std::optional<structure::Structure> first = remake(result.structures.front());
  for (std::size_t i = 1; first && i < compared; ++i) {
    const std::optional<structure::Structure> other = remake(result.structures[i]);
    if (!other) break;
    comparison.Add(*first, *other, i);
  }
  result.why_unknown = remake.why_not;
  if (result.why_unknown.empty()) {
    result.fields = comparison.Take(compared);
    return result;
  }
  std::vector<int> groups(result.structures.size());
  std::iota(groups.begin(), groups.end(), 0);
  result.separators = SeparatorsOf(result.structures, groups);
  return result;
}

std::vector<std::string> DifferencesText(const BatchStructures& batch) {
  std::vector<std::string> lines;
  if (!batch.why_unknown.empty()) {
    lines.push_back(fmt::format("separated by: {}", SeparatorsText(batch.separators)));
    lines.push_back(fmt::format("the fields that differ are not known: {}", batch.why_unknown));
  }
  for (std::size_t i = 0; i < std::min(batch.fields.size(), kShownFields); ++i) {
    const DifferingField& field = batch.fields[i];
    lines.push_back(fmt::format("{} differs in {} of {}: {} ({})", field.name, field.variants,
                                batch.variants, SeparatorsText(field.separators), field.example));
  }
  if (batch.fields.size() > kShownFields)
    lines.push_back(fmt::format("{} more fields differ", batch.fields.size() - kShownFields));
  for (std::string& line : lines) line = OneLine(std::move(line));
  return lines;
}

std::string StructuresText(const BatchStructures& batch) {
  if (batch.structures.empty()) return {};
  if (batch.structures.size() == 1)
    return fmt::format("1 structure: {}\n", batch.structures[0].key);
  TextTable table({"structure", "variants", "first"});
  const std::size_t shown = std::min(batch.structures.size(), kShownStructures);
  std::uint64_t rest = batch.variants;
  for (std::size_t i = 0; i < shown; ++i) {
    const StructureTally& tally = batch.structures[i];
    rest -= tally.variants;
    table.Add({tally.key, fmt::format("{}", tally.variants), fmt::format("{}", tally.first.index)});
  }
  if (rest > 0) table.Add({"(others)", fmt::format("{}", rest), ""});
  std::string text = fmt::format("{}{} structures\n\n{}", batch.more > 0 ? "more than " : "",
                                 batch.structures.size(), table.Render());
  text += "\n";
  for (const std::string& line : DifferencesText(batch)) text += line + "\n";
  return text;
}

void WriteStructures(diag::Json& json, const BatchStructures& batch) {
  json.Each("structures", batch.structures, [&](const StructureTally& tally) {
    json.Member("structure", tally.key);
    json.Member("variants", tally.variants);
    json.Member("first", tally.first.index);
  });
  json.Member("variants_of_more_structures", batch.more);
  json.Each("differences", batch.fields, [&](const DifferingField& field) {
    json.Member("field", field.name);
    json.Member("elements", field.elements);
    json.Member("example", field.example);
    json.Member("coincidence", field.is_coincidence);
    json.Member("variants", field.variants);
    json.Member("of", batch.variants);
    WriteSeparators(json, field.separators);
  });
  if (batch.why_unknown.empty()) return;
  json.Member("differences_unknown", batch.why_unknown);
  WriteSeparators(json, batch.separators);
}

}  // namespace mjforge::app
