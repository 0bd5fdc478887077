// Listing and saving of presets: files of parameter values for the option --params.

#include "mjforge/customize/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "mjforge/customize/settings_text.h"
#include "mjforge/output/output.h"

namespace mjforge::customize {
namespace {

constexpr std::string_view kEnding = ".params.yaml";
constexpr std::string_view kFirstWords = "# Values for mjforge: ";
constexpr std::size_t kLongestName = 60;

}  // namespace

bool Presets::IsValidName(std::string_view name) {
  constexpr std::string_view kCharacters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !name.empty() && name.size() <= kLongestName &&
         name.find_first_not_of(kCharacters) == name.npos;
}

std::vector<std::string> Presets::List() const {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const std::filesystem::path& entry : output::EntriesOf(folder_, ignored)) {
    const std::string file = entry.filename().string();
    if (!file.starts_with(stem_ + ".") || !file.ends_with(kEnding)) continue;
    const std::size_t first = stem_.size() + 1;
    if (file.size() <= first + kEnding.size()) continue;
    std::string name = file.substr(first, file.size() - first - kEnding.size());
    if (IsValidName(name)) names.push_back(std::move(name));
  }
  std::ranges::sort(names);
  return names;
}

std::filesystem::path Presets::FileOf(std::string_view name) const {
  return folder_ / fmt::format("{}.{}{}", stem_, name, kEnding);
}

bool Presets::Save(std::string_view name, std::span<const spec::Setting> settings,
                   diag::Findings& findings) const {
  const std::filesystem::path file = FileOf(name);
  const auto is_ours = [](std::string_view start) { return start.starts_with(kFirstWords); };
  return output::MayReplace(file, false, kFirstWords.size(), is_ours, findings) &&
         output::WriteSingleFile(file,
                                 fmt::format("{}--params {}\n{}", kFirstWords,
                                             file.filename().string(), ParamsText(settings)),
                                 findings);
}

}  // namespace mjforge::customize
