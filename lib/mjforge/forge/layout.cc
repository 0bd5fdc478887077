// Check that all variants of a batch have the same structure (--layout one).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjforge/expr/expr.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

using sample::ParameterValue;

constexpr std::size_t kShownParameters = 3;

// Returns the text of a value that may be the option of a choice: a text, a boolean or a whole
// number. Returns nullopt for other values.
std::optional<std::string> ChoiceText(const ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || *number != std::round(*number)) return std::nullopt;
  return expr::NumberText(*number);
}

// Lists the parameters that may be choices and differ between two variants: "shape is box, not
// round". Lists at most kShownParameters of them, and the number of further ones.
std::string ChoicesText(const manifest::Record& record, const manifest::Record& reference) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(record.params.size(), reference.params.size()); ++i) {
    const auto& [name, value] = record.params[i];
    const std::optional<std::string> here = ChoiceText(value);
    const std::optional<std::string> there = ChoiceText(reference.params[i].second);
    if (!here || !there || *here == *there || ++count > kShownParameters) continue;
    text += fmt::format("{}{} is {}, not {}", text.empty() ? "" : ", ", name, *here, *there);
  }
  if (count > kShownParameters) text += fmt::format(" and {} more", count - kShownParameters);
  return text;
}

// Returns the place in the spec of the body, part, joint or site with the name `element`, with or
// without the object's name as a prefix; an empty mark if there is none.
diag::SourceMark MarkOf(const model::Object& object, std::string_view element) {
  const std::string whole = fmt::format("{}_{}", object.name, element);
  const auto is_it = [&](const auto& one) {
    return one.mark && (one.name == element || one.name == whole);
  };
  if (const auto* body = diag::FindIf(object.bodies, is_it)) return body->mark;
  for (const model::Body& body : object.bodies) {
    if (const auto* part = diag::FindIf(body.parts, is_it)) return part->mark;
    if (const auto* joint = diag::FindIf(body.joints, is_it)) return joint->mark;
    if (const auto* site = diag::FindIf(body.sites, is_it)) return site->mark;
  }
  return {};
}

diag::SourceMark MarkOf(const model::Object& object, const structure::Difference& difference) {
  for (const std::string& element : difference.elements) {
    if (const diag::SourceMark mark = MarkOf(object, element)) return mark;
  }
  return object.bodies.front().mark;
}

}  // namespace

void Generator::FindReference() {
  reference_.emplace();
  const Options options = options_;
  options_.layout = Layout::kAny;
  options_.attempt = 0;  // a replay sets the attempt of its own record
  Variant variant;
  for (std::uint64_t i = 0; i < kMaxReferences; ++i) {
    Make(options.layout_first + i, variant);
    if (variant.ok()) {
      *reference_ = {variant.record, std::move(variant.structure)};
      break;
    }
  }
  options_ = options;
}

bool Generator::CheckStructure(Variant& variant) const {
  if (options_.layout != Layout::kOne) return true;
  const auto& [reference, structure] = *reference_;
  if (variant.structure == structure) return true;
  const model::Object& object = *variant.object;
  if (structure.empty()) {
    variant.findings.Add(
        diag::Code::kMujocoStructure, object.bodies.front().mark,
        fmt::format("there is no structure to compare with: none of the {} variants from {} on is "
                    "valid",
                    kMaxReferences, options_.layout_first),
        "begin the batch at a valid variant, with --first");
    return false;
  }
  std::vector<structure::Difference> differences =
      structure::DifferencesOf(structure, variant.structure);
  if (options_.family) {
    std::erase_if(differences, [](const auto& difference) { return difference.is_coincidence; });
    if (differences.empty()) return true;
  }
  std::string text = structure::Describe(differences.front());
  if (differences.size() > 1) {
    text += fmt::format(", and {} more {}", differences.size() - 1,
                        differences.size() == 2 ? "field differs" : "fields differ");
  }
  const std::string choices = ChoicesText(variant.record, reference);
  variant.findings.Add(
      diag::Code::kMujocoStructure, MarkOf(object, differences.front()),
      fmt::format("not the structure of variant {}: {}{}", reference.index, text,
                  choices.empty() ? "" : fmt::format(" ({})", choices)),
      options_.family
          ? fmt::format("{}pin the parameter with --set; --on-invalid resample draws such variants "
                        "again",
                        options_.pad > 0 ? "only geoms and sites can be null; "
                                         : "--pad makes geoms that a variant lacks null; ")
          : std::string("--layout split writes a folder per structure; --on-invalid resample draws "
                        "such variants again"));
  return false;
}

}  // namespace mjforge::forge
