// Benchmarks of validation: validated generation against a bare loop of mj_loadXML over the same
// texts, with and without a tight <size>.

#include <cstdlib>

#include <benchmark/benchmark.h>

#include "bare_load.h"

namespace mjforge::bench {
namespace {

constexpr int kTexts = 64;

void Load(benchmark::State& state, std::string_view size) {
  const std::vector<std::string> texts = Texts(Hammer().recipe, size, kTexts);
  BareLoader loader;
  std::size_t i = 0;
  for (auto _ : state) loader.Load(texts[i++ % texts.size()]);
}

void BM_LoadTight(benchmark::State& state) { Load(state, kTightSize); }
BENCHMARK(BM_LoadTight)->Unit(benchmark::kMicrosecond);

void BM_LoadDefault(benchmark::State& state) { Load(state, ""); }
BENCHMARK(BM_LoadDefault)->Unit(benchmark::kMicrosecond);

void BM_GenerateValidated(benchmark::State& state) {
  LoadedRecipe& hammer = Hammer();
  forge::Generator generator(hammer.recipe, hammer.sources,
                             {.seed = 7, .target = {}, .name = {}, .folder = {}});
  forge::Variant variant;
  std::uint64_t index = 0;
  for (auto _ : state) {
    generator.Make(index++ % kTexts, variant);
    if (!variant.ok()) std::abort();
  }
}
BENCHMARK(BM_GenerateValidated)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mjforge::bench
