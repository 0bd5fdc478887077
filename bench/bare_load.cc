#include "bare_load.h"

#include <cstdlib>
#include <cstring>

namespace mjforge::bench {

std::vector<std::string> Texts(const forge::Recipe& recipe, std::string_view size, int count) {
  model::Assembler assembler;
  mjcf::MjcfDocument document;
  std::vector<std::string> texts;
  for (int index = 0; index < count; ++index) {
    MakeText(recipe, assembler, static_cast<std::uint64_t>(index), document);
    texts.push_back(document.text);
    texts.back().insert(document.size_position, size);
  }
  return texts;
}

BareLoader::BareLoader() : vfs_(new mjVFS) { mj_defaultVFS(vfs_.get()); }

void BareLoader::Load(const std::string& text) {
  mj_makeEmptyFileVFS(vfs_.get(), "model.xml", static_cast<int>(text.size()));
  std::memcpy(vfs_->filedata[vfs_->nfile - 1], text.data(), text.size());
  char error[1000] = "";
  mjModel* model = mj_loadXML("model.xml", vfs_.get(), error, sizeof(error));
  if (model == nullptr) std::abort();
  mj_deleteModel(model);
  mj_deleteFileVFS(vfs_.get(), "model.xml");
}

}  // namespace mjforge::bench
