// Statuses of variants, and options of a whole batch (validation, invalid variants, layout), with
// their names in records and on the command line.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace mjforge::manifest {

/// Result of making a variant. Failed and skipped variants have errors among their findings and no
/// file.
enum class Status { kOk, kFailed, kSkipped };
/// Checks of each variant. kNone: none; kLoad: MuJoCo loads the variant, and the model is compared
/// with the object; kPhysics: the variant is also simulated.
enum class Validation { kNone, kLoad, kPhysics };
/// Treatment of an invalid variant.
enum class OnInvalid {
  kFail,      // an error is reported, and the other variants are made
  kSkip,      // a warning is reported, and the other variants are made
  kResample,  // the variant is drawn again, up to forge::kMaxResamples times, then treated as kFail
};
/// Requirement on the structures of a batch's variants. Variants with one structure have compiled
/// models with equal elements and types (structure.h).
enum class Layout {
  kAny,    // a variant may have any structure
  kOne,    // a variant is invalid if its structure differs from that of the first valid variant
  kSplit,  // the file of a variant is in a folder that is named by the key of its structure
};

// Names of the enumerators above, in the same order.
inline constexpr std::string_view kStatuses[] = {"ok", "failed", "skipped"};
inline constexpr std::string_view kValidations[] = {"none", "load", "physics"};
inline constexpr std::string_view kOnInvalid[] = {"fail", "skip", "resample"};
inline constexpr std::string_view kLayouts[] = {"any", "one", "split"};
constexpr std::span<const std::string_view> WordsOf(Status) { return kStatuses; }
constexpr std::span<const std::string_view> WordsOf(Validation) { return kValidations; }
constexpr std::span<const std::string_view> WordsOf(OnInvalid) { return kOnInvalid; }
constexpr std::span<const std::string_view> WordsOf(Layout) { return kLayouts; }

// Statuses in alphabetical order of their names.
inline constexpr Status kStatusesByName[] = {Status::kFailed, Status::kOk, Status::kSkipped};

template <typename Enum>
constexpr std::string_view NameOf(Enum value) {
  return WordsOf(value)[static_cast<std::size_t>(value)];
}
/// Returns the enumerator with that name; nullopt if no enumerator has the name.
template <typename Enum>
constexpr std::optional<Enum> Find(std::string_view word) {
  for (std::size_t i = 0; i < WordsOf(Enum()).size(); ++i) {
    if (WordsOf(Enum())[i] == word) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

}  // namespace mjforge::manifest
