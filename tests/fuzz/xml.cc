// MJCF as far as it is read without MuJoCo: the comment of a generated file, and the tree of a file
// that is to be attached.

#include "fuzz/input.h"
#include "mjforge/attach/attach.h"
#include "mjforge/engine/engine.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::fuzz {

void Run(Input input) {
  const std::string text(input.Rest());
  engine::ParseRefusal(text);
  engine::ElementOnLine(text, 3);
  mjcf::ReadProvenance(text);
  if (Input(input).Byte() != '<') return;  // the rest would only say that it is no XML

  const std::filesystem::path file = Put("input.xml", text);
  diag::Sources sources;
  diag::Findings findings;
  std::optional<engine::XmlElement> root = engine::ReadXml(file, sources, findings);
  if (root) {
    engine::ResolveFiles(*root, Folder(), findings);
    const engine::FlatText flat = engine::Flatten(*root);
    Must(!engine::WhyNotXml(flat.text), "the text for MuJoCo is no XML");
  }
  Must(root || findings.HasErrors(), "no tree and no error");
  Word(findings, sources);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
