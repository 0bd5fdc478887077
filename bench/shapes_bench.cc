// Benchmarks of shapes: making them, and loading them in MuJoCo.

#include <cstdlib>

#include <benchmark/benchmark.h>

#include "bare_load.h"

namespace mjforge::bench {
namespace {

// Text and record of variants.
void Make(benchmark::State& state, const std::string& part) {
  LoadedRecipe shape = FromText(
      "mjforge: 1\nname: thing\nparams: {w: 10cm .. 12cm, h: 30cm .. 40cm}\n"
      "parts: [{name: a, density: 1000, " +
      part + "}]\n");
  forge::Options options;
  options.seed = 7;
  options.validation = forge::Validation::kNone;
  forge::Generator generator(shape.recipe, shape.sources, options);
  forge::Variant variant;
  std::string manifest;
  std::uint64_t index = 0;
  std::uint64_t bytes = 0;
  for (auto _ : state) {
    generator.Make(index++, variant);
    if (!variant.ok()) std::abort();
    manifest.clear();
    manifest::AppendRecord(manifest, variant.record);
    bytes += variant.document.text.size();
  }
  state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(index);
}

// A smooth profile with 20 points, 48 segments around the axis.
void BM_Lathe(benchmark::State& state) {
  Make(state,
       "type: lathe, facets: 12, profile: [[0, 0], {for: {i: 18}, "
       "at: ['w * (0.8 + 0.2 * sin(i / 3))', h * i / 17]}, [0, h]]");
}
BENCHMARK(BM_Lathe)->Unit(benchmark::kMicrosecond);

// A tube with two bends.
void BM_Tube(benchmark::State& state) {
  Make(state,
       "type: tube, radius: w / 16, bend: 2cm, "
       "path: [[-w / 2, 0, 0], [-w / 2, 0, 4cm], [w / 2, 0, 4cm], [w / 2, 0, 0]]");
}
BENCHMARK(BM_Tube)->Unit(benchmark::kMicrosecond);

void Load(benchmark::State& state, const std::string& spec) {
  constexpr int kTexts = 64;
  const std::vector<std::string> texts = Texts(Named(spec, {}).recipe, kTightSize, kTexts);
  BareLoader loader;
  std::size_t i = 0;
  for (auto _ : state) loader.Load(texts[i++ % texts.size()]);
}

void BM_LoadMug(benchmark::State& state) { Load(state, "containers/mug"); }
BENCHMARK(BM_LoadMug)->Unit(benchmark::kMicrosecond);

// A mug made of boxes instead of a lathe.
void BM_LoadMugOfBoxes(benchmark::State& state) {
  Load(state, MJFORGE_BENCH_DIR "/mug_of_boxes.yaml");
}
BENCHMARK(BM_LoadMugOfBoxes)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mjforge::bench
