// Texts of variants, and MuJoCo's loading of texts from memory.

#include "bare_load.h"
#include "mjforge/assemble/assemble.h"

#include <cstdlib>

namespace mjforge::bench {

std::vector<std::string> Texts(const forge::Recipe& recipe, std::string_view size, int count) {
  assemble::Assembler assembler;
  mjcf::MjcfDocument document;
  std::vector<std::string> texts;
  for (int index = 0; index < count; ++index) {
    MakeText(recipe, assembler, static_cast<std::uint64_t>(index), document);
    texts.push_back(document.text);
    texts.back().insert(document.size_position, size);
  }
  return texts;
}

void BareLoader::Load(const std::string& text) {
  files_.SetText(text);
  char error[1000] = "";
  mjModel* model = mj_loadXML(files_.kTextName, files_.Get(), error, sizeof(error));
  if (model == nullptr) std::abort();
  mj_deleteModel(model);
}

}  // namespace mjforge::bench
