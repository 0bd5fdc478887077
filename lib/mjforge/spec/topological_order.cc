// Topological order by depth-first search, which also finds cycles.

#include "mjforge/spec/topological_order.h"

#include <utility>

namespace mjforge::spec {
namespace {

enum class VisitState { kNew, kOpen, kDone };

}  // namespace

std::vector<std::size_t> TopologicalOrder(
    const Dependencies& dependencies,
    const std::function<void(const std::vector<std::size_t>&)>& on_cycle) {
  std::vector<VisitState> states(dependencies.size(), VisitState::kNew);
  std::vector<std::size_t> order;
  // An explicit stack, because long chains would overflow the call stack. An item is an open node,
  // and the number of dependencies of the node that were visited.
  std::vector<std::pair<std::size_t, std::size_t>> stack;
  const auto open = [&](std::size_t node) {
    states[node] = VisitState::kOpen;
    stack.emplace_back(node, 0);
  };
  for (std::size_t start = 0; start < dependencies.size(); ++start) {
    if (states[start] == VisitState::kNew) open(start);
    while (!stack.empty()) {
      auto& [node, next] = stack.back();
      if (next == dependencies[node].size()) {
        states[node] = VisitState::kDone;
        order.push_back(node);
        stack.pop_back();
        continue;
      }
      const std::size_t used = dependencies[node][next++];
      if (states[used] == VisitState::kNew) {
        open(used);
      } else if (states[used] == VisitState::kOpen) {
        std::vector<std::size_t> path;
        for (const auto& [at, unused] : stack) {
          if (!path.empty() || at == used) path.push_back(at);
        }
        path.push_back(used);
        on_cycle(path);
      }
    }
  }
  return order;
}

}  // namespace mjforge::spec
