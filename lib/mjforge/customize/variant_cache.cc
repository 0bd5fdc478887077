// Loads the spec and generates variants for the requests of `mjforge customize`. Reuses the results
// of the last request.

#include "mjforge/customize/variant_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mjforge/customize/settings_text.h"
#include "mjforge/expr/expr.h"

namespace mjforge::customize {
namespace {

// Returns a text that identifies the revision and the settings of a request.
std::string KeyOf(const Request& request) {
  std::string key = fmt::format("{}\n", request.revision);
  for (const spec::Setting& setting : request.settings)
    key += fmt::format("{} {}{}{}", setting.name.size(), setting.text.size(), setting.name,
                       setting.text);
  return key;
}

}  // namespace

diag::Findings ShownVariant::Findings() const {
  diag::Findings all = spec_findings;
  if (variant) all.Append(variant->findings);
  return all;
}

// Discards everything that was read from the spec's files if the revision has changed.
void VariantCache::Renew(std::uint64_t revision) {
  if (std::exchange(revision_, revision) == revision) return;
  snapshot_ = {};
  names_.reset();
  loader_.emplace();  // the old loader caches meshes and textures
}

void VariantCache::FindNames(std::uint64_t revision) {
  Renew(revision);
  if (names_) return;
  Request bare;
  bare.revision = revision;
  names_.emplace();
  choices_.clear();
  const ShownVariant& shown = LoadSpec(bare);
  if (!shown.recipe) return;
  const spec::ObjectSpec& spec = *shown.recipe->spec;
  for (const spec::Parameter& parameter : spec.parameters) {
    names_->insert({parameter.name, parameter.record});
    if (spec::ConstantChoices(spec.ValueOf(parameter))) choices_.insert(parameter.name);
  }
}

void VariantCache::QuoteTexts(Request& request) {
  if (request.values.empty()) return;
  FindNames(request.revision);
  const auto is_plain = [this](std::string_view word) {
    return expr::IsName(word) && word != "index" && !expr::IsReserved(word) &&
           !names_->contains(word);
  };
  for (const std::size_t i : request.values) {
    auto& [name, text, origin] = request.settings[i];
    const auto words = expr::WordsOf(text);
    const bool is_read_as_text =
        !words.empty() && text.starts_with(words[0]) && std::ranges::all_of(words, is_plain);
    // Writes an option of a parameter with choices as a plain text, because the value must be
    // spelled like the option in the spec.
    text = is_read_as_text || choices_.contains(name) ? QuoteForYaml(text) : LiteralForYaml(text);
  }
}

ShownVariant& VariantCache::LoadSpec(const Request& request) {
  Renew(request.revision);
  std::string key = KeyOf(request);
  if (key == key_) return shown_;
  key_ = std::move(key);
  variant_key_.clear();
  shown_ = {};
  spec::LoadOptions load;
  load.settings = request.settings;
  load.search_path = search_path_;
  snapshot_.search_path = search_path_;
  load.snapshot = &snapshot_;
  shown_.recipe = forge::LoadRecipe(reference_, load, shown_.sources, shown_.spec_findings);
  return shown_;
}

ShownVariant& VariantCache::Make(const Request& request, Validation level) {
  LoadSpec(request);
  if (!shown_.recipe) return shown_;
  std::string key = fmt::format("{} {}", request.seed, request.index);
  if (key == variant_key_ && shown_.level >= level) return shown_;
  const bool is_same = key == variant_key_;
  variant_key_ = std::move(key);
  MakeVariant(request, level);
  // Keeps the subject if only the level of checks changed, because checks do not change the object.
  if (!is_same || shown_.subject == nullptr) LoadSubject();
  return shown_;
}

void VariantCache::MakeVariant(const Request& request, Validation level) {
  shown_.level = level;
  shown_.variant.emplace();
  forge::Generator(*shown_.recipe, shown_.sources,
                   {.seed = request.seed, .place_seed = place_seed_, .validation = level})
      .Make(request.index, *shown_.variant);
}

void VariantCache::LoadSubject() {
  shown_.subject = nullptr;
  shown_.joints.clear();
  const forge::Variant& variant = *shown_.variant;
  if (variant.object == nullptr) return;
  assets_.clear();
  for (const bytes::Asset& asset : variant.document.assets) {
    if (!asset.file.empty()) assets_.push_back(asset.file);
  }
  std::string why_not;
  shown_.subject = loader_->LoadText(variant.document.text, variant.document.assets, why_not);
  if (shown_.subject != nullptr) {
    shown_.joints = shown_.subject->joints();
  } else if (!variant.findings.HasErrors()) {
    shown_.variant->findings.Add(diag::Code::kMujocoError, {},
                                 fmt::format("MuJoCo refused it: {}", why_not));
  }
}

std::vector<std::filesystem::path> VariantCache::Files() const {
  std::set<std::filesystem::path> files(assets_.begin(), assets_.end());
  for (std::uint32_t i = 1; i <= shown_.sources.size(); ++i) {
    if (shown_.sources.Name(i) != kSettingOrigin) files.emplace(shown_.sources.Name(i));
  }
  for (const diag::Finding& finding : shown_.Findings())
    files.insert(finding.files.begin(), finding.files.end());
  return {files.begin(), files.end()};
}

}  // namespace mjforge::customize
