// MJCF as far as it is read without MuJoCo: the comment of a generated file, and the tree of a file
// that is to be attached.

#include "mjforge/xml/xml.h"
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
  std::optional<xml::XmlElement> root = xml::ReadXml(file, sources, findings);
  if (root) {
    xml::ResolveFiles(*root, Folder(), findings);
    const xml::FlatText flat = xml::Flatten(*root);
    Must(!xml::FindXmlFault(flat.text), "the text for MuJoCo is no XML");
  }
  Must(root || findings.HasErrors(), "no tree and no error");
  Word(findings, sources);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
