// What moulds are worth, and that they change nothing: every bundled spec with and without them.
//
//   mjforge_moulds COUNT
//
// Makes the variants 0 to COUNT - 1 of each spec both ways, compares the bytes of text and record,
// and prints the microseconds that each takes and how many came from a mould. Ends with 1 if any
// byte differs.

#include <chrono>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "recipes.h"

namespace mjforge::bench {
namespace {

/// One way of making variants, and the time it took so far.
class Maker {
 public:
  Maker(LoadedRecipe& loaded, bool moulds)
      : generator_(loaded.recipe, loaded.sources, Of(moulds)) {}

  void Make(std::uint64_t index) {
    const auto start = std::chrono::steady_clock::now();
    generator_.Make(index, variant_);
    record_.clear();
    manifest::AppendRecord(record_, variant_.record);
    time_ += std::chrono::steady_clock::now() - start;
    from_moulds_ += variant_.mould > 0;
  }

  bool IsSame(const Maker& other) const {
    const bool same_text = variant_.document.text == other.variant_.document.text;
    return record_ == other.record_ && (!variant_.ok() || same_text);
  }
  double time() const { return time_.count(); }  // us
  std::uint64_t from_moulds() const { return from_moulds_; }

 private:
  static forge::Options Of(bool moulds) {
    forge::Options options;
    options.seed = 7;
    options.validation = forge::Validation::kNone;
    options.moulds = moulds;
    return options;
  }

  forge::Generator generator_;
  forge::Variant variant_;
  std::string record_;
  std::chrono::duration<double, std::micro> time_{};
  std::uint64_t from_moulds_ = 0;
};

bool Compare(const std::string& spec, std::uint64_t count) {
  LoadedRecipe loaded = Named(spec, {});
  Maker with(loaded, true);
  Maker without(loaded, false);
  std::uint64_t different = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    with.Make(i);
    without.Make(i);
    different += !with.IsSame(without);
  }
  const auto n = static_cast<double>(count);
  fmt::print("{:<32}{:>8.0f} %{:>12.1f}{:>12.1f}{:>10.2f}{:>12}\n", spec,
             100 * static_cast<double>(with.from_moulds()) / n, with.time() / n, without.time() / n,
             without.time() / with.time(), different);
  return different == 0;
}

}  // namespace
}  // namespace mjforge::bench

int main(int argc, char** argv) {
  const std::uint64_t count = argc == 2 ? std::strtoull(argv[1], nullptr, 10) : 0;
  if (count == 0) {
    fmt::print(stderr, "usage: mjforge_moulds COUNT\n");
    return 2;
  }
  fmt::print("{:<32}{:>10}{:>12}{:>12}{:>10}{:>12}\n", "moulds, us for each variant", "from them",
             "with", "without", "ratio", "different");
  bool same = true;
  for (const std::string& spec : mjforge::spec::ListSpecs(*mjforge::forge::CatalogueFolder())) {
    if (spec != "materials") same &= mjforge::bench::Compare(spec, count);
  }
  return same ? 0 : 1;
}
