// Random streams of a spec's parameters, as dimensions of a sampling method.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mjforge/sample/streams.h"
#include "mjforge/spec/spec.h"

namespace mjforge::sample {

/// A random stream from which a parameter's value is drawn, with its dimensions in a sampling
/// method.
struct ParameterStream {
  StreamId stream = 0;
  int numbers = 1;           // count of uniform numbers drawn; each is a dimension
  std::uint64_t levels = 0;  // number of values of a discrete draw; 0 if continuous or unknown
  bool is_order = false;     // true for the sort key of an item of a shuffled list
  /// For two levels of unequal probability: the part of (0, 1) that belongs to the first level. If
  /// nullopt, all levels have equal probability.
  std::optional<double> split;
};

/// Returns the root stream of an outermost spec. The stream depends on the spec's name, so that two
/// specs with the same seed draw different numbers.
inline StreamId RootStream(const spec::ObjectSpec& spec) { return Child(kRootStream, spec.name); }

/// Returns the root stream of an imported file. The stream depends only on the file's name, so that
/// all specs that import the file draw the same values.
inline StreamId SharedStream(const spec::ObjectSpec& shared) {
  return Child(Child(kRootStream, "import"), shared.name);
}

/// Returns the streams of all parameters: first of imported files, then of the spec itself in file
/// order. A draw comes before the draws in its arguments, limits and options. The streams are those
/// that Evaluator uses. A choice with `exact: true` is left out, because it draws no uniform
/// number.
std::vector<ParameterStream> ParameterStreams(const spec::ObjectSpec& spec);

}  // namespace mjforge::sample
