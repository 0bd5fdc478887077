// C interface: words of options, the catalogue, and names of manifests.
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "mjforge/forge/forge.h"
#include "text_view.h"

using namespace mjforge;
using python::View;

namespace {

template <typename Words>
void AddWords(diag::Json& json, std::string_view option, const Words& words) {
  json.Member(option, std::vector<std::string_view>(std::begin(words), std::end(words)));
}

}  // namespace

MjforgeText MjforgeWords() {
  static const std::string words = diag::JsonObject(nullptr, [](diag::Json& json) {
    AddWords(json, "target", mjcf::TargetNames());
    AddWords(json, "assets", mjcf::kAssetForms);
    AddWords(json, "sampler", sample::MethodNames());
    AddWords(json, "on_invalid", manifest::kOnInvalid);
    AddWords(json, "validate", manifest::kValidations);
    AddWords(json, "durability", output::kDurabilities);
    AddWords(json, "layout", manifest::kLayouts);
  });
  return View(words);
}

MjforgeText MjforgeCatalogue(const char* catalogue) {
  thread_local std::string text;
  diag::Json json(nullptr);
  json.StartArray();
  std::set<std::string> seen;  // the first folder of the search path has priority
  for (const std::filesystem::path& folder : forge::SearchPath(catalogue)) {
    for (const std::string& name : spec::ListSpecs(folder)) {
      if (!seen.insert(name).second) continue;
      std::error_code error;
      std::filesystem::path file = std::filesystem::absolute(folder, error) / (name + ".yaml");
      if (!bytes::Exists(file)) file.replace_extension(".yml");
      json.Value(std::vector<std::string>{name, file.string()});
    }
  }
  json.EndArray();
  text = json.Take();
  return View(text);
}

MjforgeText MjforgeManifest(const char* output, std::uint64_t shard, std::uint64_t shards) {
  thread_local std::string path;
  std::string why_not;
  const auto destination = output::ParseDestination(output, 1, why_not);
  if (!destination || !destination->HasManifest()) return {};
  path = destination->Manifest({shard, shards}).string();
  return View(path);
}
