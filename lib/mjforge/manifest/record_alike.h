#pragma once

// In what the values of two records' fields differ: in numbers only, or in more.

#include <algorithm>
#include <vector>

#include "mjforge/manifest/record_values.h"

namespace mjforge::manifest {

// The numbers in what Put writes, in its order; counts do not belong to them.
template <typename T>
void AppendNumbers(const T&, std::vector<double>&) {}
inline void AppendNumbers(const double& number, std::vector<double>& out) { out.push_back(number); }
inline void AppendNumbers(const Eigen::Vector3d& point, std::vector<double>& out) {
  out.insert(out.end(), point.data(), point.data() + point.size());
}
inline void AppendNumbers(const Eigen::Matrix3d& inertia, std::vector<double>& out) {
  for (const auto& [row, column] : kInertia) out.push_back(inertia(row, column));
}
inline void AppendNumbers(const model::Box3& box, std::vector<double>& out) {
  AppendNumbers(box.min, out);
  AppendNumbers(box.max, out);
}
inline void AppendNumbers(const Members<sample::ParameterValue>& parameters,
                          std::vector<double>& out) {
  for (const auto& [name, value] : parameters) {
    if (const auto* number = std::get_if<double>(&value)) {
      out.push_back(*number);
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      out.insert(out.end(), numbers->begin(), numbers->end());
    }
  }
}

// Whether Put writes two values alike, apart from these numbers.
template <typename T>
bool IsAlike(const T& a, const T& b) {
  return a == b;
}
inline bool IsAlike(const double&, const double&) { return true; }
inline bool IsAlike(const Eigen::Vector3d&, const Eigen::Vector3d&) { return true; }
inline bool IsAlike(const Eigen::Matrix3d&, const Eigen::Matrix3d&) { return true; }
inline bool IsAlike(const model::Box3&, const model::Box3&) { return true; }
inline bool IsAlike(const sample::ParameterValue& a, const sample::ParameterValue& b) {
  if (a.index() != b.index()) return false;
  if (std::holds_alternative<double>(a)) return true;
  const auto* numbers = std::get_if<std::vector<double>>(&a);
  return numbers ? numbers->size() == std::get<std::vector<double>>(b).size() : a == b;
}
inline bool IsAlike(const Members<sample::ParameterValue>& a,
                    const Members<sample::ParameterValue>& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
    return one.first == other.first && IsAlike(one.second, other.second);
  });
}

}  // namespace mjforge::manifest
