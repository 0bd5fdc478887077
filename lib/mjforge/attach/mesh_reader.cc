// MeshReader: compiles a model of the meshes alone to find their inertial frames, and undoes
// MuJoCo's move of each mesh into its inertial frame.
#include "mjforge/attach/mesh_reader.h"

#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "mjforge/attach/attributes.h"
#include "mjforge/compiled/compiled.h"

namespace mjforge::attach {
namespace {

constexpr std::string_view kData[] = {"refpos",   "refquat", "vertex",      "normal",
                                      "texcoord", "face",    "smoothnormal"};
constexpr const char* kMain = "main";

/// Copies only the meshes of a file, with all attributes on which the meshes' frames depend.
/// Besides `scale`, these include the default density, because it determines when MuJoCo's
/// iteration that diagonalizes the inertia stops.
void CopyMeshes(const XmlElement& from, XmlElement& to) {
  const auto copy = [&](const XmlElement& child, std::string_view attribute) {
    XmlElement& copied = to.children.emplace_back(XmlElement{.tag = child.tag});
    if (const std::string* text = child.Find(attribute)) copied.Set(attribute, *text);
  };
  to.tag = from.tag;
  to.attributes = from.attributes;
  for (const XmlElement& child : from.children) {
    if (child.tag == "mesh") to.children.push_back(child);
    if (child.tag == "geom") copy(child, "density");
    if (child.tag == "compiler") copy(child, "exactmeshinertia");
    if (child.tag == "default" || child.tag == "asset") {
      CopyMeshes(child, to.children.emplace_back());
    }
  }
}

/// Returns the attribute `scale` of a mesh; nullopt if the attribute is missing or is not three
/// numbers.
std::optional<Eigen::Vector3d> ParseScale(const XmlElement& mesh) {
  const std::string* text = mesh.Find("scale");
  if (text == nullptr) return std::nullopt;
  const std::vector<double> numbers = xml::NumbersOf(*text);
  if (numbers.size() != 3) return std::nullopt;
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

std::string ClassOf(const XmlElement& element) {
  const std::string* name = element.Find("class");
  return name == nullptr ? kMain : *name;
}

}  // namespace

MeshReader::MeshReader(const CompiledFile& file, diag::Findings& findings) : file_(file) {
  scales_[kMain] = Eigen::Vector3d::Ones();
  for (const XmlElement& section : file.root().children) {
    if (section.tag == "default") ReadDefaults(section, scales_[kMain]);
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
  XmlElement probe;
  CopyMeshes(file_.root(), probe);
  XmlElement& world = probe.children.emplace_back(XmlElement{.tag = "worldbody"});
  for (const int mesh : used) {
    XmlElement& geom = world.children.emplace_back(XmlElement{.tag = "geom"});
    geom.Set("type", "mesh");
    geom.Set("mesh", m.names + m.name_meshadr[mesh]);
    geom.Set("mass", "0");  // because MuJoCo cannot compute the mass of every mesh
  }
  const engine::Loaded loaded = file_.engine().LoadText(xml::Flatten(probe).text);
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

// Reads `scale` of default classes like MuJoCo: a class inherits the value of its parent class, and
// all top-level default sections belong to the same class.
void MeshReader::ReadDefaults(const XmlElement& section, const Eigen::Vector3d& inherited) {
  Eigen::Vector3d scale = inherited;
  for (const XmlElement& child : section.children) {
    if (child.tag == "mesh") scale = ParseScale(child).value_or(scale);
  }
  scales_[ClassOf(section)] = scale;
  for (const XmlElement& child : section.children) {
    if (child.tag == "default") ReadDefaults(child, scale);
  }
}

Eigen::Vector3d MeshReader::ScaleOf(const XmlElement& mesh) const {
  if (const std::optional<Eigen::Vector3d> scale = ParseScale(mesh)) return *scale;
  const auto found = scales_.find(ClassOf(mesh));
  return found == scales_.end() ? Eigen::Vector3d::Ones() : found->second;
}

model::MeshAsset MeshReader::Read(int mesh) const {
  model::MeshAsset asset;
  asset.mark = file_.MarkOf(mjOBJ_MESH, mesh);
  asset.mesh = compiled::MeshOf(file_.model(), mesh);
  for (Eigen::Vector3d& vertex : asset.mesh.vertices) vertex = FrameOf(mesh) * vertex;
  const XmlElement* element = file_.ElementOf(mjOBJ_MESH, mesh);
  if (element == nullptr) return asset;
  if (const std::string* file = element->Find("file")) asset.file = *file;
  asset.scale = ScaleOf(*element);
  CopyAttributes(*element, kData, asset.attributes);
  // Removes smoothnormal="false", the default. All other attributes are lists of numbers.
  std::erase_if(asset.attributes, [](const auto& attribute) { return attribute.text == "false"; });
  return asset;
}

}  // namespace mjforge::attach
