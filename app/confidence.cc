// Bound of Clopper and Pearson for the share of failing variants, and a sentence about this bound.
#include "confidence.h"

#include <fmt/format.h>

#include <cmath>

namespace mjforge::app {

double LargestFailingShare(std::uint64_t passed) {
  // With a share p of failing variants, the probability of no failure among n random variants is
  // (1 - p)^n. The bound is the p for which this probability is 5 %; see Clopper and Pearson, "The
  // use of confidence or fiducial limits illustrated in the case of the binomial", Biometrika 26
  // (1934).
  constexpr double kDoubt = 0.05;
  return -std::expm1(std::log(kDoubt) / static_cast<double>(passed));
}

std::string ConfidenceText(std::uint64_t passed) {
  const double share = LargestFailingShare(passed);
  std::string text = fmt::format(
      "up to {:.2g} % of all variants may still fail (with 95 % confidence)", 100 * share);
  // Suggests 300 variants for 1 %, and 3000 for 0.1 %. A share up to 1.05 % counts as 1 %, and a
  // share up to 0.105 % as 0.1 %.
  if (share > 0.0105)
    text += "; -n 300 lowers that to 1 %";
  else if (share > 0.00105)
    text += "; -n 3000 lowers that to 0.1 %";
  return text;
}

}  // namespace mjforge::app
