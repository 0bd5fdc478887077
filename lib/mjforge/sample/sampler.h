// Sampler: uniform numbers by random, Sobol, Latin hypercube or grid sampling, and exact choices.

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
  kRandom,  // independent uniform random numbers
  kSobol,   // a scrambled Sobol sequence for the parameters' draws
  kLatin,   // for every draw, one of N items in each of N equal cells of (0, 1)
  kGrid,    // all combinations of levels of the parameters' draws
};
/// Returns the names of the methods in the order of Method: "random", "sobol", "latin", "grid".
std::span<const std::string_view> MethodNames();
std::optional<Method> FindMethod(std::string_view name);
std::string_view MethodName(Method method);

/// The largest size of a batch: a uniform number has this many different values.
inline constexpr std::uint64_t kMaxBatch = std::uint64_t{1} << 52;

/// Uniform numbers for the items of a batch of N items. Items beyond the batch belong to further
/// blocks of N: item p of block b has the index b * N + p. A number depends only on the key, the
/// stream and N. The methods Sobol, latin and grid apply only to attempt 0; redraws are independent
/// random numbers, so that rejecting one item changes no other item. Sobol and grid apply only to
/// the parameters of the spec and of the files that it imports. Parameters of nested specs, and
/// draws outside `params:`, are random.
class Sampler {
 public:
  /// `batch` is N, at most kMaxBatch. If N is unknown (0), the methods that need N draw independent
  /// random numbers. `seed` is the seed of all keys. The spec need not outlive the sampler.
  Sampler(const spec::ObjectSpec& spec, Method method, std::uint64_t seed, std::uint64_t batch);

  /// Returns four uniform numbers in (0, 1), distributed over the batch by the method.
  std::array<double, 4> Uniforms(const DrawKey& key, StreamId stream) const {
    return is_random_ || key.attempt != 0 ? sample::Uniforms(key, stream) : Spread(key, stream);
  }

  /// Returns the option of a choice with `exact: true`. In each block of N items, the count of each
  /// option is N times its share of the weights, rounded by largest remainders; the order is
  /// pseudorandom. All attempts of an item have the same option. Requires batch() > 0, weights >= 0
  /// and a positive sum.
  std::size_t ExactOption(std::span<const double> weights, const DrawKey& key,
                          StreamId stream) const;

  Method method() const { return method_; }
  std::uint64_t batch() const { return batch_; }
  /// Returns true if items depend on the size of the batch, which is then needed to regenerate an
  /// item: for the methods latin and grid, and if the spec or a nested spec has an exact choice.
  static bool NeedsBatch(const spec::ObjectSpec& spec, Method method);
  bool NeedsBatch() const { return needs_batch_; }

  /// Returns "4 x 5 x 5 = 100 points" for the method grid; an empty text for other methods.
  std::string GridText() const;
  /// Returns the number of points of the method grid, at most 2^64 - 1; 0 for other methods. A
  /// smaller batch contains only the first points; a larger batch repeats the points.
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
