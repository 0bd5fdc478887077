// What MuJoCo's verdict costs: our validated generation against a bare loop of
// mj_loadXML over the same texts, with and without a tight <size>.

#include <mujoco/mujoco.h>

#include <cstdlib>
#include <cstring>
#include <memory>

#include <benchmark/benchmark.h>

#include "recipes.h"

namespace mjforge::bench {
namespace {

constexpr std::uint64_t kTexts = 64;

// The same texts that validation loads, `size` put in where it puts its own.
std::vector<std::string> Texts(std::string_view size) {
  const forge::Recipe& recipe = Hammer().recipe;
  model::Assembler assembler;
  mjcf::MjcfDocument document;
  std::vector<std::string> texts;
  for (std::uint64_t index = 0; index < kTexts; ++index) {
    MakeText(recipe, assembler, index, document);
    texts.push_back(document.text);
    texts.back().insert(document.size_position, size);
  }
  return texts;
}

void Load(benchmark::State& state, std::string_view size) {
  const std::vector<std::string> texts = Texts(size);
  const std::unique_ptr<mjVFS> vfs(new mjVFS);
  mj_defaultVFS(vfs.get());
  std::size_t i = 0;
  for (auto _ : state) {
    const std::string& text = texts[i++ % texts.size()];
    mj_makeEmptyFileVFS(vfs.get(), "model.xml", static_cast<int>(text.size()));
    std::memcpy(vfs->filedata[vfs->nfile - 1], text.data(), text.size());
    char error[1000] = "";
    mjModel* model = mj_loadXML("model.xml", vfs.get(), error, sizeof(error));
    if (model == nullptr) std::abort();
    mj_deleteModel(model);
    mj_deleteFileVFS(vfs.get(), "model.xml");
  }
}

void BM_LoadTight(benchmark::State& state) {
  Load(state, "  <size njmax=\"1\" nconmax=\"1\" nstack=\"4096\"/>\n");
}
BENCHMARK(BM_LoadTight)->Unit(benchmark::kMicrosecond);

void BM_LoadDefault(benchmark::State& state) { Load(state, ""); }
BENCHMARK(BM_LoadDefault)->Unit(benchmark::kMicrosecond);

void BM_GenerateValidated(benchmark::State& state) {
  LoadedRecipe& hammer = Hammer();
  validate::Loader loader;
  forge::Generator generator(hammer.recipe, hammer.sources, {.seed = 7, .target = {}, .name = {}},
                             &loader);
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
