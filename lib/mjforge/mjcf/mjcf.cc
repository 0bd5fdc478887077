// Writing of a complete MJCF file: calls the writers of its sections in the order of the file. Also
// finds the origin of a line and the total size of the meshes.

#include "mjforge/mjcf/mjcf.h"

#include <algorithm>

#include "mjforge/mjcf/element_writer.h"
#include "mjforge/mjcf/provenance.h"
#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {

diag::SourceMark MjcfDocument::Origin(int line) const {
  const auto found = std::ranges::lower_bound(origins, line, {}, &LineOrigin::line);
  return found != origins.end() && found->line == line ? found->mark : diag::SourceMark{};
}

std::size_t MeshBytes(std::string_view text) {
  std::size_t bytes = 0;
  // Adds up the lengths of lines, because ElementWriter writes each <mesh> on a line of its own.
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
  const bool scene = rules.has_scene;
  document.text.clear();
  document.origins.clear();
  document.assets.clear();
  document.generated_files.clear();
  document.lift = scene ? LiftOntoFloor(object) : 0;

  AppendProvenance(provenance, document);
  ElementWriter writer(document);
  writer.WriteLine("");
  writer.OpenElement("mujoco");
  writer.WriteText("model", object.name);
  writer.BeginContent();
  // Compiler threads are off, because they cost more time than they save for small models.
  writer.WriteLine("<compiler angle=\"radian\" usethread=\"false\"/>");
  document.size_position = scene ? std::string::npos : writer.size();
  WriteSizes(object, scene, writer);
  WriteSettings(object, writer);
  if (scene || rules.always_has_assets || !object.textures.empty() || !object.materials.empty() ||
      !object.meshes.empty()) {
    writer.OpenElement("asset");
    writer.BeginContent();
    WriteAssets(object, provenance.assets_as == kAssetForms[1], writer, document);
    if (scene) WriteSceneAssets(writer);
    writer.EndElement("asset");
  }
  writer.OpenElement("worldbody");
  writer.BeginContent();
  document.world_position = scene ? std::string::npos : writer.size();
  document.host_adds_free_joint = !rules.has_free_joint;
  if (scene) WriteSceneWorld(object, writer);
  WriteBodies(object, rules, document.lift, writer);
  writer.EndElement("worldbody");
  WriteSections(object, document.lift, writer);
  writer.EndElement("mujoco");
  writer.Finish();
}

}  // namespace mjforge::mjcf
