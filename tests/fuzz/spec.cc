// Specs: loading them, and making their first variants.

#include "fuzz/input.h"
#include "fuzz/variants.h"

namespace mjforge::fuzz {
namespace {

constexpr std::string_view kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// Files that a spec may name. There is no MJCF among them: that is MuJoCo's.
void PutFiles() {
  static bool are_there = false;
  if (are_there) return;
  Put("cube.obj", kCube);
  Put("wood.png", "\x89PNG\r\n\x1a\n");
  Put("ball.yaml",
      "mjforge: 1\nname: ball\nparams: {r: 1cm .. 2cm}\n"
      "parts: [{name: b, type: sphere, size: r}]\n");
  are_there = true;
}

// Lines of "#set NAME=TEXT" before a spec set its parameters; YAML has comments there.
std::vector<spec::Setting> Settings(std::string_view text) {
  constexpr std::string_view kSet = "#set ";
  std::vector<spec::Setting> settings;
  Input lines(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  for (std::string_view line = lines.Line(); line.starts_with(kSet); line = lines.Line()) {
    line.remove_prefix(kSet.size());
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) break;
    settings.push_back({std::string(line.substr(0, equals)), std::string(line.substr(equals + 1))});
  }
  return settings;
}

}  // namespace

void Run(Input input) {
  PutFiles();
  forge::Options options;
  options.target = static_cast<mjcf::Target>(input.Below(mjcf::Targets().size()));
  options.sampler = static_cast<sample::Method>(input.Below(sample::MethodNames().size()));
  options.batch = input.Byte();
  options.seed = input.Byte();
  if (input.Bit()) options.on_invalid = forge::OnInvalid::kResample;

  spec::LoadOptions load;
  load.search_path = {Specs()};
  load.settings = Settings(input.Rest());
  diag::Sources sources;
  diag::Findings findings;
  forge::Recipe recipe;
  recipe.reference = "spec.yaml";
  recipe.spec =
      spec::LoadSpecText("spec.yaml", std::string(input.Rest()), Folder(), load, sources, findings);
  Word(findings, sources);
  Must((recipe.spec == nullptr) == findings.HasErrors(), "no spec and no error, or both");
  if (recipe.spec == nullptr) return;
  // A region without room costs a thousand tries. A hundred attempts would take 20 s with
  // sanitizers.
  if (recipe.spec->has_place) options.on_invalid = forge::OnInvalid::kFail;
  for (const auto& [name, text] : recipe.spec->settings) recipe.settings.emplace_back(name, text);
  MakeVariants(recipe, sources, options);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
