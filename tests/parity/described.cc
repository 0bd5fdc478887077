// Canonical numbers and names of described elements.

#include "described.h"

#include <algorithm>
#include <cmath>

namespace mjforge::parity {

std::string WithoutPrefix(std::string_view name, std::string_view prefix) {
  if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  return std::string(name);
}

std::string PartOf(std::string_view element) {
  if (element.starts_with("geom/") && element.ends_with("_vis")) element.remove_suffix(4);
  return std::string(element);
}

Numbers Filled(const Numbers& given, const Numbers& defaults) {
  Numbers out = defaults;
  std::copy_n(given.begin(), std::min(given.size(), out.size()), out.begin());
  return out;
}

Numbers Canonical(const Numbers& quaternion) {
  double norm = 0;
  for (const double component : quaternion) norm += component * component;
  norm = std::sqrt(norm);
  // The w of a half turn is 0 with a rounding error of either sign, so the next component decides.
  const auto leading = std::ranges::find_if(
      quaternion, [norm](double component) { return std::abs(component) > 1e-6 * norm; });
  const double scale = (*leading < 0 ? -1 : 1) / norm;
  Numbers out;
  for (const double component : quaternion) out.push_back(component * scale);
  return out;
}

Numbers UsedSize(std::string_view type, const Numbers& size) {
  std::size_t count = 3;
  if (type == "sphere") count = 1;
  if (type == "capsule" || type == "cylinder") count = 2;
  return Numbers(size.begin(),
                 size.begin() + static_cast<std::ptrdiff_t>(std::min(count, size.size())));
}

bool Close(std::string_view field, const Numbers& a, const Numbers& b) {
  if (a.size() != b.size()) return false;
  double scale = 0;
  for (const double value : b) scale = std::max(scale, std::abs(value));
  // The absolute tolerance does not apply to mass and inertia, which are far below 1e-9 in small
  // objects.
  const bool is_mass = field == "mass" || field == "inertia";
  const double tolerance = 1e-6 * scale + (is_mass ? 0 : 1e-9);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;
  }
  return true;
}

}  // namespace mjforge::parity
