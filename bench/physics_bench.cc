// Benchmarks of physics: a drop until rest against a bare loop of mj_step with equally many steps.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "mjforge/engine/engine.h"
#include "mjforge/physics/drop.h"
#include "mjforge/physics/simulation.h"
#include "recipes.h"

namespace mjforge::bench {
namespace {

/// Returns a hammer 2 mm above a floor, the start of a drop.
engine::Model HammerOnFloor() {
  LoadedRecipe& hammer = Hammer();
  forge::Options options;
  options.seed = 7;
  options.target = mjcf::Target::kScene;
  forge::Variant variant;
  forge::Generator(hammer.recipe, hammer.sources, options).Make(0, variant);
  engine::Loaded loaded = engine::Engine().LoadText(variant.document.text);
  if (!loaded.model) std::abort();
  return std::move(loaded.model);
}

void BM_Settle(benchmark::State& state) {
  engine::Model model = HammerOnFloor();
  physics::Workspace workspace;
  std::int64_t steps = 0;
  for (auto _ : state) {
    physics::Result result;
    physics::SimulateDrop(*model, workspace.For(*model), {}, {}, result);
    steps += std::llround(result.time / model->opt.timestep);
  }
  state.SetItemsProcessed(steps);
}
BENCHMARK(BM_Settle)->Unit(benchmark::kMicrosecond);

void BM_BareSteps(benchmark::State& state) {
  engine::Model model = HammerOnFloor();
  physics::Workspace workspace;
  physics::Result result;
  physics::SimulateDrop(*model, workspace.For(*model), {}, {}, result);
  const std::int64_t steps = std::llround(result.time / model->opt.timestep);
  mjData& d = workspace.For(*model);
  for (auto _ : state) {
    mj_resetData(model.get(), &d);
    d.qpos[2] += 0.002;
    for (std::int64_t i = 0; i < steps; ++i) mj_step(model.get(), &d);
  }
  state.SetItemsProcessed(state.iterations() * steps);
}
BENCHMARK(BM_BareSteps)->Unit(benchmark::kMicrosecond);

/// All checks of an articulated object: loading with a floor, drop, joints, proportions.
void BM_Examine(benchmark::State& state) {
  LoadedRecipe scissors = Named("scissors", {});
  forge::Variant variant;
  forge::Generator(scissors.recipe, scissors.sources, {}).Make(0, variant);
  physics::Laboratory laboratory;
  diag::Findings findings;
  for (auto _ : state) {
    if (!laboratory.Examine(variant.document, *variant.object, findings)) std::abort();
    findings.clear();
  }
}
BENCHMARK(BM_Examine)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mjforge::bench
