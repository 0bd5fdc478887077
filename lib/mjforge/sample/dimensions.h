// Streams that the parameters of a spec draw from, as dimensions of a sampling method.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mjforge/sample/streams.h"
#include "mjforge/spec/spec.h"

namespace mjforge::sample {

/// The draws of a spec's parameters from one stream.
struct DrawnStream {
  StreamId stream = 0;
  int numbers = 1;           // uniforms drawn; each is a dimension
  std::uint64_t levels = 0;  // number of values of a discrete draw; 0: continuous or unknown
  bool is_order = false;     // sort key of a list's item
  /// Share of (0, 1) of the first of two levels; nullopt: all levels have equal shares.
  std::optional<double> split;
};

/// Returns the root of the paths of an outermost spec. The root depends on the spec's name, so that
/// two families with the same seed draw different numbers.
inline StreamId RootStream(const spec::ObjectSpec& spec) { return Child(kRootStream, spec.name); }

/// Returns the root of the paths of an imported file. The root depends on the file's name only, so
/// that all specs that import the file draw the same values.
inline StreamId SharedStream(const spec::ObjectSpec& shared) {
  return Child(Child(kRootStream, "import"), shared.name);
}

/// Returns the streams of the parameters of imported files, then of the spec's own parameters in
/// file order. A draw comes before the draws in its arguments, limits and options. The streams are
/// those that Evaluator uses. A choice with `exact: true` draws no uniform and is left out.
std::vector<DrawnStream> DrawnStreams(const spec::ObjectSpec& spec);

}  // namespace mjforge::sample
