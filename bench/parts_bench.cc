// Benchmarks of the cost against the number of parts and parameters: generation and, separately,
// loading in MuJoCo.

#include <mujoco/mujoco.h>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "mjforge/assemble/assemble.h"
#include "recipes.h"

namespace mjforge::bench {
namespace {

void BM_Parts(benchmark::State& state) {
  LoadedRecipe row = Row(static_cast<int>(state.range(0)));
  assemble::Assembler assembler;
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

// A row of touching parts: draws a list, sums it, and calls a function for each part.
void BM_List(benchmark::State& state) {
  LoadedRecipe row = FromText(fmt::format(
      "mjforge: 1\nname: row\nfunctions: {{half(w): w / 2 - gap}}\n"
      "params: {{gap: 0.01 .. 0.02, widths: {{each: 0.1 .. 0.2, count: {}}}}}\n"
      "parts: [{{name: 'p${{i}}', for: {{i: len(widths)}}, type: box,\n"
      "  size: ['half(widths[i])', 1, 1], pos: ['sum(widths, i) + widths[i] / 2', 0, 0]}}]\n",
      state.range(0)));
  assemble::Assembler assembler;
  mjcf::MjcfDocument document;
  std::uint64_t index = 0;
  for (auto _ : state) MakeText(row.recipe, assembler, index++, document);
}
BENCHMARK(BM_List)->Arg(1'000)->Arg(10'000)->Unit(benchmark::kMillisecond);

// Reads a spec with this number of parameters.
void BM_Parameters(benchmark::State& state) {
  std::string yaml = "mjforge: 1\nname: crate\nparams:\n  p0: 0.1 .. 0.2\n";
  for (std::int64_t i = 1; i < state.range(0); ++i)
    yaml += fmt::format("  p{}: p{} + 1\n", i, i - 1);
  yaml += "parts: [{name: a, type: sphere, size: p0}]\n";
  for (auto _ : state) benchmark::DoNotOptimize(FromText(yaml));
}
BENCHMARK(BM_Parameters)->Arg(1'000)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mjforge::bench
