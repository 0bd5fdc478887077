// The variant that the page shows, kept between its requests.

#include "mjforge/customize/variant_cache.h"

#include <fmt/format.h>

#include <utility>

namespace mjforge::customize {
namespace {

// Returns a text that differs between requests with other settings.
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

ShownVariant& VariantCache::LoadSpec(const Request& request) {
  if (std::exchange(revision_, request.revision) != request.revision) snapshot_ = {};
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

ShownVariant& VariantCache::Make(const Request& request, CheckLevel level) {
  LoadSpec(request);
  if (!shown_.recipe) return shown_;
  std::string key = fmt::format("{} {}", request.seed, request.index);
  if (key == variant_key_ && shown_.level >= level) return shown_;
  const bool is_same = key == variant_key_;
  variant_key_ = std::move(key);
  MakeVariant(request, level);
  // Further checks do not change the object.
  if (!is_same || shown_.subject == nullptr) LoadSubject();
  return shown_;
}

void VariantCache::MakeVariant(const Request& request, CheckLevel level) {
  forge::Options options;
  options.seed = request.seed;
  options.validation = level == CheckLevel::kNone   ? forge::Validation::kNone
                       : level == CheckLevel::kLoad ? forge::Validation::kLoad
                                                    : forge::Validation::kPhysics;
  shown_.level = level;
  shown_.variant.emplace();
  forge::Generator(*shown_.recipe, shown_.sources, options).Make(request.index, *shown_.variant);
}

void VariantCache::LoadSubject() {
  shown_.subject = nullptr;
  shown_.joints.clear();
  const forge::Variant& variant = *shown_.variant;
  if (variant.object == nullptr) return;
  std::string why_not;
  shown_.subject = loader_.LoadText(variant.document.text, variant.document.assets, why_not);
  if (shown_.subject != nullptr) {
    shown_.joints = shown_.subject->joints();
  } else if (!variant.findings.HasErrors()) {
    shown_.variant->findings.Add(diag::Code::kMujocoError, {},
                                 fmt::format("MuJoCo refused it: {}", why_not));
  }
}

std::vector<std::filesystem::path> VariantCache::Files() const {
  if (shown_.recipe) return shown_.recipe->spec->files;
  std::vector<std::filesystem::path> files;
  for (std::uint32_t i = 1; i <= shown_.sources.size(); ++i) {
    if (shown_.sources.Name(i) != kSettingOrigin) files.emplace_back(shown_.sources.Name(i));
  }
  return files;
}

}  // namespace mjforge::customize
