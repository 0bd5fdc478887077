// Benchmarks of the cost against the number of bodies: a chain, and copies of an attached file.

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include <benchmark/benchmark.h>

#include "mjforge/assemble/assemble.h"
#include "mjforge/attach/attach.h"
#include "recipes.h"

namespace mjforge::bench {
namespace {

void BM_Chain(benchmark::State& state) {
  const LoadedRecipe chain = FromText(fmt::format(
      "mjforge: 1\n"
      "name: chain\n"
      "params: {{n: {}, length: 2cm .. 3cm}}\n"
      "bodies:\n"
      "  - {{name: link_0, parts: [{{name: rod_0, type: sphere, size: 5mm}}]}}\n"
      "  - name: link_${{i + 1}}\n"
      "    for: {{i: n - 1}}\n"
      "    parent: link_${{i}}\n"
      "    pos: [0, 0, length]\n"
      "    joints: [{{name: 'hinge_${{i + 1}}', axis: [0, 1, 0], damping: 0.01 .. 0.02}}]\n"
      "    parts: [{{name: 'rod_${{i + 1}}', type: capsule, size: [5mm, 0.4 * length]}}]\n",
      state.range(0)));
  assemble::Assembler assembler;
  mjcf::MjcfDocument document;
  std::uint64_t index = 0;
  for (auto _ : state) MakeText(chain.recipe, assembler, index++, document);
}
BENCHMARK(BM_Chain)->Arg(100)->Arg(1'000)->Unit(benchmark::kMillisecond);

void Attach(benchmark::State& state, const char* file) {
  LoadedRecipe copies = FromText(
      fmt::format("mjforge: 1\n"
                  "name: row\n"
                  "joints: none\n"
                  "params: {{n: {}, step: 10cm .. 20cm}}\n"
                  "bodies:\n"
                  "  - {{name: 'it_${{i}}', for: {{i: n}}, mjcf: {}, pos: [i * step, 0, 0]}}\n",
                  state.range(0), std::string(MJFORGE_BENCH_DIR) + file));
  attach::MjcfReader reader(copies.sources);
  assemble::Assembler assembler(&reader);
  mjcf::MjcfDocument document;
  std::uint64_t index = 0;
  for (auto _ : state) MakeText(copies.recipe, assembler, index++, document);
}

// A file with one body and two geoms.
void BM_AttachedKnobs(benchmark::State& state) { Attach(state, "/knob.xml"); }
BENCHMARK(BM_AttachedKnobs)->Arg(100)->Arg(1'000)->Unit(benchmark::kMillisecond);

// A file with five bodies, classes, actuators, an equality and sensors; 1,000 copies exceed the
// processor's caches.
void BM_AttachedArms(benchmark::State& state) { Attach(state, "/arm.xml"); }
BENCHMARK(BM_AttachedArms)->Arg(100)->Arg(1'000)->Unit(benchmark::kMillisecond);

void BM_ReadAttached(benchmark::State& state) {
  for (auto _ : state) {
    diag::Sources sources;
    diag::Findings findings;
    attach::MjcfReader reader(sources);
    if (reader.Attach(std::string(MJFORGE_BENCH_DIR) + "/arm.xml", "", {}, findings) == nullptr) {
      std::abort();
    }
  }
}
BENCHMARK(BM_ReadAttached)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mjforge::bench
