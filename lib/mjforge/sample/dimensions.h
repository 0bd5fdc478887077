#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mjforge/sample/streams.h"
#include "mjforge/spec/spec.h"

namespace mjforge::sample {

/// What the parameters of a spec draw from one stream.
struct DrawnStream {
  StreamId stream = 0;
  int numbers = 1;           // uniforms taken: the dimensions it spans
  std::uint64_t levels = 0;  // different values of a discrete draw; 0: any number
  bool is_order = false;     // one of the numbers that put a list in order
  /// With two levels: the first one's share of (0, 1), if it is not one half.
  std::optional<double> split;
};

/// Where the paths of an outermost spec begin: at its name, so that two families with the same seed
/// draw different numbers.
inline StreamId RootStream(const spec::ObjectSpec& spec) { return Child(kRootStream, spec.name); }

/// Of the parameters of an imported file: at the file's name, whichever spec imports it.
inline StreamId SharedStream(const spec::ObjectSpec& shared) {
  return Child(Child(kRootStream, "import"), shared.name);
}

/// Those of imported files first, then parameters in file order; within one, a draw before the
/// draws in its arguments, limits and options. Follows the streams of Evaluator. A choice with
/// `exact: true` takes no uniform and is left out.
std::vector<DrawnStream> DrawnStreams(const spec::ObjectSpec& spec);

}  // namespace mjforge::sample
