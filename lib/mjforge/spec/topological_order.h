// Topological order of a dependency graph.

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace mjforge::spec {

/// Edges of a dependency graph: for each node, the nodes that it depends on.
using Dependencies = std::vector<std::vector<std::size_t>>;

/// Returns all nodes, each after the nodes that it depends on, except where a cycle makes this
/// impossible. Calls `on_cycle` for each edge that closes a cycle, with the path of the cycle,
/// whose first and last nodes are the same.
std::vector<std::size_t> TopologicalOrder(
    const Dependencies& dependencies,
    const std::function<void(const std::vector<std::size_t>&)>& on_cycle);

}  // namespace mjforge::spec
