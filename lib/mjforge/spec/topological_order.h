#pragma once

#include <functional>
#include <vector>

namespace mjforge::spec {

/// The order in which things can be read that use each other: each after those that it uses.
/// `uses` has the positions of these, for each. Circles are handed to `on_cycle` as paths that end
/// where they begin.
std::vector<int> TopologicalOrder(const std::vector<std::vector<int>>& uses,
                                  const std::function<void(const std::vector<int>&)>& on_cycle);

}  // namespace mjforge::spec
