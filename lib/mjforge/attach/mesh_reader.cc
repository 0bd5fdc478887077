#include "mjforge/attach/mesh_reader.h"

#include <array>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/attach/attributes.h"
#include "mjforge/attach/mujoco_numbers.h"
#include "mjforge/compiled/compiled.h"

namespace mjforge::attach {
namespace {

constexpr std::array<std::string_view, 6> kData = {"refpos", "refquat",  "vertex",
                                                   "normal", "texcoord", "face"};
constexpr std::string_view kMain = "main";

/// What a mesh's frame depends on: `scale`, and the density of its class, by
/// which MuJoCo decides when to stop turning the axes of inertia.
XmlElement MeshDefaults(const XmlElement& section) {
  XmlElement kept;
  kept.tag = section.tag;
  kept.attributes = section.attributes;
  for (const XmlElement& child : section.children) {
    if (child.tag == "default") {
      kept.children.push_back(MeshDefaults(child));
    } else if (child.tag == "mesh") {
      kept.children.push_back(child);
    } else if (child.tag == "geom") {
      XmlElement geom;
      geom.tag = child.tag;
      if (const std::string* density = child.Find("density")) geom.Set("density", *density);
      kept.children.push_back(std::move(geom));
    }
  }
  return kept;
}

XmlElement OnlyMeshes(const XmlElement& section) {
  XmlElement kept;
  kept.tag = section.tag;
  for (const XmlElement& asset : section.children) {
    if (asset.tag == "mesh") kept.children.push_back(asset);
  }
  return kept;
}

/// The file with its meshes alone.
XmlElement MeshesOf(const XmlElement& root) {
  XmlElement probe;
  probe.tag = "mujoco";
  for (const XmlElement& section : root.children) {
    if (section.tag == "compiler") {
      const std::string* exact = section.Find("exactmeshinertia");
      if (exact == nullptr) continue;
      XmlElement& compiler = probe.children.emplace_back();
      compiler.tag = "compiler";
      compiler.Set("exactmeshinertia", *exact);
    } else if (section.tag == "default") {
      probe.children.push_back(MeshDefaults(section));
    } else if (section.tag == "asset") {
      probe.children.push_back(OnlyMeshes(section));
    }
  }
  return probe;
}

}  // namespace

MeshReader::MeshReader(const CompiledFile& file, diag::Findings& findings) : file_(file) {
  scales_[std::string(kMain)] = Eigen::Vector3d::Ones();
  for (const XmlElement& section : file.root().children) {
    if (section.tag == "default") ReadDefaults(section, scales_[std::string(kMain)]);
  }
  FindFrames(findings);
}

void MeshReader::FindFrames(diag::Findings& findings) {
  const mjModel& m = file_.model();
  std::set<int> used;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    if (m.geom_type[geom] == mjGEOM_MESH) used.insert(m.geom_dataid[geom]);
  }
  if (used.empty()) return;
  XmlElement probe = MeshesOf(file_.root());
  XmlElement& world = probe.children.emplace_back();
  world.tag = "worldbody";
  for (const int mesh : used) {
    XmlElement& geom = world.children.emplace_back();
    geom.tag = "geom";
    geom.Set("type", "mesh");
    geom.Set("mesh", m.names + m.name_meshadr[mesh]);
  }
  const engine::Loaded loaded = file_.engine().LoadText(Flatten(probe).text);
  if (!loaded.model) {
    AddError(findings, diag::Code::kMujocoError, {},
             fmt::format("MuJoCo refused the meshes of '{}' on their own: {}",
                         file_.file().string(), engine::ParseRefusal(loaded.error).reason));
    return;
  }
  int geom = 0;
  for (const int mesh : used) {
    frames_[mesh] = compiled::PoseAt(loaded.model->geom_pos, loaded.model->geom_quat, geom++);
  }
}

// As MuJoCo reads them: a class starts as a copy of what its parent says before
// any class inside, and a further top-level section goes on with the same one.
void MeshReader::ReadDefaults(const XmlElement& section, const Eigen::Vector3d& inherited) {
  Eigen::Vector3d scale = inherited;
  for (const XmlElement& child : section.children) {
    const std::string* text = child.tag == "mesh" ? child.Find("scale") : nullptr;
    if (text == nullptr) continue;
    const std::vector<double> numbers = ParseNumbers(*text);
    if (numbers.size() == 3) scale = {numbers[0], numbers[1], numbers[2]};
  }
  const std::string* name = section.Find("class");
  scales_[name == nullptr ? std::string(kMain) : *name] = scale;
  for (const XmlElement& child : section.children) {
    if (child.tag == "default") ReadDefaults(child, scale);
  }
}

Eigen::Vector3d MeshReader::ScaleOf(const XmlElement& mesh) const {
  if (const std::string* text = mesh.Find("scale")) {
    const std::vector<double> numbers = ParseNumbers(*text);
    if (numbers.size() == 3) return {numbers[0], numbers[1], numbers[2]};
  }
  const std::string* name = mesh.Find("class");
  const auto found = scales_.find(name == nullptr ? std::string(kMain) : *name);
  return found == scales_.end() ? Eigen::Vector3d::Ones() : found->second;
}

model::MeshAsset MeshReader::Read(int mesh) const {
  const mjModel& m = file_.model();
  model::MeshAsset asset;
  asset.mark = file_.MarkOf(mjOBJ_MESH, mesh);
  const model::Pose& X_AM = FrameOf(mesh);
  for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) {
    const float* v = m.mesh_vert + 3 * (m.mesh_vertadr[mesh] + i);
    asset.mesh.vertices.push_back(X_AM * Eigen::Vector3d(v[0], v[1], v[2]));
  }
  for (int i = 0; i < m.mesh_facenum[mesh]; ++i) {
    const int* f = m.mesh_face + 3 * (m.mesh_faceadr[mesh] + i);
    asset.mesh.triangles.push_back({f[0], f[1], f[2]});
  }
  const XmlElement* element = file_.ElementOf(mjOBJ_MESH, mesh);
  if (element == nullptr) return asset;
  if (const std::string* file = element->Find("file")) asset.file = *file;
  asset.scale = ScaleOf(*element);
  for (const std::string_view name : kData) {
    const std::string* text = element->Find(name);
    if (text == nullptr) continue;
    model::Attribute& attribute = asset.attributes.emplace_back();
    attribute.name = name;
    for (const double number : ParseNumbers(*text)) attribute.numbers.push_back(number);
    if (attribute.numbers.empty()) attribute.text = *text;
  }
  const std::string* smooth = element->Find("smoothnormal");
  if (smooth != nullptr && *smooth == "true") {
    model::Attribute& attribute = asset.attributes.emplace_back();
    attribute.name = "smoothnormal";
    attribute.text = *smooth;
  }
  return asset;
}

}  // namespace mjforge::attach
