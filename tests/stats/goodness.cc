// Implementation of Kolmogorov-Smirnov, chi-square, moments and correlation.

#include "goodness.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

double KolmogorovSmirnov(std::vector<double> sample, const std::function<double(double)>& below) {
  std::ranges::sort(sample);
  const double n = static_cast<double>(sample.size());
  double distance = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double expected = below(sample[i]);
    const double position = static_cast<double>(i);
    distance = std::max({distance, expected - position / n, (position + 1) / n - expected});
  }
  const double x = (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n)) * distance;
  double probability = 0;
  double sign = 1;
  for (int k = 1; k <= 100; ++k, sign = -sign) {
    probability += 2 * sign * std::exp(-2 * k * k * x * x);
  }
  return std::clamp(x < 0.2 ? 1 : probability, 0.0, 1.0);  // the series needs x of some size
}

double ChiSquare(std::span<const double> counts, std::span<const double> expected) {
  double sum = 0;
  double count = 0;
  double wanted = 0;
  int classes = 0;
  double rest = 0;
  for (const double e : expected) rest += e;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    count += counts[i];
    wanted += expected[i];
    rest -= expected[i];
    const bool last = i + 1 == counts.size();
    if (!last && (wanted < 5 || rest < 5)) continue;
    sum += (count - wanted) * (count - wanted) / wanted;
    ++classes;
    count = wanted = 0;
  }
  return boost::math::gamma_q((classes - 1) / 2.0, sum / 2);
}

Moments MomentsOf(std::span<const double> sample) {
  const double n = static_cast<double>(sample.size());
  double sum = 0;
  for (const double value : sample) sum += value;
  const double mean = sum / n;
  double squares = 0;
  for (const double value : sample) squares += (value - mean) * (value - mean);
  return {mean, squares / (n - 1)};
}

double Correlation(std::span<const double> a, std::span<const double> b) {
  const Moments of_a = MomentsOf(a);
  const Moments of_b = MomentsOf(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - of_a.mean) * (b[i] - of_b.mean);
  return sum / static_cast<double>(a.size() - 1) / std::sqrt(of_a.variance * of_b.variance);
}
