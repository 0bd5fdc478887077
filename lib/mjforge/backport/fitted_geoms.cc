// Fitting of geoms to meshes (`fitaabb`): lets MuJoCo load the meshes, and computes sizes and poses
// of the shapes from their bounding boxes.
#include "mjforge/backport/fitted_geoms.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/backport/default_classes.h"

namespace mjforge::backport {
namespace {

using LoadText = std::function<engine::Loaded(const std::string&)>;

constexpr std::string_view kFitted[] = {"sphere", "capsule", "cylinder", "ellipsoid", "box"};
constexpr std::string_view kAngles[] = {"axisangle", "euler", "xyaxes", "zaxis"};

/// Returns the MJCF `size` of the smallest shape whose bounding box contains a box with the half
/// sizes `half`, multiplied by `scale`; nullopt if a size would be negative, zero or at least
/// mjMAXVAL.
std::optional<std::vector<double>> SizesOf(std::string_view type, const std::array<double, 3>& half,
                                           double scale) {
  const double radius = std::max(half[0], half[1]);
  std::vector<double> sizes(half.begin(), half.end());
  if (type == "sphere") sizes = {std::max(radius, half[2])};
  if (type == "capsule") sizes = {radius, half[2] - radius};
  if (type == "cylinder") sizes = {radius, half[2]};
  for (double& size : sizes) size *= scale;
  const auto is_valid = [](double size) { return size > 0 && size < mjMAXVAL; };
  if (!std::ranges::all_of(sizes, is_valid)) return std::nullopt;
  return sizes;
}

class GeomFitter {
 public:
  explicit GeomFitter(xml::XmlElement& root) : elements_(root) {
    // Skips files with global coordinates, because the releases that fit shapes by this rule do not
    // have global coordinates.
    if (elements_.Setting("fitaabb", "false") != "true" ||
        elements_.Setting("coordinate", "local") != "local")
      return;
    for (const ClassedElement* geom : elements_.In("geom")) {
      if (IsFitted(*geom)) fitted_.push_back(geom);
    }
  }

  diag::SourceMark Run(const LoadText& load) {
    if (fitted_.empty()) return {};
    const engine::Loaded loaded = load(xml::Flatten(MeshModel()).text);
    if (!loaded.model) return {};
    for (std::size_t i = 0; i < fitted_.size(); ++i) {
      const int id = mj_name2id(loaded.model.get(), mjOBJ_GEOM, NameOf(i).c_str());
      if (id >= 0) Replace(*fitted_[i], *loaded.model, id);
    }
    return first_;
  }

 private:
  static std::string NameOf(std::size_t i) { return fmt::format("geom{}", i); }

  /// Returns true for a primitive geom with a `mesh` that Replace() can replace. Excludes geoms
  /// with `fromto`, because MuJoCo reports this error, and geoms that inherit an orientation such
  /// as `euler` from a default class, because the inherited orientation would have precedence over
  /// `quat`.
  bool IsFitted(const ClassedElement& geom) const {
    const std::string& parent = geom.parent->tag;
    if (parent != "body" && parent != "worldbody" && parent != "frame") return false;
    const std::string type = elements_.Get(geom, "type", "sphere");
    if (elements_.Get(geom, "mesh", "").empty() ||
        std::ranges::find(kFitted, type) == std::end(kFitted))
      return false;
    if (elements_.Find(geom, "fromto") != nullptr) return false;
    return std::ranges::none_of(kAngles, [&](std::string_view angle) {
      const std::string* text = elements_.Find(geom, angle);
      return text != nullptr && text != geom.element->Find(angle);
    });
  }

  /// Returns an element with the attributes of its default classes, and without a class.
  xml::XmlElement WithDefaults(const ClassedElement& classed) const {
    xml::XmlElement merged = *classed.element;
    for (const xml::XmlElement* element : elements_.DefaultsOf(classed)) {
      for (const auto& [name, value] : element->attributes) merged.Set(name, value);
    }
    for (const auto& [name, value] : classed.element->attributes) merged.Set(name, value);
    merged.Remove("class");
    return merged;
  }

  /// Returns a model for computing the bounding boxes of the meshes: each fitted geom becomes a
  /// massless geom of type mesh at the same pose, in the world body.
  xml::XmlElement MeshModel() {
    xml::XmlElement model = {.tag = "mujoco"};
    xml::XmlElement assets = {.tag = "asset"};
    xml::XmlElement world = {.tag = "worldbody"};
    for (const ClassedElement* compiler : elements_.In("compiler")) {
      model.children.push_back(*compiler->element);
      model.children.back().Remove("discardvisual");
    }
    for (std::size_t i = 0; i < fitted_.size(); ++i) {
      xml::XmlElement& geom = world.children.emplace_back(xml::XmlElement{.tag = "geom"});
      geom.Set("name", NameOf(i));
      geom.Set("type", "mesh");
      for (const char* name : {"mass", "contype", "conaffinity"}) geom.Set(name, "0");
      for (const std::string_view name : {"mesh", "pos", "quat"}) CopyTo(geom, *fitted_[i], name);
      for (const std::string_view name : kAngles) CopyTo(geom, *fitted_[i], name);
    }
    for (const ClassedElement* mesh : elements_.In("mesh")) {
      const auto uses = [&](const xml::XmlElement& geom) {
        return *geom.Find("mesh") == mesh->element->AssetName();
      };
      if (mesh->parent->tag == "asset" && std::ranges::any_of(world.children, uses))
        assets.children.push_back(WithDefaults(*mesh));
    }
    model.children.push_back(std::move(assets));
    model.children.push_back(std::move(world));
    return model;
  }

  void CopyTo(xml::XmlElement& copy, const ClassedElement& geom, std::string_view name) const {
    if (const std::string* text = elements_.Find(geom, name)) copy.Set(name, std::string(*text));
  }

  /// Replaces `mesh` of a geom by the size, pos and quat of the fitted shape. `m` is the compiled
  /// MeshModel(), and `id` the id of the mesh geom in `m`.
  void Replace(const ClassedElement& geom, const mjModel& m, int id) {
    const int mesh = m.geom_dataid[id];
    const float* vertices = m.mesh_vert + static_cast<std::ptrdiff_t>(3) * m.mesh_vertadr[mesh];
    std::array<double, 3> half;
    std::array<mjtNum, 3> centre;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double lowest = mjMAXVAL;
      double highest = -mjMAXVAL;
      for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) {
        const double at = vertices[3 * static_cast<std::size_t>(i) + axis];
        lowest = std::min(lowest, at);
        highest = std::max(highest, at);
      }
      centre[axis] = (lowest + highest) / 2;
      half[axis] = highest - centre[axis];
    }
    const std::vector<double> scale = xml::NumbersOf(elements_.Get(geom, "fitscale", "1"));
    if (scale.size() != 1) return;  // MuJoCo reports the error
    const auto sizes = SizesOf(elements_.Get(geom, "type", "sphere"), half, scale[0]);
    if (!sizes) return;
    std::array<mjtNum, 3> pos;
    mju_rotVecQuat(pos.data(), centre.data(), m.geom_quat + 4 * id);
    mju_addTo3(pos.data(), m.geom_pos + 3 * id);
    xml::XmlElement& element = *geom.element;
    for (const std::string_view name : kAngles) element.Remove(name);
    for (const std::string_view name : {"mesh", "fitscale"}) element.Remove(name);
    if (elements_.Find(geom, "mesh") != nullptr) element.Set("mesh", "");  // overrides the class
    element.Set("size", xml::TextOf(*sizes));
    element.Set("pos", xml::TextOf({pos.begin(), pos.end()}));
    element.Set("quat", xml::TextOf({m.geom_quat + 4 * id, m.geom_quat + 4 * id + 4}));
    if (!first_) first_ = element.mark;
  }

  DefaultClasses elements_;
  std::vector<const ClassedElement*> fitted_;
  diag::SourceMark first_;
};

}  // namespace

diag::SourceMark FitGeoms(xml::XmlElement& root, const LoadText& load) {
  if (mjVERSION_HEADER >= 337) return {};
  return GeomFitter(root).Run(load);
}

}  // namespace mjforge::backport
