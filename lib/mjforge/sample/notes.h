#pragma once

// Private to the room.

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {

/// What it takes to note on a tape.
struct Evaluator::Notes {
  tape::Tape& tape;
  bool is_sampled_first;             // before the tape runs
  std::vector<double>* inputs = {};  // by slot, of the expression at hand; on the tape
  /// By slot, on the tape; null: the same in all variants. Empty: each variable is its own place.
  std::vector<const double*> places = {};
  /// The expressions of parameters alone, by their results on the tape.
  std::map<const double*, const expr::Expression*> early = {};
  /// Numbers that are tested already; true: only whether they are zero.
  std::set<std::pair<const double*, bool>> decided = {};
  /// The result of each expression that was noted, by it and its inputs.
  std::map<std::pair<const void*, std::vector<Input>>, const double*> results = {};
};

/// How a parameter is drawn in each variant.
struct Evaluator::Steps {
  tape::Tape tape;
  std::vector<const double*> results;  // by component
};

}  // namespace mjforge::sample
