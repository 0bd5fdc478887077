// A program of somebody else's that makes one hammer: its MJCF on standard
// output, findings on standard error.

#include <mjforge/forge/forge.h>

#include <iostream>

int main() {
  using namespace mjforge;
  diag::Sources sources;
  diag::Findings findings;
  forge::Variant variant;
  const auto recipe =
      forge::LoadRecipe("hammer", {.search_path = {MJFORGE_SPECS}}, sources, findings);
  if (recipe) {
    forge::Generator generator(*recipe, sources, {.seed = 7});
    generator.Make(41, variant);
    findings.Append(variant.findings);
  }
  for (const diag::Finding& finding : findings) {
    std::cerr << diag::RenderText(finding, sources, false);
  }
  if (!variant.ok()) return 1;
  std::cout << variant.document.text;
  return 0;
}
