// Random streams of a spec's parameters, as dimensions of a sampling method.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mjforge/sample/streams.h"
#include "mjforge/spec/spec.h"

namespace mjforge::sample {

/// A random stream from which a value of a parameter, or a part of the value, is drawn. A sampling
/// method uses each uniform number of the stream as a dimension.
struct ParameterStream {
  StreamId stream = 0;
  int numbers = 1;           // count of uniform numbers drawn; each is a dimension
  std::uint64_t levels = 0;  // number of values of a discrete draw; 0 if continuous or unknown
  bool is_order = false;     // true for the sort key of an item of a shuffled list
  /// For two levels of unequal probability: the first level has the interval (0, split), the second
  /// level (split, 1). If nullopt, all levels have equal probability.
  std::optional<double> split;
};

/// Returns the root stream of a spec that is not nested in another spec. The stream depends on the
/// spec's name, so that two specs with the same seed draw different numbers.
inline StreamId RootStream(const spec::ObjectSpec& spec) { return Child(kRootStream, spec.name); }

/// Returns the root stream of an imported file. The stream depends only on the file's name, so that
/// all specs that import the file draw the same values.
inline StreamId SharedStream(const spec::ObjectSpec& shared) {
  return Child(Child(kRootStream, "import"), shared.name);
}

/// Returns the streams of all parameters, from which Evaluator draws: first those of imported
/// files, then those of the spec itself in file order. A draw comes before the draws in its
/// arguments, limits and options. Leaves out draws that need no uniform number: cycles, columns of
/// a record except its key, and choices with `exact: true`, whose options are distributed over the
/// batch.
std::vector<ParameterStream> ParameterStreams(const spec::ObjectSpec& spec);

}  // namespace mjforge::sample
