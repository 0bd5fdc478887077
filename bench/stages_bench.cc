// Benchmarks of the stages of one hammer: sample, assemble, write.

#include <benchmark/benchmark.h>

#include "mjforge/assemble/assemble.h"
#include "recipes.h"

namespace mjforge::bench {
namespace {

void BM_Sample(benchmark::State& state) {
  const forge::Recipe& recipe = Hammer().recipe;
  std::uint64_t index = 0;
  for (auto _ : state) {
    diag::Findings findings;
    auto values = sample::Sample(*recipe.spec, {.seed = 7, .index = index++}, sample::kRootStream,
                                 {}, findings);
    benchmark::DoNotOptimize(values);
  }
}
BENCHMARK(BM_Sample)->Unit(benchmark::kMicrosecond);

// Samples the hammer with a sampler of this method: random, sobol, latin, grid.
void BM_SampleSpread(benchmark::State& state) {
  const forge::Recipe& recipe = Hammer().recipe;
  const auto method = static_cast<sample::Method>(state.range(0));
  const sample::Sampler sampler(*recipe.spec, method, 7, 1'000'000);
  std::uint64_t index = 0;
  for (auto _ : state) {
    diag::Findings findings;
    auto values = sample::Sample(*recipe.spec, {.seed = 7, .index = index++}, sample::kRootStream,
                                 {}, findings, &sampler);
    benchmark::DoNotOptimize(values);
  }
  state.SetLabel(std::string(sample::MethodName(method)));
}
BENCHMARK(BM_SampleSpread)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);

void BM_SampleAssemble(benchmark::State& state) {
  const forge::Recipe& recipe = Hammer().recipe;
  assemble::Assembler assembler;
  std::uint64_t index = 0;
  for (auto _ : state) {
    diag::Findings findings;
    auto values = sample::Sample(*recipe.spec, {.seed = 7, .index = index++}, sample::kRootStream,
                                 {}, findings);
    auto object = assembler.Assemble(*values, {}, findings);
    benchmark::DoNotOptimize(object);
  }
}
BENCHMARK(BM_SampleAssemble)->Unit(benchmark::kMicrosecond);

void BM_SampleAssembleWrite(benchmark::State& state) {
  const forge::Recipe& recipe = Hammer().recipe;
  assemble::Assembler assembler;
  mjcf::MjcfDocument document;
  std::uint64_t index = 0;
  std::uint64_t bytes = 0;
  for (auto _ : state) {
    MakeText(recipe, assembler, index++, document);
    bytes += document.text.size();
  }
  state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(index);
}
BENCHMARK(BM_SampleAssembleWrite)->Unit(benchmark::kMicrosecond);

void BM_GenerateRecord(benchmark::State& state) {
  LoadedRecipe& hammer = Hammer();
  forge::Options options;
  options.seed = 7;
  options.validation = forge::Validation::kNone;
  forge::Generator generator(hammer.recipe, hammer.sources, options);
  forge::Variant variant;
  std::string manifest;
  std::uint64_t index = 0;
  for (auto _ : state) {
    generator.Make(index++, variant);
    manifest.clear();
    manifest::AppendRecord(manifest, variant.record);
    benchmark::DoNotOptimize(manifest.data());
  }
}
BENCHMARK(BM_GenerateRecord)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mjforge::bench
