#include "mjforge/mjcf/mjcf.h"

#include <algorithm>

#include "mjforge/mjcf/element_writer.h"
#include "mjforge/mjcf/provenance.h"
#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

// Keeps the memory.
void Clear(MjcfDocument& document) {
  document.text.clear();
  document.origins.clear();
  document.assets.clear();
  document.made_files.clear();
}

}  // namespace

diag::SourceMark MjcfDocument::Origin(int line) const {
  const auto found = std::ranges::lower_bound(origins, line, {}, &LineOrigin::line);
  return found != origins.end() && found->line == line ? found->mark : diag::SourceMark{};
}

std::size_t MeshBytes(std::string_view text) {
  std::size_t bytes = 0;
  // As the writer puts them: one per line.
  while (!text.empty()) {
    const std::size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, size);
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin != line.npos && line.substr(begin).starts_with("<mesh ")) bytes += size;
    text.remove_prefix(size);
  }
  return bytes;
}

void WriteMjcf(const model::Object& object, Target target, const Provenance& provenance,
               MjcfDocument& document) {
  const TargetRules& rules = RulesOf(target);
  const bool scene = rules.scene;
  Clear(document);
  document.lift = scene ? LiftOntoFloor(object) : 0;

  AppendProvenance(provenance, document);
  ElementWriter writer(document);
  writer.Line("");
  writer.Open("mujoco");
  writer.Text("model", object.name);
  writer.Content();
  // Threads cost hosts that load thousands of small models more than they save.
  writer.Line("<compiler angle=\"radian\" usethread=\"false\"/>");
  document.size_position = scene ? std::string::npos : document.text.size();
  WriteSizes(object, scene, writer);
  WriteSettings(object, writer);

  if (scene || rules.always_assets || !object.textures.empty() || !object.materials.empty() ||
      !object.meshes.empty()) {
    writer.Open("asset");
    writer.Content();
    WriteAssets(object, provenance.assets_as == kAssetForms[1], writer, document);
    if (scene) WriteSceneAssets(writer);
    writer.End("asset");
  }
  writer.Open("worldbody");
  writer.Content();
  document.world_position = scene ? std::string::npos : document.text.size();
  document.host_frees = !rules.free_joint;
  if (scene) WriteSceneWorld(object, writer);
  WriteBodies(object, GroupsOf(target), document.lift, writer);
  writer.End("worldbody");
  WriteSections(object, document.lift, writer);
  writer.End("mujoco");
}

}  // namespace mjforge::mjcf
