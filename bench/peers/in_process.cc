// mjforge as a library, timed from inside: variants with their manifest records.
//
//   mjforge_in_process none|load|bare COUNT SPEC [NAME=VALUE...]
//
// none: without MuJoCo's verdict; load: with it; bare: only mj_loadXML, over and
// over the tight texts of the first variants. Prints microseconds of CPU and of
// wall time for each.

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "bare_load.h"
#include "recipes.h"

namespace {

using mjforge::bench::LoadedRecipe;

constexpr int kTexts = 64;
constexpr std::uint64_t kWarmUp = 20;

double CpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <typename Action>
void Time(std::uint64_t count, Action action) {
  for (std::uint64_t i = 0; i < kWarmUp; ++i) action(i);
  const auto start = std::chrono::steady_clock::now();
  const double cpu = CpuSeconds();
  for (std::uint64_t i = 0; i < count; ++i) action(i);
  const double cpu_us = (CpuSeconds() - cpu) * 1e6;
  const std::chrono::duration<double, std::micro> wall = std::chrono::steady_clock::now() - start;
  const auto n = static_cast<double>(count);
  fmt::print("{:.3f} {:.3f}\n", cpu_us / n, wall.count() / n);
}

void TimeBare(const LoadedRecipe& loaded, std::uint64_t count) {
  const auto texts = mjforge::bench::Texts(loaded.recipe, mjforge::bench::kTightSize, kTexts);
  mjforge::bench::BareLoader loader;
  Time(count, [&](std::uint64_t i) { loader.Load(texts[i % texts.size()]); });
}

void TimeGenerator(LoadedRecipe& loaded, std::uint64_t count, bool validated) {
  mjforge::forge::Options options;
  options.seed = 7;
  if (!validated) options.validation = mjforge::forge::Validation::kNone;
  mjforge::forge::Generator generator(loaded.recipe, loaded.sources, options);
  mjforge::forge::Variant variant;
  std::string manifest;
  Time(count, [&](std::uint64_t i) {
    generator.Make(i, variant);
    if (!variant.ok()) std::abort();
    manifest.clear();
    mjforge::manifest::AppendRecord(manifest, variant.record);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (argc < 4 || (what != "none" && what != "load" && what != "bare")) {
    fmt::print(stderr, "usage: mjforge_in_process none|load|bare COUNT SPEC [NAME=VALUE...]\n");
    return 2;
  }
  const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
  std::vector<mjforge::spec::Setting> settings;
  for (int i = 4; i < argc; ++i) {
    const std::string_view setting = argv[i];
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos) {
      fmt::print(stderr, "mjforge_in_process: {} is not NAME=VALUE\n", setting);
      return 2;
    }
    settings.push_back({.name = std::string(setting.substr(0, equals)),
                        .text = std::string(setting.substr(equals + 1))});
  }
  LoadedRecipe loaded = mjforge::bench::Named(argv[3], settings);
  if (what == "bare") {
    TimeBare(loaded, count);
  } else {
    TimeGenerator(loaded, count, what == "load");
  }
  return 0;
}
