// Comparison of an attached body with the compiled model of its own file, number by number.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "attached_file.h"
#include "mjforge/engine/engine.h"

namespace mjforge::attach {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Tolerance: generated MJCF has 10 significant digits; angles and lengths are of order 1.
constexpr double kRelative = 1e-9;

class Comparison {
 public:
  Comparison(const mjModel& own, const mjModel& object) : own_(own), object_(object) {}

  int Run(int root) {
    // The root of the object is body 1, the attached body is body 2. Both models have their bodies
    // in depth-first order.
    bodies_ = {root};
    for (int body = root + 1; body < own_.nbody; ++body) {
      if (std::ranges::find(bodies_, own_.body_parentid[body]) != bodies_.end()) {
        bodies_.push_back(body);
      }
    }
    REQUIRE(object_.nbody == static_cast<int>(bodies_.size()) + 2);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Body(bodies_[i], static_cast<int>(i) + 2, i == 0);
    }
    Elements();
    return count_;
  }

 private:
  template <typename T>
  void Same(const char* what, const T* own, int i, const T* object, int j, int width = 1,
            double scale = 0) {
    for (int k = 0; k < width; ++k) {
      const auto a = static_cast<double>(own[width * i + k]);
      const auto b = static_cast<double>(object[width * j + k]);
      ++count_;
      if (std::abs(a - b) <= kRelative * std::max({scale, std::abs(a), 1e-6})) continue;
      INFO(what << "[" << k << "]");
      CHECK(b == a);
    }
  }

  void Rotation(const char* what, const mjtNum* own, const mjtNum* object) {
    const Matrix3d difference = Axes(own) - Axes(object);
    ++count_;
    if (difference.norm() <= 1e-8) return;
    INFO(what);
    CHECK(difference.norm() <= 1e-8);
  }

  static Matrix3d Axes(const mjtNum* q) {
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  }

  static Matrix3d Tensor(const mjModel& m, int body) {
    const Matrix3d axes = Axes(m.body_iquat + 4 * body);
    return axes * Vector3d(Eigen::Map<const Vector3d>(m.body_inertia + 3 * body)).asDiagonal() *
           axes.transpose();
  }

#define MJFORGE_SAME(array, width) Same(#array, own_.array, i, object_.array, j, width)

  void Body(int i, int j, bool is_root) {
    INFO("body " << own_.names + own_.name_bodyadr[i]);
    MJFORGE_SAME(body_mass, 1);
    Same("ipos", own_.body_ipos, i, object_.body_ipos, j, 3, 1);
    const Matrix3d own_tensor = Tensor(own_, i);
    const double largest = own_tensor.trace();
    CHECK((own_tensor - Tensor(object_, j)).norm() <= 1e-8 * largest);
    if (!is_root) {
      Same("pos", own_.body_pos, i, object_.body_pos, j, 3, 1);
      Rotation("quat", own_.body_quat + 4 * i, object_.body_quat + 4 * j);
      Joints(i, j);
    } else {
      CHECK(object_.body_jntnum[j] == 0);
    }
    Geoms(i, j);
    const std::vector<int> own = Of(own_.site_bodyid, own_.nsite, i);
    const std::vector<int> object = Of(object_.site_bodyid, object_.nsite, j);
    REQUIRE(object.size() == own.size());
    for (std::size_t k = 0; k < own.size(); ++k) Site(own[k], object[k]);
  }

  static std::vector<int> Of(const int* owners, int count, int body) {
    std::vector<int> ids;
    for (int id = 0; id < count; ++id) {
      if (owners[id] == body) ids.push_back(id);
    }
    return ids;
  }

  void Joints(int body, int other) {
    REQUIRE(object_.body_jntnum[other] == own_.body_jntnum[body]);
    for (int k = 0; k < own_.body_jntnum[body]; ++k) {
      Joint(own_.body_jntadr[body] + k, object_.body_jntadr[other] + k);
    }
  }

  void Joint(int i, int j) {
    INFO("joint " << own_.names + own_.name_jntadr[i]);
    MJFORGE_SAME(jnt_type, 1);
    MJFORGE_SAME(jnt_limited, 1);
    if (own_.jnt_limited[i] != 0) MJFORGE_SAME(jnt_range, 2);
    Same("pos", own_.jnt_pos, i, object_.jnt_pos, j, 3, 1);
    Same("axis", own_.jnt_axis, i, object_.jnt_axis, j, 3, 1);
    MJFORGE_SAME(jnt_stiffness, 1);
    MJFORGE_SAME(jnt_margin, 1);
    MJFORGE_SAME(jnt_group, 1);
    MJFORGE_SAME(jnt_solref, mjNREF);
    MJFORGE_SAME(jnt_solimp, mjNIMP);
    Same("ref", own_.qpos0, own_.jnt_qposadr[i], object_.qpos0, object_.jnt_qposadr[j]);
    Same("springref", own_.qpos_spring, own_.jnt_qposadr[i], object_.qpos_spring,
         object_.jnt_qposadr[j]);
    i = own_.jnt_dofadr[i];
    j = object_.jnt_dofadr[j];
    MJFORGE_SAME(dof_damping, 1);
    MJFORGE_SAME(dof_armature, 1);
    MJFORGE_SAME(dof_frictionloss, 1);
    MJFORGE_SAME(dof_solref, mjNREF);
    MJFORGE_SAME(dof_solimp, mjNIMP);
  }

  void Geoms(int body, int other) {
    REQUIRE(object_.body_geomnum[other] == own_.body_geomnum[body]);
    for (int k = 0; k < own_.body_geomnum[body]; ++k) {
      Geom(own_.body_geomadr[body] + k, object_.body_geomadr[other] + k);
    }
  }

  void Geom(int i, int j) {
    INFO("geom " << own_.names + own_.name_geomadr[i] << " of type " << own_.geom_type[i]);
    MJFORGE_SAME(geom_type, 1);
    if (own_.geom_type[i] == mjGEOM_MESH) {
      Mesh(i, j);
    } else {
      for (int k = 0; k < SizeCount(own_.geom_type[i]); ++k) {
        Same("size", own_.geom_size, 3 * i + k, object_.geom_size, 3 * j + k);
      }
      Same("pos", own_.geom_pos, i, object_.geom_pos, j, 3, 1);
      Rotation("quat", own_.geom_quat + 4 * i, object_.geom_quat + 4 * j);
    }
    MJFORGE_SAME(geom_contype, 1);
    MJFORGE_SAME(geom_conaffinity, 1);
    MJFORGE_SAME(geom_condim, 1);
    MJFORGE_SAME(geom_friction, 3);
    MJFORGE_SAME(geom_group, 1);
    MJFORGE_SAME(geom_priority, 1);
    MJFORGE_SAME(geom_solmix, 1);
    MJFORGE_SAME(geom_solref, mjNREF);
    MJFORGE_SAME(geom_solimp, mjNIMP);
    MJFORGE_SAME(geom_margin, 1);
    MJFORGE_SAME(geom_gap, 1);
    MJFORGE_SAME(geom_rgba, 4);
    MJFORGE_SAME(geom_fluid, mjNFLUID);
    REQUIRE((own_.geom_matid[i] < 0) == (object_.geom_matid[j] < 0));
    if (own_.geom_matid[i] < 0) return;
    i = own_.geom_matid[i];
    j = object_.geom_matid[j];
    MJFORGE_SAME(mat_rgba, 4);
    MJFORGE_SAME(mat_specular, 1);
    MJFORGE_SAME(mat_shininess, 1);
    MJFORGE_SAME(mat_reflectance, 1);
    MJFORGE_SAME(mat_emission, 1);
    MJFORGE_SAME(mat_texrepeat, 2);
    MJFORGE_SAME(mat_texuniform, 1);
    Texture(engine::TextureOf(own_, i), engine::TextureOf(object_, j));
  }

  void Texture(int i, int j) {
    REQUIRE((i < 0) == (j < 0));
    if (i < 0) return;
    MJFORGE_SAME(tex_type, 1);
    MJFORGE_SAME(tex_width, 1);
    MJFORGE_SAME(tex_height, 1);
    CHECK(std::ranges::equal(engine::PixelsOf(own_, i), engine::PixelsOf(object_, j)));
  }

  // Compares the positions of vertices in the frame of the body, because the frame of the mesh may
  // differ. MuJoCo stores vertices in single precision.
  void Mesh(int i, int j) {
    const int own = own_.geom_dataid[i];
    const int object = object_.geom_dataid[j];
    REQUIRE(object_.mesh_vertnum[object] == own_.mesh_vertnum[own]);
    REQUIRE(object_.mesh_facenum[object] == own_.mesh_facenum[own]);
    double worst = 0;
    for (int k = 0; k < own_.mesh_vertnum[own]; ++k) {
      const Vector3d difference = Vertex(own_, i, own, k) - Vertex(object_, j, object, k);
      worst = std::max(worst, difference.norm());
      ++count_;
    }
    const Vector3d size(own_.geom_size[3 * i], own_.geom_size[3 * i + 1],
                        own_.geom_size[3 * i + 2]);
    CHECK(worst <= 1e-6 * size.norm());
  }

  static Vector3d Vertex(const mjModel& m, int geom, int mesh, int k) {
    const float* v = m.mesh_vert + 3 * (m.mesh_vertadr[mesh] + k);
    return Axes(m.geom_quat + 4 * geom) * Vector3d(v[0], v[1], v[2]) +
           Vector3d(Eigen::Map<const Vector3d>(m.geom_pos + 3 * geom));
  }

  // Returns the number of sizes that a type uses; MuJoCo keeps unused ones.
  static int SizeCount(int type) {
    if (type == mjGEOM_SPHERE) return 1;
    return type == mjGEOM_CAPSULE || type == mjGEOM_CYLINDER ? 2 : 3;
  }

  void Site(int i, int j) {
    INFO("site " << own_.names + own_.name_siteadr[i]);
    MJFORGE_SAME(site_type, 1);
    for (int k = 0; k < SizeCount(own_.site_type[i]); ++k) {
      Same("size", own_.site_size, 3 * i + k, object_.site_size, 3 * j + k);
    }
    Same("pos", own_.site_pos, i, object_.site_pos, j, 3, 1);
    Rotation("quat", own_.site_quat + 4 * i, object_.site_quat + 4 * j);
    MJFORGE_SAME(site_group, 1);
    MJFORGE_SAME(site_rgba, 4);
  }

  // Calls `compare(i, j)` for each pair of elements of a kind with the same name in both models.
  template <typename Function>
  void ByName(mjtObj kind, int count, const Function& compare) {
    const std::string prefix = "zoo_it_";
    for (int j = 0; j < count; ++j) {
      const char* text = mj_id2name(&object_, kind, j);
      const std::string name = text == nullptr ? "" : text;
      if (!name.starts_with(prefix)) continue;
      const int i = mj_name2id(&own_, kind, name.substr(prefix.size()).c_str());
      if (i < 0) continue;
      INFO(mju_type2Str(kind) << " " << name);
      compare(i, j);
    }
  }

  void Elements() {
    ByName(mjOBJ_CAMERA, object_.ncam, [&](int i, int j) {
      MJFORGE_SAME(cam_mode, 1);
      MJFORGE_SAME(cam_fovy, 1);
      MJFORGE_SAME(cam_ipd, 1);
      MJFORGE_SAME(cam_pos, 3);
      Rotation("quat", own_.cam_quat + 4 * i, object_.cam_quat + 4 * j);
    });
    ByName(mjOBJ_LIGHT, object_.nlight, [&](int i, int j) {
      MJFORGE_SAME(light_mode, 1);
      CHECK((own_.*engine::kLightDirectional)[i] == (object_.*engine::kLightDirectional)[j]);
      MJFORGE_SAME(light_castshadow, 1);
      MJFORGE_SAME(light_active, 1);
      MJFORGE_SAME(light_pos, 3);
      MJFORGE_SAME(light_dir, 3);
      MJFORGE_SAME(light_attenuation, 3);
      MJFORGE_SAME(light_cutoff, 1);
      MJFORGE_SAME(light_exponent, 1);
      MJFORGE_SAME(light_ambient, 3);
      MJFORGE_SAME(light_diffuse, 3);
      MJFORGE_SAME(light_specular, 3);
    });
    Contacts();
    Constraints();
    Actuators();
  }

  void Contacts() {
    ByName(mjOBJ_PAIR, object_.npair, [&](int i, int j) {
      MJFORGE_SAME(pair_dim, 1);
      MJFORGE_SAME(pair_friction, 5);
      MJFORGE_SAME(pair_solref, mjNREF);
      MJFORGE_SAME(pair_solimp, mjNIMP);
      MJFORGE_SAME(pair_margin, 1);
      MJFORGE_SAME(pair_gap, 1);
    });
  }

  void Constraints() {
    ByName(mjOBJ_EQUALITY, object_.neq, [&](int i, int j) {
      MJFORGE_SAME(eq_type, 1);
      CHECK((own_.*engine::kEqualityActive)[i] == (object_.*engine::kEqualityActive)[j]);
      // Releases after 2.2 have more numbers, which MJCF for 2.2 cannot express.
      for (int k = 0; k < 11; ++k)
        Same("data", own_.eq_data, mjNEQDATA * i + k, object_.eq_data, mjNEQDATA * j + k, 1, 1);
      MJFORGE_SAME(eq_solref, mjNREF);
      MJFORGE_SAME(eq_solimp, mjNIMP);
    });
    ByName(mjOBJ_TENDON, object_.ntendon, [&](int i, int j) {
      MJFORGE_SAME(tendon_num, 1);
      MJFORGE_SAME(tendon_group, 1);
      MJFORGE_SAME(tendon_limited, 1);
      if (own_.tendon_limited[i] != 0) MJFORGE_SAME(tendon_range, 2);
      MJFORGE_SAME(tendon_solref_lim, mjNREF);
      MJFORGE_SAME(tendon_solimp_lim, mjNIMP);
      MJFORGE_SAME(tendon_solref_fri, mjNREF);
      MJFORGE_SAME(tendon_solimp_fri, mjNIMP);
      MJFORGE_SAME(tendon_margin, 1);
      MJFORGE_SAME(tendon_stiffness, 1);
      MJFORGE_SAME(tendon_damping, 1);
      MJFORGE_SAME(tendon_frictionloss, 1);
      MJFORGE_SAME(tendon_lengthspring, 1);
      MJFORGE_SAME(tendon_length0, 1);
      if (own_.wrap_type[own_.tendon_adr[i]] !=
          mjWRAP_JOINT) {  // tendons of joints are not rendered
        MJFORGE_SAME(tendon_width, 1);
        MJFORGE_SAME(tendon_rgba, 4);
      }
      for (int k = 0; k < own_.tendon_num[i]; ++k) {
        CHECK(own_.wrap_type[own_.tendon_adr[i] + k] ==
              object_.wrap_type[object_.tendon_adr[j] + k]);
      }
    });
  }

  void Actuators() {
    ByName(mjOBJ_ACTUATOR, object_.nu, [&](int i, int j) {
      MJFORGE_SAME(actuator_trntype, 1);
      MJFORGE_SAME(actuator_dyntype, 1);
      MJFORGE_SAME(actuator_gaintype, 1);
      MJFORGE_SAME(actuator_biastype, 1);
      MJFORGE_SAME(actuator_dynprm, mjNDYN);
      MJFORGE_SAME(actuator_gainprm, mjNGAIN);
      MJFORGE_SAME(actuator_biasprm, mjNBIAS);
      MJFORGE_SAME(actuator_group, 1);
      MJFORGE_SAME(actuator_ctrllimited, 1);
      MJFORGE_SAME(actuator_forcelimited, 1);
      MJFORGE_SAME(actuator_actlimited, 1);
      if (own_.actuator_ctrllimited[i] != 0) MJFORGE_SAME(actuator_ctrlrange, 2);
      if (own_.actuator_forcelimited[i] != 0) MJFORGE_SAME(actuator_forcerange, 2);
      if (own_.actuator_actlimited[i] != 0) MJFORGE_SAME(actuator_actrange, 2);
      MJFORGE_SAME(actuator_gear, 6);
      MJFORGE_SAME(actuator_cranklength, 1);
      MJFORGE_SAME(actuator_lengthrange, 2);
    });
    ByName(mjOBJ_SENSOR, object_.nsensor, [&](int i, int j) {
      MJFORGE_SAME(sensor_type, 1);
      MJFORGE_SAME(sensor_datatype, 1);
      MJFORGE_SAME(sensor_needstage, 1);
      MJFORGE_SAME(sensor_objtype, 1);
      MJFORGE_SAME(sensor_reftype, 1);
      MJFORGE_SAME(sensor_dim, 1);
      MJFORGE_SAME(sensor_cutoff, 1);
      MJFORGE_SAME(sensor_noise, 1);
    });
  }

#undef MJFORGE_SAME

  const mjModel& own_;
  const mjModel& object_;
  std::vector<int> bodies_;
  int count_ = 0;
};

}  // namespace

int CompareAttached(const mjModel& own, int body, const mjModel& object) {
  return Comparison(own, object).Run(body);
}

}  // namespace mjforge::attach
