// Copies bodies with their joints, geoms, sites, cameras and lights from the compiled model
// (mjModel) into an attachment.
#include "mjforge/attach/body_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "mjforge/attach/attributes.h"
#include "mjforge/compiled/compiled.h"

namespace mjforge::attach {
namespace {

using compiled::PoseAt;
using compiled::VectorAt;
using diag::Code;

constexpr std::array<std::string_view, 5> kModes = {"fixed", "track", "trackcom", "targetbody",
                                                    "targetbodycom"};

class BodyReader {
 public:
  BodyReader(const CompiledFile& file, NameScope& scope, AssetReader& assets,
             model::Attachment& out, diag::Findings& findings)
      : file_(file),
        m_(file.model()),
        scope_(scope),
        assets_(assets),
        out_(out),
        findings_(findings) {}

  void Read() {
    const auto each = [this](mjtObj kind, int count, const auto& read) {
      for (int id = 0; id < count; ++id) {
        if (scope_.Contains(kind, id)) read(id);
      }
    };
    for (const int id : scope_.bodies()) ReadBody(id);
    each(mjOBJ_JOINT, m_.njnt, [this](int id) { ReadJoint(id); });
    each(mjOBJ_GEOM, m_.ngeom, [this](int id) { ReadGeom(id); });
    each(mjOBJ_SITE, m_.nsite, [this](int id) { ReadSite(id); });
    each(mjOBJ_CAMERA, m_.ncam, [this](int id) {
      ReadTargeted(mjOBJ_CAMERA, id, m_.cam_bodyid[id], m_.cam_mode[id], m_.cam_targetbodyid[id]);
    });
    each(mjOBJ_LIGHT, m_.nlight, [this](int id) {
      ReadTargeted(mjOBJ_LIGHT, id, m_.light_bodyid[id], m_.light_mode[id],
                   m_.light_targetbodyid[id]);
    });
    for (const model::Joint& joint : out_.bodies.front().joints) {
      out_.root_joints.push_back(joint.name);
    }
  }

 private:
  model::Body& BodyOf(int id) { return out_.bodies[static_cast<std::size_t>(scope_.Position(id))]; }

  void ReadBody(int id) {
    model::Body& body = out_.bodies.emplace_back(compiled::BodyOf(m_, id));
    scope_.Label(mjOBJ_BODY, id, body);
    body.parent = out_.bodies.size() == 1 ? -1 : scope_.Position(m_.body_parentid[id]);
    Attributes(spec::kBodyElement, body.attributes).Read(m_, mjOBJ_BODY, id);
    if (m_.body_mocapid[id] >= 0) {
      AddWarning(findings_, Code::kAttachNotCarried, body.mark,
                 fmt::format("{} of '{}' is not a mocap body where it is attached",
                             file_.Description(mjOBJ_BODY, id), file_.file().string()),
                 "a mocap body cannot be part of an object");
    }
  }

  void ReadJoint(int id) {
    model::Joint& joint = BodyOf(m_.jnt_bodyid[id]).joints.emplace_back(compiled::JointOf(m_, id));
    scope_.Label(mjOBJ_JOINT, id, joint);
    Attributes(spec::kJointElement, joint.attributes).Read(m_, mjOBJ_JOINT, id);
  }

  void ReadGeom(int id) {
    std::optional<model::Part> read = compiled::PartOf(m_, id);
    if (!read) {
      const bool plane = m_.geom_type[id] == mjGEOM_PLANE;
      AddError(findings_, Code::kAttachNotCarried, file_.MarkOf(mjOBJ_GEOM, id),
               fmt::format("{} of '{}' is a {}, which cannot be part of an object",
                           file_.Description(mjOBJ_GEOM, id), file_.file().string(),
                           plane ? "plane" : "height field"),
               "planes and height fields belong to the world; attach a body without one");
      return;
    }
    model::Part& part = BodyOf(m_.geom_bodyid[id]).parts.emplace_back(*std::move(read));
    scope_.Label(mjOBJ_GEOM, id, part);
    if (part.shape.type == model::GeomType::kMesh) {
      const int mesh = m_.geom_dataid[id];
      part.mesh = assets_.Mesh(mesh);
      part.shape.mesh = &out_.meshes[static_cast<std::size_t>(part.mesh)]->mesh;
      part.X_BG = part.X_BG * assets_.FrameOf(mesh).Inverse();
    }
    part.material = assets_.Material(m_.geom_matid[id]);
    ReadGeomAttributes(id, part);
  }

  void ReadGeomAttributes(int id, model::Part& part) {
    Attributes attributes(spec::kPartElement, part.attributes);
    const std::span<const compiled::ArrayField> fields = compiled::ArrayFields(mjOBJ_GEOM);
    const auto rgba = std::ranges::find(fields, "rgba", &compiled::ArrayField::attribute);
    attributes.Read(m_, {fields.begin(), rgba}, id);
    const std::span<const mjtNum> fluid = Row(m_.geom_fluid, id, mjNFLUID);
    if (fluid[0] > 0) {
      attributes.Text("fluidshape", "ellipsoid");
      constexpr mjtNum kUsual[] = {0.5, 0.25, 1.5, 1, 1};
      const std::span<const mjtNum> coefficients = fluid.subspan(1, 5);
      if (!std::ranges::equal(coefficients, kUsual)) attributes.Numbers("fluidcoef", coefficients);
    }
    attributes.Read(m_, {rgba, fields.end()}, id);
  }

  void ReadSite(int id) {
    model::Site& site = BodyOf(m_.site_bodyid[id]).sites.emplace_back();
    scope_.Label(mjOBJ_SITE, id, site);
    site.type = compiled::GeomTypeOf(m_.site_type[id]).value_or(model::GeomType::kSphere);
    site.size = VectorAt(m_.site_size, id);
    site.X_BS = PoseAt(m_.site_pos, m_.site_quat, id);
    site.material = assets_.Material(m_.site_matid[id]);
    Attributes(spec::kSiteElement, site.attributes).Read(m_, mjOBJ_SITE, id);
  }

  /// Reads a camera or light. If its target is a body that is not attached, adds a warning and
  /// drops the camera or light.
  void ReadTargeted(mjtObj kind, int id, int body, int mode, int target) {
    if (target >= 0 && !scope_.Contains(mjOBJ_BODY, target)) {
      AddWarning(findings_, Code::kAttachNotCarried, file_.MarkOf(kind, id),
                 fmt::format("{} of '{}' is not carried over: its target, {}, is not attached",
                             file_.Description(kind, id), file_.file().string(),
                             file_.Description(mjOBJ_BODY, target)));
      scope_.Drop(kind, id);
      return;
    }
    const spec::ElementInfo& info = *spec::FindBodyChild(KindName(kind));
    model::Element& element = BodyOf(body).elements.emplace_back();
    element.tag = info.name;
    scope_.Label(kind, id, element);
    Attributes attributes(info, element.attributes);
    if (mode != 0) attributes.Text("mode", kModes[static_cast<std::size_t>(mode)]);
    if (target >= 0) attributes.Text("target", scope_.Name(mjOBJ_BODY, target));
    attributes.Read(m_, kind, id);
  }

  const CompiledFile& file_;
  const mjModel& m_;
  NameScope& scope_;
  AssetReader& assets_;
  model::Attachment& out_;
  diag::Findings& findings_;
};

}  // namespace

void ReadBodies(const CompiledFile& file, NameScope& scope, AssetReader& assets,
                model::Attachment& out, diag::Findings& findings) {
  BodyReader(file, scope, assets, out, findings).Read();
}

}  // namespace mjforge::attach
