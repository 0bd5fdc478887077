// Sampling methods: random, Sobol, Latin hypercube and grid sampling, exact choices.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mjforge/sample/streams.h"
#include "mjforge/spec/spec.h"

namespace mjforge::sample {

class Grid;
class Sobol;

enum class Method {
  kRandom,  // independent uniform numbers
  kSobol,   // a scrambled Sobol sequence for the parameters' draws
  kLatin,   // for every draw, one item of a block in each of N equal cells of (0, 1)
  kGrid,    // all combinations of levels of the parameters' draws
};
/// Returns "random", "sobol", "latin", "grid", in the order of the enumeration.
std::span<const std::string_view> MethodNames();
std::optional<Method> FindMethod(std::string_view name);
std::string_view MethodName(Method method);

/// The largest size of a batch. A uniform number has this many different values.
inline constexpr std::uint64_t kMaxBatch = std::uint64_t{1} << 52;

/// Uniform numbers for items in blocks of N, the size of a batch: item p of block b has index
/// b * N + p. A number depends only on the key, the stream and N. Sobol, latin and grid apply to
/// attempt 0 only; redraws are random, so that rejecting one item does not change any other. Sobol
/// and grid apply only to the parameters of the spec itself; parameters of specs that it uses, and
/// draws outside `params:`, are random.
class Sampler {
 public:
  /// `batch` is N, at most kMaxBatch, or 0 if unknown; then draws of methods that need N are
  /// random. `seed` is the seed of all keys. The spec need not outlive the sampler.
  Sampler(const spec::ObjectSpec& spec, Method method, std::uint64_t seed, std::uint64_t batch);

  /// Returns four numbers in (0, 1), distributed by the method.
  std::array<double, 4> Uniforms(const DrawKey& key, StreamId stream) const {
    return is_random_ || key.attempt != 0 ? sample::Uniforms(key, stream) : Spread(key, stream);
  }

  /// Returns the option of a choice with `exact: true`. In each block, the counts of the options
  /// are N times their share of the weights (rounded by largest remainders), in pseudorandom order.
  /// All attempts get the same option. Requires batch() > 0 and weights >= 0 with a positive sum.
  std::size_t ExactOption(std::span<const double> weights, const DrawKey& key,
                          StreamId stream) const;

  Method method() const { return method_; }
  std::uint64_t batch() const { return batch_; }
  /// Returns true if items depend on the batch's size, so that regenerating an item needs it: with
  /// latin and grid, and if the spec or a spec that it uses has an exact choice.
  static bool NeedsBatch(const spec::ObjectSpec& spec, Method method);
  bool NeedsBatch() const { return needs_batch_; }

  /// Returns "4 x 5 x 5 = 100 points" for method grid, else an empty text.
  std::string GridText() const;
  /// Returns the number of points for method grid, at most 2^64 - 1, else 0. A smaller batch has
  /// only the first points; in a larger batch the points repeat.
  std::uint64_t GridPoints() const;

 private:
  std::array<double, 4> Spread(const DrawKey& key, StreamId stream) const;

  Method method_;
  std::uint64_t batch_;
  bool is_random_;
  bool needs_batch_;
  std::shared_ptr<const Sobol> sobol_;
  std::shared_ptr<const Grid> grid_;
};

}  // namespace mjforge::sample
