// Attached MJCF, with MuJoCo: reading a body of the file, and writing an object that has it. What
// MuJoCo itself does wrong is not ours: run.py tells the two apart.

#include "fuzz/input.h"
#include "fuzz/variants.h"

namespace mjforge::fuzz {
namespace {

constexpr const char* kSpec =
    "mjforge: 1\nname: object\nbodies: [{name: body, mjcf: input.xml, pos: [0, 0, 1cm .. 2cm]}]\n";

}  // namespace

void Run(Input input) {
  forge::Options options;
  options.target = static_cast<mjcf::Target>(input.Below(mjcf::Targets().size()));
  Put("input.xml", input.Rest());
  diag::Sources sources;
  diag::Findings findings;
  forge::Recipe recipe;
  recipe.reference = "spec.yaml";
  recipe.spec = spec::LoadSpecText("spec.yaml", kSpec, Folder(), {}, sources, findings);
  Must(recipe.spec != nullptr, "the spec is wrong");
  MakeVariants(recipe, sources, options);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
