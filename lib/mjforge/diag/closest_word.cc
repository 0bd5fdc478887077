// Finds the known word that is closest to a misspelled word, by edit distance.

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::diag {
namespace {

// Maximum length of a word that is compared. Longer words are not misspelled names, and the time of
// a comparison is proportional to the square of the length.
constexpr std::size_t kLongestWord = 128;

// Returns the "optimal string alignment" distance: the Damerau-Levenshtein distance with the
// restriction that no substring is edited twice.
std::size_t Distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

// Returns the number of letters at the beginning and at the end that two words have in common.
std::size_t EqualEnds(std::string_view a, std::string_view b) {
  const std::size_t most = std::min(a.size(), b.size());
  std::size_t first = 0;
  while (first < most && a[first] == b[first]) ++first;
  std::size_t last = 0;
  while (first + last < most && a[a.size() - 1 - last] == b[b.size() - 1 - last]) ++last;
  return first + last;
}

// Returns true if `word` may be a misspelling of `candidate`. `distance` is their edit distance
// without regard to case. Accepts 0 edits, one edit in a word of three to five letters, and one
// edit per three letters of a longer word, but fewer edits than the candidate has letters. Accepts
// one edit in a word of two letters only if the candidate has two letters, too. Accepts three or
// more edits only if they are at most half of the letters between the equal ends of both words:
// 'handle_length' is not a misspelling of 'handle_density'.
bool IsSlip(std::string_view word, std::string_view candidate, std::size_t distance) {
  if (distance == 0) return true;
  if (word.size() <= 2) {
    return word.size() == 2 && candidate.size() == 2 && distance == 1;
  }
  if (distance > std::max<std::size_t>(1, word.size() / 3) || distance >= candidate.size())
    return false;
  const std::size_t longer = std::max(word.size(), candidate.size());
  return distance < 3 || 2 * distance <= longer - EqualEnds(word, candidate);
}

}  // namespace

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::optional<std::string_view> ClosestWord(std::string_view word,
                                            std::span<const std::string_view> candidates) {
  if (word.empty() || word.size() > kLongestWord) return std::nullopt;
  const std::string lower = LowerCase(word);
  std::optional<std::string_view> best;
  std::size_t best_distance = word.size() + 1;
  std::size_t best_ends = 0;
  for (const std::string_view candidate : candidates) {
    if (candidate.empty() || candidate.size() > 2 * word.size()) continue;
    const std::string known = LowerCase(candidate);
    const std::size_t distance = Distance(lower, known);
    const std::size_t ends = EqualEnds(lower, known);
    const bool is_closer =
        distance < best_distance || (distance == best_distance && ends > best_ends);
    if (is_closer && IsSlip(lower, known, distance)) {
      best = candidate;
      best_distance = distance;
      best_ends = ends;
    }
  }
  return best;
}

std::string DidYouMean(std::string_view word, std::span<const std::string_view> candidates) {
  const std::optional<std::string_view> closest = ClosestWord(word, candidates);
  return closest ? "did you mean '" + std::string(*closest) + "'?" : std::string();
}

}  // namespace mjforge::diag
