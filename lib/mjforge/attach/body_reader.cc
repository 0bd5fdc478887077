#include "mjforge/attach/body_reader.h"

#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "mjforge/attach/attributes.h"
#include "mjforge/attach/mujoco_numbers.h"
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
  BodyReader(const CompiledFile& file, Taken& taken, AssetReader& assets, model::Attachment& out,
             diag::Findings& findings)
      : file_(file),
        m_(file.model()),
        taken_(taken),
        assets_(assets),
        out_(out),
        findings_(findings) {}

  void Read() {
    for (const int id : taken_.bodies()) ReadBody(id);
    for (int i = 0; i < m_.njnt; ++i) {
      if (taken_.Has(mjOBJ_JOINT, i)) ReadJoint(i);
    }
    for (int i = 0; i < m_.ngeom; ++i) {
      if (taken_.Has(mjOBJ_GEOM, i)) ReadGeom(i);
    }
    for (int i = 0; i < m_.nsite; ++i) {
      if (taken_.Has(mjOBJ_SITE, i)) ReadSite(i);
    }
    for (int i = 0; i < m_.ncam; ++i) {
      if (taken_.Has(mjOBJ_CAMERA, i)) ReadCamera(i);
    }
    for (int i = 0; i < m_.nlight; ++i) {
      if (taken_.Has(mjOBJ_LIGHT, i)) ReadLight(i);
    }
    for (const model::Joint& joint : out_.bodies.front().joints) {
      out_.root_joints.push_back(joint.name);
    }
  }

 private:
  model::Body& BodyOf(int id) { return out_.bodies[static_cast<std::size_t>(taken_.Position(id))]; }

  void ReadBody(int id) {
    model::Body& body = out_.bodies.emplace_back();
    body.name = taken_.Name(mjOBJ_BODY, id);
    body.mark = file_.MarkOf(mjOBJ_BODY, id);
    body.parent = out_.bodies.size() == 1 ? -1 : taken_.Position(m_.body_parentid[id]);
    body.X_PB = PoseAt(m_.body_pos, m_.body_quat, id);
    body.explicit_inertial = true;
    body.mass_properties.mass = m_.body_mass[id];
    body.mass_properties.p_FCm = VectorAt(m_.body_ipos, id);
    const Eigen::Matrix3d axes = compiled::QuaternionAt(m_.body_iquat, id).toRotationMatrix();
    body.mass_properties.I_Cm_F =
        axes * VectorAt(m_.body_inertia, id).asDiagonal() * axes.transpose();
    Attributes(spec::BodyElement(), body.attributes).User(Row(m_.body_user, id, m_.nuser_body));
    if (m_.body_mocapid[id] >= 0) {
      AddWarning(findings_, Code::kAttachNotCarried, body.mark,
                 fmt::format("{} of '{}' is not a mocap body where it is attached",
                             file_.Description(mjOBJ_BODY, id), file_.file().string()),
                 "a mocap body cannot be part of an object");
    }
  }

  void ReadJoint(int id) {
    model::Joint& joint = BodyOf(m_.jnt_bodyid[id]).joints.emplace_back();
    const int type = m_.jnt_type[id];
    joint.name = taken_.Name(mjOBJ_JOINT, id);
    joint.mark = file_.MarkOf(mjOBJ_JOINT, id);
    joint.type = compiled::kJointTypes[static_cast<std::size_t>(type)];
    joint.pos = VectorAt(m_.jnt_pos, id);
    joint.axis = VectorAt(m_.jnt_axis, id);
    if (m_.jnt_limited[id] != 0) {
      joint.range = Eigen::Vector2d(m_.jnt_range[2 * id], m_.jnt_range[2 * id + 1]);
    }
    const int dof = m_.jnt_dofadr[id];
    Attributes attributes(spec::JointElement(), joint.attributes);
    attributes.Number("group", m_.jnt_group[id], 0);
    attributes.Number("stiffness", m_.jnt_stiffness[id], 0);
    attributes.Number("damping", m_.dof_damping[dof], 0);
    attributes.Number("frictionloss", m_.dof_frictionloss[dof], 0);
    attributes.Number("armature", m_.dof_armature[dof], 0);
    if (type == mjJNT_SLIDE || type == mjJNT_HINGE) {
      const int address = m_.jnt_qposadr[id];
      attributes.Number("ref", m_.qpos0[address], 0);
      attributes.Number("springref", m_.qpos_spring[address], 0);
    }
    attributes.Number("margin", m_.jnt_margin[id], 0);
    attributes.Numbers("solreflimit", Row(m_.jnt_solref, id, mjNREF), kSolref);
    attributes.Numbers("solimplimit", Row(m_.jnt_solimp, id, mjNIMP), kSolimp);
    attributes.Numbers("solreffriction", Row(m_.dof_solref, dof, mjNREF), kSolref);
    attributes.Numbers("solimpfriction", Row(m_.dof_solimp, dof, mjNIMP), kSolimp);
    attributes.User(Row(m_.jnt_user, id, m_.nuser_jnt));
  }

  void ReadGeom(int id) {
    const std::optional<model::GeomType> type = compiled::GeomTypeOf(m_.geom_type[id]);
    if (!type) {
      const bool plane = m_.geom_type[id] == mjGEOM_PLANE;
      AddError(findings_, Code::kAttachNotCarried, file_.MarkOf(mjOBJ_GEOM, id),
               fmt::format("{} of '{}' is a {}, which cannot be part of an object",
                           file_.Description(mjOBJ_GEOM, id), file_.file().string(),
                           plane ? "plane" : "height field"),
               "planes and height fields belong to the world; attach a body without one");
      return;
    }
    model::Part& part = BodyOf(m_.geom_bodyid[id]).parts.emplace_back();
    part.name = taken_.Name(mjOBJ_GEOM, id);
    part.mark = file_.MarkOf(mjOBJ_GEOM, id);
    part.as_is = true;
    const bool collides = m_.geom_contype[id] != 0 || m_.geom_conaffinity[id] != 0;
    part.role = collides ? model::Role::kCollision : model::Role::kVisual;
    part.shape.type = *type;
    part.X_BG = PoseAt(m_.geom_pos, m_.geom_quat, id);
    if (*type == model::GeomType::kMesh) {
      const int mesh = m_.geom_dataid[id];
      part.mesh = assets_.Mesh(mesh);
      part.shape.mesh = &out_.meshes[static_cast<std::size_t>(part.mesh)]->mesh;
      part.X_BG = part.X_BG * assets_.FrameOf(mesh).Inverse();
    } else {
      for (int i = 0; i < model::SizeCount(*type); ++i) {
        part.shape.size[i] = m_.geom_size[3 * id + i];
      }
    }
    part.material = assets_.Material(m_.geom_matid[id]);
    ReadGeomAttributes(id, part);
  }

  void ReadGeomAttributes(int id, model::Part& part) {
    Attributes attributes(spec::PartElement(), part.attributes);
    attributes.Number("contype", m_.geom_contype[id], 1);
    attributes.Number("conaffinity", m_.geom_conaffinity[id], 1);
    attributes.Number("condim", m_.geom_condim[id], 3);
    attributes.Number("group", m_.geom_group[id], 0);
    attributes.Number("priority", m_.geom_priority[id], 0);
    attributes.Numbers("friction", Row(m_.geom_friction, id, 3), {1, 0.005, 0.0001});
    attributes.Number("solmix", m_.geom_solmix[id], 1);
    attributes.Numbers("solref", Row(m_.geom_solref, id, mjNREF), kSolref);
    attributes.Numbers("solimp", Row(m_.geom_solimp, id, mjNIMP), kSolimp);
    attributes.Number("margin", m_.geom_margin[id], 0);
    attributes.Number("gap", m_.geom_gap[id], 0);
    const std::span<const mjtNum> fluid = Row(m_.geom_fluid, id, mjNFLUID);
    if (fluid[0] > 0) {
      attributes.Text("fluidshape", "ellipsoid");
      attributes.Numbers("fluidcoef", fluid.subspan(1, 5), {0.5, 0.25, 1.5, 1, 1});
    }
    attributes.Numbers("rgba", Row(m_.geom_rgba, id, 4), {0.5, 0.5, 0.5, 1});
    attributes.User(Row(m_.geom_user, id, m_.nuser_geom));
  }

  void ReadSite(int id) {
    model::Site& site = BodyOf(m_.site_bodyid[id]).sites.emplace_back();
    site.name = taken_.Name(mjOBJ_SITE, id);
    site.mark = file_.MarkOf(mjOBJ_SITE, id);
    site.type = compiled::GeomTypeOf(m_.site_type[id]).value_or(model::GeomType::kSphere);
    site.size = VectorAt(m_.site_size, id);
    site.X_BS = PoseAt(m_.site_pos, m_.site_quat, id);
    site.material = assets_.Material(m_.site_matid[id]);
    Attributes attributes(spec::SiteElement(), site.attributes);
    attributes.Numbers("rgba", Row(m_.site_rgba, id, 4), {0.5, 0.5, 0.5, 1});
    attributes.Number("group", m_.site_group[id], 0);
    attributes.User(Row(m_.site_user, id, m_.nuser_site));
  }

  /// A camera or light that looks at a body; nothing if that is not taken.
  model::Element* Look(mjtObj kind, int id, int body, int mode, int target) {
    if (target >= 0 && !taken_.Has(mjOBJ_BODY, target)) {
      AddWarning(findings_, Code::kAttachNotCarried, file_.MarkOf(kind, id),
                 fmt::format("{} of '{}' is not carried over: its target, {}, is not attached",
                             file_.Description(kind, id), file_.file().string(),
                             file_.Description(mjOBJ_BODY, target)));
      taken_.LeaveBehind(kind, id);
      return nullptr;
    }
    const spec::ElementInfo& info = *spec::FindBodyChild(KindName(kind));
    model::Element& element = BodyOf(body).elements.emplace_back();
    element.tag = info.name;
    element.name = taken_.Name(kind, id);
    element.mark = file_.MarkOf(kind, id);
    Attributes attributes(info, element.attributes);
    if (mode != 0) attributes.Text("mode", std::string(kModes[static_cast<std::size_t>(mode)]));
    if (target >= 0) attributes.Text("target", taken_.Name(mjOBJ_BODY, target));
    return &element;
  }

  void ReadCamera(int id) {
    model::Element* element =
        Look(mjOBJ_CAMERA, id, m_.cam_bodyid[id], m_.cam_mode[id], m_.cam_targetbodyid[id]);
    if (element == nullptr) return;
    Attributes attributes(*spec::FindBodyChild("camera"), element->attributes);
    attributes.Numbers("pos", Row(m_.cam_pos, id, 3));
    attributes.Numbers("quat", Row(m_.cam_quat, id, 4), {1, 0, 0, 0});
    attributes.Number("fovy", m_.cam_fovy[id], 45);
    attributes.Number("ipd", m_.cam_ipd[id], 0.068);
    attributes.User(Row(m_.cam_user, id, m_.nuser_cam));
  }

  void ReadLight(int id) {
    model::Element* element =
        Look(mjOBJ_LIGHT, id, m_.light_bodyid[id], m_.light_mode[id], m_.light_targetbodyid[id]);
    if (element == nullptr) return;
    Attributes attributes(*spec::FindBodyChild("light"), element->attributes);
    attributes.Numbers("pos", Row(m_.light_pos, id, 3));
    attributes.Numbers("dir", Row(m_.light_dir, id, 3));
    attributes.Flag("directional", m_.light_directional[id] != 0, false);
    attributes.Flag("castshadow", m_.light_castshadow[id] != 0, true);
    attributes.Flag("active", m_.light_active[id] != 0, true);
    attributes.Numbers("attenuation", Row(m_.light_attenuation, id, 3), {1, 0, 0});
    attributes.Numbers("cutoff", Row(m_.light_cutoff, id, 1), {45});
    attributes.Numbers("exponent", Row(m_.light_exponent, id, 1), {10});
    attributes.Numbers("ambient", Row(m_.light_ambient, id, 3), {0, 0, 0});
    attributes.Numbers("diffuse", Row(m_.light_diffuse, id, 3), {0.7, 0.7, 0.7});
    attributes.Numbers("specular", Row(m_.light_specular, id, 3), {0.3, 0.3, 0.3});
  }

  const CompiledFile& file_;
  const mjModel& m_;
  Taken& taken_;
  AssetReader& assets_;
  model::Attachment& out_;
  diag::Findings& findings_;
};

}  // namespace

void ReadBodies(const CompiledFile& file, Taken& taken, AssetReader& assets, model::Attachment& out,
                diag::Findings& findings) {
  BodyReader(file, taken, assets, out, findings).Read();
}

}  // namespace mjforge::attach
