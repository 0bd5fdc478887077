// Benchmark of every bundled spec: CPU time for the text and the record of one variant, in process.
//
//   mjforge_variants COUNT [SPEC...]
//
// Makes the variants 0 to COUNT - 1 of each bundled spec, or of those named, without loading them
// in MuJoCo, and prints the microseconds and the bytes of MJCF for one. A scene takes as long as
// hundreds of objects: it gets a hundredth of COUNT, at least one.

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <string>

#include <fmt/format.h>

#include "recipes.h"

namespace mjforge::bench {
namespace {

double CpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void Measure(const std::string& spec, std::uint64_t count) {
  if (spec.starts_with("scenes/")) count = std::max(count / 100, std::uint64_t{1});
  LoadedRecipe loaded = Named(spec, {});
  forge::Options options;
  options.seed = 7;
  options.validation = forge::Validation::kNone;
  forge::Generator generator(loaded.recipe, loaded.sources, options);
  forge::Variant variant;
  std::string record;
  std::size_t bytes = 0;
  const double start = CpuSeconds();
  for (std::uint64_t i = 0; i < count; ++i) {
    generator.Make(i, variant);
    record.clear();
    manifest::AppendRecord(record, variant.record);
    bytes += variant.document.text.size();
  }
  const auto n = static_cast<double>(count);
  fmt::print("{:<32}{:>12.1f}{:>12.0f}\n", spec, 1e6 * (CpuSeconds() - start) / n,
             static_cast<double>(bytes) / n);
}

}  // namespace
}  // namespace mjforge::bench

int main(int argc, char** argv) {
  const std::uint64_t count = argc >= 2 ? std::strtoull(argv[1], nullptr, 10) : 0;
  if (count == 0) {
    fmt::print(stderr, "usage: mjforge_variants COUNT [SPEC...]\n");
    return 2;
  }
  fmt::print("{:<32}{:>12}{:>12}\n", "spec", "us", "bytes");
  std::vector<std::string> specs(argv + 2, argv + argc);
  if (specs.empty()) specs = mjforge::spec::ListSpecs(*mjforge::forge::CatalogueFolder());
  std::erase(specs, "materials");
  for (const std::string& spec : specs) mjforge::bench::Measure(spec, count);
  return 0;
}
