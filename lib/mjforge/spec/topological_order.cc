#include "mjforge/spec/topological_order.h"

#include <cstddef>
#include <utility>

namespace mjforge::spec {
namespace {

enum class VisitState { kNew, kOpen, kDone };

std::size_t Index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

std::vector<int> TopologicalOrder(const std::vector<std::vector<int>>& uses,
                                  const std::function<void(const std::vector<int>&)>& on_cycle) {
  std::vector<VisitState> states(uses.size(), VisitState::kNew);
  std::vector<int> order;
  // Depth first, with a stack of our own: chains may be long.
  std::vector<std::pair<int, std::size_t>> stack;
  const auto open = [&](int node) {
    states[Index(node)] = VisitState::kOpen;
    stack.emplace_back(node, 0);
  };
  for (int start = 0; start < static_cast<int>(uses.size()); ++start) {
    if (states[Index(start)] == VisitState::kNew) open(start);
    while (!stack.empty()) {
      auto& [node, next] = stack.back();
      if (next == uses[Index(node)].size()) {
        states[Index(node)] = VisitState::kDone;
        order.push_back(node);
        stack.pop_back();
        continue;
      }
      const int used = uses[Index(node)][next++];
      if (states[Index(used)] == VisitState::kNew) {
        open(used);
      } else if (states[Index(used)] == VisitState::kOpen) {
        std::vector<int> path;
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
