// Cost against the number of parts: sampled, assembled and written by us, and,
// apart, loaded by MuJoCo.

#include <mujoco/mujoco.h>

#include <benchmark/benchmark.h>

#include "recipes.h"

namespace mjforge::bench {
namespace {

void BM_Parts(benchmark::State& state) {
  LoadedRecipe row = Row(static_cast<int>(state.range(0)));
  model::Assembler assembler;
  mjcf::MjcfDocument document;
  std::uint64_t index = 0;
  for (auto _ : state) MakeText(row.recipe, assembler, index++, document);
}
BENCHMARK(BM_Parts)->Arg(1'000)->Arg(10'000)->Unit(benchmark::kMillisecond);

void BM_PartsValidated(benchmark::State& state) {
  LoadedRecipe row = Row(static_cast<int>(state.range(0)));
  forge::Generator generator(row.recipe, row.sources,
                             {.seed = 7, .target = {}, .name = {}, .folder = {}});
  forge::Variant variant;
  std::uint64_t index = 0;
  for (auto _ : state) generator.Make(index++, variant);
}
BENCHMARK(BM_PartsValidated)->Arg(1'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mjforge::bench
