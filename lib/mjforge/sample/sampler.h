#pragma once

// How the uniform numbers of a batch are spread: at random, or more evenly.

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
  kRandom,  // every number independently
  kSobol,   // the parameters' draws: a scrambled Sobol sequence
  kLatin,   // every draw: one item in each N-th of (0, 1)
  kGrid,    // the parameters' draws: all combinations of their levels
};
/// "random", "sobol", "latin", "grid", in that order.
std::span<const std::string_view> MethodNames();
std::optional<Method> FindMethod(std::string_view name);
std::string_view MethodName(Method method);

/// The largest size of a batch: a uniform number has this many values.
inline constexpr std::uint64_t kMaxBatch = std::uint64_t{1} << 52;

/// The uniform numbers of a batch of N items that begins at a multiple of N: item p of block b has
/// index b * N + p. What a sampler returns depends only on the key, the stream and N. Sobol, latin
/// and grid apply to attempt 0 only: redraws are random, so rejecting one item does not change any
/// other. Sobol and grid spread only the parameters of the spec itself; parameters of specs that it
/// uses, and draws outside `params:`, are random.
class Sampler {
 public:
  /// `batch` is N, at most kMaxBatch; with 0 it is unknown, and what needs it is random. `seed` is
  /// the seed of all keys. The spec need not outlive the sampler.
  Sampler(const spec::ObjectSpec& spec, Method method, std::uint64_t seed, std::uint64_t batch);

  /// As the function sample::Uniforms, but spread by the method.
  std::array<double, 4> Uniforms(const DrawKey& key, StreamId stream) const {
    return is_random_ || key.attempt != 0 ? sample::Uniforms(key, stream) : Spread(key, stream);
  }

  /// The option of a choice with `exact: true`: over a block, option i is taken as often as its
  /// weight says (rounded by largest remainders), in pseudorandom order. The same for all attempts.
  /// Needs a batch; weights are >= 0 with a positive sum.
  std::size_t ExactOption(std::span<const double> weights, const DrawKey& key,
                          StreamId stream) const;

  Method method() const { return method_; }
  std::uint64_t batch() const { return batch_; }
  /// Whether items depend on the batch's size, so that it is needed to regenerate one: with latin
  /// and grid, and if the spec or one that it uses has an exact choice.
  static bool NeedsBatch(const spec::ObjectSpec& spec, Method method);
  bool NeedsBatch() const { return needs_batch_; }

  /// For method grid: "4 x 5 x 5 = 100 points". Empty for the others.
  std::string GridText() const;
  /// For method grid: the number of points, at most 2^64 - 1; 0 for the others. A smaller batch has
  /// only the first points; in a larger one they repeat.
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
