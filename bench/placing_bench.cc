// Benchmarks of placing boxes on a region, without the rest of a variant.

#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "mjforge/placing/placing.h"

namespace mjforge::bench {
namespace {

constexpr double kFilled = 0.3;      // share of the region's area that the boxes cover
constexpr double kArea = 1.0 / 200;  // m^2 of the region for each box
constexpr int kMostTries = 200;

// A slab with a region that a number of boxes of different sizes fill to 30 %.
model::Object Boxes(int count) {
  model::Object object;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> ratio(0.7, 1.4);
  const double side = std::sqrt(kArea * count);
  for (int i = 0; i <= count; ++i) {
    model::Body& body = object.bodies.emplace_back();
    model::Part& part = body.parts.emplace_back();
    const double half = std::sqrt(kFilled * kArea) / 2;
    const double stretch = std::sqrt(ratio(random));
    part.shape.type = model::GeomType::kBox;
    part.shape.size = i == 0 ? Eigen::Vector3d(side / 2, side / 2, 0.01)
                             : Eigen::Vector3d(half * stretch, half / stretch, half);
    if (i == 0) part.X_BG.p.z() = -0.01;
  }
  model::Region& region = object.bodies.front().regions.emplace_back();
  region.half_size = {side / 2, side / 2};
  return object;
}

// Places all boxes of an object; returns false if one of them finds no place.
bool PlaceAll(model::Object& object, model::Placer& placer, std::mt19937& random, int& tries) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  placer.Begin(object);
  placer.AddObstacle(0);
  for (int body = 1; body < static_cast<int>(object.bodies.size()); ++body) {
    model::PlaceTry where;
    where.support = 0;
    where.region = &object.bodies.front().regions.front();
    model::PlaceResult result;
    for (int i = 0; i < kMostTries; ++i) {
      where.uv.x() = uniform(random);
      where.uv.y() = uniform(random);
      where.yaw = M_PI * uniform(random);
      result = placer.Try(body, where);
      ++tries;
      if (result.verdict == model::PlaceVerdict::kStands) break;
    }
    if (result.verdict != model::PlaceVerdict::kStands) return false;
    object.bodies[static_cast<std::size_t>(body)].X_PB = result.X_SupportBody;
    placer.AddObstacle(body);
  }
  return true;
}

void BM_PlaceBoxes(benchmark::State& state) {
  model::Object object = Boxes(static_cast<int>(state.range(0)));
  const std::unique_ptr<model::Placer> placer = placing::MakePlacer();
  std::mt19937 random(7);
  int tries = 0;
  for (auto _ : state) {
    // About 1 % of the layouts of ten boxes have no place for the last box.
    while (!PlaceAll(object, *placer, random, tries)) continue;
  }
  state.counters["tries"] =
      static_cast<double>(tries) / static_cast<double>(state.iterations() * state.range(0));
}
BENCHMARK(BM_PlaceBoxes)->Arg(10)->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mjforge::bench
