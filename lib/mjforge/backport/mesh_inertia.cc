// Adds inertias to bodies with meshes. MuJoCo computes the inertias from a copy of the model in
// which each mesh is replaced by a box with the same inertia.
#include "mjforge/backport/mesh_inertia.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "mjforge/backport/default_classes.h"
#include "mjforge/backport/mesh_measure.h"
#include "mjforge/backport/visual_geoms.h"
#include "mjforge/engine/engine.h"

namespace mjforge::backport {
namespace {

constexpr std::string_view kInertia = "inertia";

using LoadText = std::function<engine::Loaded(const std::string&)>;

std::string Text(const mjtNum* numbers, int count) {
  return xml::TextOf(std::vector<double>(numbers, numbers + count));
}

class MeshInertia {
 public:
  explicit MeshInertia(xml::XmlElement& root) : root_(root) { Find(); }

  /// Does the work of AddMeshInertia(): adds inertias to bodies, and removes the attribute
  /// `inertia` of meshes. Returns the mark of the first body that was given an inertia, or an empty
  /// mark.
  diag::SourceMark Run(const LoadText& load) {
    if (bodies_.empty()) return {};
    if (AddAll(load)) {
      RemoveInertiaAttributes(root_);
      return first_;
    }
    // If MuJoCo rejects the file even without `inertia`, removes this attribute, because an error
    // about the attribute would hide the reason.
    xml::XmlElement without_inertia = root_;
    RemoveInertiaAttributes(without_inertia);
    if (!load(xml::Flatten(without_inertia).text).model) RemoveInertiaAttributes(root_);
    return {};
  }

 private:
  struct Geom {
    std::string name;     // name in the copies of the model
    std::string mass;     // kg; empty if the density determines it
    std::string density;  // kg/m^3
    std::string group;
    MeshInertiaKind kind = MeshInertiaKind::kLegacy;
  };

  /// Adds an inertia to each body in bodies_. Returns false, and changes nothing, if MuJoCo rejects
  /// a copy of the model.
  bool AddAll(const LoadText& load) {
    const engine::Loaded meshes = load(xml::Flatten(Copy(nullptr)).text);
    if (!meshes.model) return false;
    const engine::Loaded boxes = load(xml::Flatten(Copy(meshes.model.get())).text);
    if (!boxes.model) return false;
    for (xml::XmlElement& section : root_.children) {
      if (section.tag == "worldbody") AddInertials(section, *boxes.model);
      // Sets `auto`, because MuJoCo replaces `<inertial>` elements if the setting is "true".
      if (section.tag == "compiler" && replaces_) section.Set("inertiafromgeom", "auto");
    }
    return true;
  }

  /// Removes the attribute `inertia` from all meshes.
  static void RemoveInertiaAttributes(xml::XmlElement& root) {
    for (xml::XmlElement& section : root.children) {
      if (section.tag != "asset") continue;
      for (xml::XmlElement& asset : section.children) {
        if (asset.tag == "mesh") asset.Remove(kInertia);
      }
    }
  }

  void Find() {
    DefaultClasses elements(root_);
    const std::string from_geoms = elements.Setting("inertiafromgeom", "auto");
    // Skip files in which MuJoCo does not compute masses from geoms, or computes the masses of
    // meshes by `exactmeshinertia`. Also skip files with global coordinates, which no later release
    // has.
    if (from_geoms == "false" || elements.Setting("exactmeshinertia", "false") != "false" ||
        elements.Setting("coordinate", "local") != "local")
      return;
    replaces_ = from_geoms == "true";
    const bool discards = elements.Setting("discardvisual", "false") == "true";
    bool differs = false;
    for (const ClassedElement* geom : elements.In("geom")) {
      const xml::XmlElement* body = geom->parent;
      if (body->tag != "body" || (HasInertial(*body) && !replaces_)) continue;
      // MuJoCo 3.1.2 and later count the masses of geoms that `discardvisual` removes.
      const bool counts = AddMesh(elements, *geom) || (discards && IsVisual(elements, *geom));
      if (counts || HasInertial(*body))
        bodies_.try_emplace(body, fmt::format("body{}", bodies_.size()));
      differs = differs || counts;
    }
    if (!differs) bodies_.clear();
  }

  static bool HasChild(const xml::XmlElement& body, std::string_view tag) {
    return std::ranges::find(body.children, tag, &xml::XmlElement::tag) != body.children.end();
  }
  static bool HasInertial(const xml::XmlElement& body) { return HasChild(body, "inertial"); }

  /// If the geom is a mesh with a mass, but without `shellinertia`, adds the geom to geoms_ and
  /// returns true; returns false for other geoms.
  bool AddMesh(DefaultClasses& elements, const ClassedElement& geom) {
    if (elements.Get(geom, "type", "") != "mesh") return false;
    if (elements.Get(geom, "shellinertia", "false") != "false") return false;
    Geom found = {fmt::format("geom{}", geoms_.size()), elements.Get(geom, "mass", ""),
                  elements.Get(geom, "density", "1000"), elements.Get(geom, "group", "0"),
                  KindOf(elements, elements.Get(geom, "mesh", ""))};
    if ((!found.mass.empty() && IsZero(found.mass)) || IsZero(found.density)) return false;
    geoms_.emplace(geom.element, std::move(found));
    return true;
  }

  static MeshInertiaKind KindOf(DefaultClasses& elements, const std::string& name) {
    for (const ClassedElement* mesh : elements.In("mesh")) {
      if (mesh->element->AssetName() == name)
        return KindNamed(elements.Get(*mesh, kInertia, "legacy"))
            .value_or(MeshInertiaKind::kLegacy);
    }
    return MeshInertiaKind::kLegacy;
  }

  /// Returns a copy of the model with only the sections on which masses depend. If `meshes` is
  /// null, meshes have no mass. If `meshes` is the compiled model of such a copy, boxes of the same
  /// inertia replace the meshes.
  xml::XmlElement Copy(const mjModel* meshes) const {
    xml::XmlElement copy = {.tag = root_.tag};
    for (const xml::XmlElement& section : root_.children) {
      if (section.tag == "compiler") copy.children.push_back(CopyCompiler(section, meshes));
      if (section.tag == "default" || section.tag == "asset")
        copy.children.push_back(CopyShapes(section));
      if (section.tag == "worldbody") copy.children.push_back(CopyBody(section, meshes));
    }
    return copy;
  }

  /// Copies a compiler section without the settings that change, merge or discard masses.
  xml::XmlElement CopyCompiler(const xml::XmlElement& section, const mjModel* meshes) const {
    xml::XmlElement copy = section;
    for (const char* name : {"settotalmass", "fusestatic", "discardvisual"}) copy.Remove(name);
    if (meshes == nullptr && replaces_) copy.Set("inertiafromgeom", "auto");
    return copy;
  }

  static xml::XmlElement CopyShapes(const xml::XmlElement& section) {
    constexpr std::string_view kKept[] = {"default", "mesh", "hfield", "geom", "joint"};
    xml::XmlElement copy = {.tag = section.tag, .attributes = section.attributes};
    copy.Remove("material");
    copy.Remove(kInertia);
    for (const xml::XmlElement& child : section.children) {
      if (std::ranges::find(kKept, child.tag) != std::end(kKept))
        copy.children.push_back(CopyShapes(child));
    }
    return copy;
  }

  xml::XmlElement CopyBody(const xml::XmlElement& body, const mjModel* meshes) const {
    constexpr std::string_view kOmitted[] = {"site", "camera", "light", "composite"};
    xml::XmlElement copy = {.tag = body.tag, .attributes = body.attributes};
    copy.Remove("name");
    const auto weighed = bodies_.find(&body);
    if (weighed != bodies_.end()) copy.Set("name", weighed->second);
    // MuJoCo rejects a moving body without a mass. Add a mass if meshes, which are massless in the
    // first copy, or a composite, which neither copy contains, would give the body its mass.
    const bool has_mass = weighed == bodies_.end() || meshes != nullptr;
    if (!HasInertial(body) && (!has_mass || HasChild(body, "composite")))
      copy.children.push_back(Inertial("1", "0 0 0", "1 0 0 0", "1 1 1"));
    for (const xml::XmlElement& child : body.children) {
      if (std::ranges::find(kOmitted, child.tag) != std::end(kOmitted)) continue;
      copy.children.push_back(child.tag == "body"   ? CopyBody(child, meshes)
                              : child.tag == "geom" ? CopyGeom(child, meshes)
                                                    : child);
    }
    return copy;
  }

  xml::XmlElement CopyGeom(const xml::XmlElement& geom, const mjModel* meshes) const {
    xml::XmlElement copy = geom;
    copy.generated_name.clear();
    copy.Remove("material");
    copy.Remove("name");
    const auto found = geoms_.find(&geom);
    if (found == geoms_.end()) return copy;
    const Geom& weighed = found->second;
    const int id = meshes == nullptr ? -1 : mj_name2id(meshes, mjOBJ_GEOM, weighed.name.c_str());
    if (id < 0) {
      copy.Set("name", weighed.name);
      copy.Set("mass", "0");
      // MuJoCo computes the convex hulls of colliding meshes only.
      if (weighed.kind == MeshInertiaKind::kConvex) copy.Set("contype", "1");
      return copy;
    }
    const MeshMeasure measured = Measure(*meshes, meshes->geom_dataid[id], weighed.kind);
    std::array<mjtNum, 3> pos;
    std::array<mjtNum, 4> quat;
    mju_rotVecQuat(pos.data(), measured.pos.data(), meshes->geom_quat + 4 * id);
    mju_addTo3(pos.data(), meshes->geom_pos + 3 * id);
    mju_mulQuat(quat.data(), meshes->geom_quat + 4 * id, measured.quat.data());
    copy.attributes.clear();
    copy.Set("type", "box");
    copy.Set("size", xml::TextOf({measured.box.begin(), measured.box.end()}));
    copy.Set("pos", Text(pos.data(), 3));
    copy.Set("quat", Text(quat.data(), 4));
    copy.Set("group", weighed.group);
    const std::vector<double> density = xml::NumbersOf(weighed.density);
    copy.Set("mass", !weighed.mass.empty() ? weighed.mass
                     : density.empty()     ? weighed.density
                                           : xml::TextOf({density[0] * measured.size}));
    return copy;
  }

  static xml::XmlElement Inertial(const std::string& mass, const std::string& pos,
                                  const std::string& quat, const std::string& diagonal) {
    return {
        .tag = "inertial",
        .attributes = {{"mass", mass}, {"pos", pos}, {"quat", quat}, {"diaginertia", diagonal}}};
  }

  void AddInertials(xml::XmlElement& body, const mjModel& m) {
    for (xml::XmlElement& child : body.children) {
      if (child.tag == "body") AddInertials(child, m);
    }
    const auto weighed = bodies_.find(&body);
    if (weighed == bodies_.end()) return;
    const int id = mj_name2id(&m, mjOBJ_BODY, weighed->second.c_str());
    xml::XmlElement inertial =
        Inertial(Text(m.body_mass + id, 1), Text(m.body_ipos + 3 * id, 3),
                 Text(m.body_iquat + 4 * id, 4), Text(m.body_inertia + 3 * id, 3));
    inertial.mark = body.mark;
    if (!first_) first_ = body.mark;
    std::erase_if(body.children, [](const auto& child) { return child.tag == "inertial"; });
    body.children.insert(body.children.begin(), std::move(inertial));
  }

  xml::XmlElement& root_;
  bool replaces_ = false;  // true: masses of geoms replace `<inertial>` (inertiafromgeom)
  diag::SourceMark first_;
  std::map<const xml::XmlElement*, Geom> geoms_;
  std::map<const xml::XmlElement*, std::string> bodies_;
};

}  // namespace

diag::SourceMark AddMeshInertia(xml::XmlElement& root, const LoadText& load) {
  if (mjVERSION_HEADER >= 300) return {};
  return MeshInertia(root).Run(load);
}

}  // namespace mjforge::backport
