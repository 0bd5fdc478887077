// Reader of a variant's numbers from its compiled model: arrays of mjModel, materials, the start
// state and mesh vertices, each with the names of the elements.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "mjforge/compiled/compiled.h"
#include "mjforge/family/coincidences.h"
#include "mjforge/family/family.h"

namespace mjforge::family {
namespace {

using M = mjModel;
using compiled::Index;

// An array of mjModel, with one row per element, or one per number of an element: degree of freedom
// or coordinate of a joint, wrap of a tendon, number of a <numeric>, object of a <tuple>.
struct Field {
  enum class Rows { kElement, kDof, kQpos, kWrap, kNumeric, kTuple };

  std::string_view name;
  mjtObj kind;
  std::variant<mjtNum * M::*, float * M::*> array;
  std::uint64_t width = 1;
  Rows rows = Rows::kElement;
  engine::Count M::*user = nullptr;  // width of an array of user data
};

constexpr auto kDof = Field::Rows::kDof;
constexpr auto kQpos = Field::Rows::kQpos;
constexpr auto kOne = Field::Rows::kElement;
// From 2.3.1 on, the resting length of a tendon is a range.
constexpr std::uint64_t kSpringLengths = mjVERSION_HEADER < 231 ? 1 : 2;

constexpr Field kFields[] = {
    {"body_pos", mjOBJ_BODY, &M::body_pos, 3},
    {"body_quat", mjOBJ_BODY, &M::body_quat, 4},
    {"body_mass", mjOBJ_BODY, &M::body_mass},
    {"body_inertia", mjOBJ_BODY, &M::body_inertia, 3},
    {"body_ipos", mjOBJ_BODY, &M::body_ipos, 3},
    {"body_iquat", mjOBJ_BODY, &M::body_iquat, 4},
    {"body_user", mjOBJ_BODY, &M::body_user, 1, kOne, &M::nuser_body},
    {"geom_size", mjOBJ_GEOM, &M::geom_size, 3},
    {"geom_pos", mjOBJ_GEOM, &M::geom_pos, 3},
    {"geom_quat", mjOBJ_GEOM, &M::geom_quat, 4},
    {"geom_friction", mjOBJ_GEOM, &M::geom_friction, 3},
    {"geom_solmix", mjOBJ_GEOM, &M::geom_solmix},
    {"geom_solref", mjOBJ_GEOM, &M::geom_solref, mjNREF},
    {"geom_solimp", mjOBJ_GEOM, &M::geom_solimp, mjNIMP},
    {"geom_margin", mjOBJ_GEOM, &M::geom_margin},
    {"geom_gap", mjOBJ_GEOM, &M::geom_gap},
    {"geom_fluid", mjOBJ_GEOM, &M::geom_fluid, mjNFLUID},
    {"geom_rgba", mjOBJ_GEOM, &M::geom_rgba, 4},
    {"geom_user", mjOBJ_GEOM, &M::geom_user, 1, kOne, &M::nuser_geom},
    {"jnt_pos", mjOBJ_JOINT, &M::jnt_pos, 3},
    {"jnt_axis", mjOBJ_JOINT, &M::jnt_axis, 3},
    {"jnt_range", mjOBJ_JOINT, &M::jnt_range, 2},
    {"jnt_stiffness", mjOBJ_JOINT, &M::jnt_stiffness},
    {"jnt_margin", mjOBJ_JOINT, &M::jnt_margin},
    {"jnt_solref", mjOBJ_JOINT, &M::jnt_solref, mjNREF},
    {"jnt_solimp", mjOBJ_JOINT, &M::jnt_solimp, mjNIMP},
    {"jnt_user", mjOBJ_JOINT, &M::jnt_user, 1, kOne, &M::nuser_jnt},
    {"dof_damping", mjOBJ_JOINT, &M::dof_damping, 1, kDof},
    {"dof_frictionloss", mjOBJ_JOINT, &M::dof_frictionloss, 1, kDof},
    {"dof_armature", mjOBJ_JOINT, &M::dof_armature, 1, kDof},
    {"dof_solref", mjOBJ_JOINT, &M::dof_solref, mjNREF, kDof},
    {"dof_solimp", mjOBJ_JOINT, &M::dof_solimp, mjNIMP, kDof},
    {"qpos0", mjOBJ_JOINT, &M::qpos0, 1, kQpos},
    {"qpos_spring", mjOBJ_JOINT, &M::qpos_spring, 1, kQpos},
    {"site_size", mjOBJ_SITE, &M::site_size, 3},
    {"site_pos", mjOBJ_SITE, &M::site_pos, 3},
    {"site_quat", mjOBJ_SITE, &M::site_quat, 4},
    {"site_rgba", mjOBJ_SITE, &M::site_rgba, 4},
    {"site_user", mjOBJ_SITE, &M::site_user, 1, kOne, &M::nuser_site},
    {"cam_pos", mjOBJ_CAMERA, &M::cam_pos, 3},
    {"cam_quat", mjOBJ_CAMERA, &M::cam_quat, 4},
    {"cam_fovy", mjOBJ_CAMERA, &M::cam_fovy},
    {"cam_ipd", mjOBJ_CAMERA, &M::cam_ipd},
    {"cam_user", mjOBJ_CAMERA, &M::cam_user, 1, kOne, &M::nuser_cam},
    {"light_pos", mjOBJ_LIGHT, &M::light_pos, 3},
    {"light_dir", mjOBJ_LIGHT, &M::light_dir, 3},
    {"light_attenuation", mjOBJ_LIGHT, &M::light_attenuation, 3},
    {"light_cutoff", mjOBJ_LIGHT, &M::light_cutoff},
    {"light_exponent", mjOBJ_LIGHT, &M::light_exponent},
    {"light_ambient", mjOBJ_LIGHT, &M::light_ambient, 3},
    {"light_diffuse", mjOBJ_LIGHT, &M::light_diffuse, 3},
    {"light_specular", mjOBJ_LIGHT, &M::light_specular, 3},
    {"pair_friction", mjOBJ_PAIR, &M::pair_friction, 5},
    {"pair_solref", mjOBJ_PAIR, &M::pair_solref, mjNREF},
    {"pair_solimp", mjOBJ_PAIR, &M::pair_solimp, mjNIMP},
    {"pair_margin", mjOBJ_PAIR, &M::pair_margin},
    {"pair_gap", mjOBJ_PAIR, &M::pair_gap},
    {"eq_data", mjOBJ_EQUALITY, &M::eq_data, mjNEQDATA},
    {"eq_solref", mjOBJ_EQUALITY, &M::eq_solref, mjNREF},
    {"eq_solimp", mjOBJ_EQUALITY, &M::eq_solimp, mjNIMP},
    {"tendon_range", mjOBJ_TENDON, &M::tendon_range, 2},
    {"tendon_margin", mjOBJ_TENDON, &M::tendon_margin},
    {"tendon_stiffness", mjOBJ_TENDON, &M::tendon_stiffness},
    {"tendon_damping", mjOBJ_TENDON, &M::tendon_damping},
    {"tendon_frictionloss", mjOBJ_TENDON, &M::tendon_frictionloss},
    {"tendon_lengthspring", mjOBJ_TENDON, &M::tendon_lengthspring, kSpringLengths},
    {"tendon_solref_lim", mjOBJ_TENDON, &M::tendon_solref_lim, mjNREF},
    {"tendon_solimp_lim", mjOBJ_TENDON, &M::tendon_solimp_lim, mjNIMP},
    {"tendon_solref_fri", mjOBJ_TENDON, &M::tendon_solref_fri, mjNREF},
    {"tendon_solimp_fri", mjOBJ_TENDON, &M::tendon_solimp_fri, mjNIMP},
    {"tendon_width", mjOBJ_TENDON, &M::tendon_width},
    {"tendon_rgba", mjOBJ_TENDON, &M::tendon_rgba, 4},
    {"tendon_user", mjOBJ_TENDON, &M::tendon_user, 1, kOne, &M::nuser_tendon},
    {"wrap_prm", mjOBJ_TENDON, &M::wrap_prm, 1, Field::Rows::kWrap},
    {"actuator_dynprm", mjOBJ_ACTUATOR, &M::actuator_dynprm, mjNDYN},
    {"actuator_gainprm", mjOBJ_ACTUATOR, &M::actuator_gainprm, mjNGAIN},
    {"actuator_biasprm", mjOBJ_ACTUATOR, &M::actuator_biasprm, mjNBIAS},
    {"actuator_ctrlrange", mjOBJ_ACTUATOR, &M::actuator_ctrlrange, 2},
    {"actuator_forcerange", mjOBJ_ACTUATOR, &M::actuator_forcerange, 2},
    {"actuator_actrange", mjOBJ_ACTUATOR, &M::actuator_actrange, 2},
    {"actuator_gear", mjOBJ_ACTUATOR, &M::actuator_gear, 6},
    {"actuator_cranklength", mjOBJ_ACTUATOR, &M::actuator_cranklength},
    {"actuator_lengthrange", mjOBJ_ACTUATOR, &M::actuator_lengthrange, 2},
    {"actuator_user", mjOBJ_ACTUATOR, &M::actuator_user, 1, kOne, &M::nuser_actuator},
    {"sensor_cutoff", mjOBJ_SENSOR, &M::sensor_cutoff},
    {"sensor_noise", mjOBJ_SENSOR, &M::sensor_noise},
    {"sensor_user", mjOBJ_SENSOR, &M::sensor_user, 1, kOne, &M::nuser_sensor},
    {"numeric_data", mjOBJ_NUMERIC, &M::numeric_data, 1, Field::Rows::kNumeric},
    {"tuple_objprm", mjOBJ_TUPLE, &M::tuple_objprm, 1, Field::Rows::kTuple}};

class Reader {
 public:
  Reader(const mjModel& m, const model::Object& object) : m_(m), object_(object) {}

  Numbers operator()() {
    for (const Field& field : kFields) AddField(field);
    PlaceMeshes();
    AddMaterialIds("geom_matid", mjOBJ_GEOM, m_.geom_matid);
    AddMaterialIds("site_matid", mjOBJ_SITE, m_.site_matid);
    AddMaterialIds("tendon_matid", mjOBJ_TENDON, m_.tendon_matid);
    AddOptions();
    AddStart();
    AddVertices();
    AddCoincidences(m_, numbers_);
    return std::move(numbers_);
  }

 private:
  void AddField(const Field& field) {
    const std::uint64_t width =
        field.user == nullptr ? field.width : static_cast<std::uint64_t>(m_.*field.user);
    if (width == 0) return;
    ArrayShape& shape = Open(std::string(field.name));
    NameRows(field, shape);
    shape.dims = {shape.elements.size()};
    if (width > 1) shape.dims.push_back(width);
    const std::uint64_t first = field.kind == mjOBJ_BODY ? width : 0;
    const std::uint64_t count = shape.size();
    std::visit(
        [&](auto array) {
          const auto* from = (m_.*array) + first;
          numbers_.values.insert(numbers_.values.end(), from, from + count);
        },
        field.array);
  }

  ArrayShape& Open(std::string name) {
    ArrayShape& shape = numbers_.shapes.emplace_back();
    shape.name = std::move(name);
    return shape;
  }

  // Sets the name of the element to which each row of the array belongs. The world body has no row.
  void NameRows(const Field& field, ArrayShape& shape) const {
    const int count = ElementCount(m_, field.kind);
    for (int id = field.kind == mjOBJ_BODY ? 1 : 0; id < count; ++id) {
      const std::string name = ElementName(m_, field.kind, id);
      if (field.rows == Field::Rows::kElement) {
        shape.elements.push_back(name);
        continue;
      }
      for (std::uint64_t i = 0; i < NumbersOf(id, field.rows); ++i) {
        shape.elements.push_back(name);
        shape.components.push_back(i);
      }
    }
  }

  // Returns the number of rows of an element.
  std::uint64_t NumbersOf(int id, Field::Rows rows) const {
    if (rows == Field::Rows::kWrap) return static_cast<std::uint64_t>(m_.tendon_num[id]);
    if (rows == Field::Rows::kNumeric) return static_cast<std::uint64_t>(m_.numeric_size[id]);
    if (rows == Field::Rows::kTuple) return static_cast<std::uint64_t>(m_.tuple_size[id]);
    const bool is_last = id + 1 == m_.njnt;
    const int* first = rows == kDof ? m_.jnt_dofadr : m_.jnt_qposadr;
    const auto all = static_cast<int>(rows == kDof ? m_.nv : m_.nq);
    return static_cast<std::uint64_t>((is_last ? all : first[id + 1]) - first[id]);
  }

  double* ArrayAt(std::string_view name) { return &numbers_.values[numbers_.Find(name).second]; }

  // Replaces the poses of mesh geoms by their poses in MJCF, because releases of MuJoCo choose
  // different frames for a mesh. Sets their sizes to 0, because the vertices determine the sizes.
  void PlaceMeshes() {
    if (m_.ngeom == 0) return;
    double* const size = ArrayAt("geom_size");
    double* const pos = ArrayAt("geom_pos");
    double* const quat = ArrayAt("geom_quat");
    std::size_t id = Index(m_.body_geomnum[0]);  // geoms of the world come first
    for (const int i : mjcf::DepthFirstOrder(object_)) {
      for (const model::Part& part : object_.bodies[Index(i)].parts) {
        const bool has_two = part.role == model::Role::kBoth && !part.as_is;
        for (const std::size_t end = id + (has_two ? 2 : 1); id < end; ++id) {
          if (part.shape.type != model::GeomType::kMesh) continue;
          std::fill_n(size + 3 * id, 3, 0.0);
          compiled::WritePose(part.X_BG, pos + 3 * id, quat + 4 * id);
        }
      }
    }
  }

  void AddMaterialIds(std::string name, mjtObj kind, const int* ids) {
    ArrayShape& shape = Open(std::move(name));
    shape.type = ArrayShape::Type::kMaterial;
    const int count = ElementCount(m_, kind);
    for (int id = 0; id < count; ++id) shape.elements.push_back(ElementName(m_, kind, id));
    shape.dims = {shape.elements.size()};
    numbers_.values.insert(numbers_.values.end(), ids, ids + count);
  }

  void AddWhole(std::string name, std::vector<std::uint64_t> dims, const mjtNum* first) {
    ArrayShape& shape = Open(std::move(name));
    shape.dims = std::move(dims);
    numbers_.values.insert(numbers_.values.end(), first, first + shape.size());
  }

  void AddOptions() {
    const mjOption& option = m_.opt;
    AddWhole("opt_timestep", {}, &option.timestep);
    AddWhole("opt_impratio", {}, &option.impratio);
    AddWhole("opt_density", {}, &option.density);
    AddWhole("opt_viscosity", {}, &option.viscosity);
    AddWhole("opt_gravity", {3}, option.gravity);
    AddWhole("opt_wind", {3}, option.wind);
    AddWhole("opt_magnetic", {3}, option.magnetic);
    AddWhole("opt_tolerance", {}, &option.tolerance);
    AddWhole("opt_noslip_tolerance", {}, &option.noslip_tolerance);
    AddWhole("opt_o_margin", {}, &option.o_margin);
    AddWhole("opt_o_solref", {mjNREF}, option.o_solref);
    AddWhole("opt_o_solimp", {mjNIMP}, option.o_solimp);
  }

  // Adds the start state: the state of the keyframe or, without a keyframe, qpos0 and zeros.
  void AddStart() {
    const std::span<const mjtNum> qpos = compiled::StartOf(m_);
    const bool has_key = qpos.data() != m_.qpos0;
    const std::ptrdiff_t key = has_key && m_.nq > 0 ? (qpos.data() - m_.key_qpos) / m_.nq : 0;
    const auto add = [&](const std::string& name, auto count, const mjtNum* keys) {
      const std::vector<mjtNum> zeros(static_cast<std::size_t>(count));
      AddWhole(name, {zeros.size()}, has_key ? keys + key * count : zeros.data());
    };
    AddWhole("start_qpos", {qpos.size()}, qpos.data());
    add("start_qvel", m_.nv, m_.key_qvel);
    add("start_act", m_.na, m_.key_act);
    add("start_ctrl", m_.nu, m_.key_ctrl);
  }

  // Adds the vertices, in m, of meshes that are not from files, rounded as in MJCF. For a mesh from
  // a file, adds only the scale, because MuJoCo determines the order of the vertices.
  void AddVertices() {
    for (const auto& asset : object_.meshes) {
      if (!asset->file.empty()) {
        AddWhole("mesh_scale/" + asset->name, {3}, asset->scale.data());
        continue;
      }
      const model::TriangleMesh& mesh = asset->mesh;
      ArrayShape& shape = Open("mesh_vert/" + asset->name);
      shape.dims = {mesh.vertices.size(), 3};
      for (const Eigen::Vector3d& vertex : mesh.vertices) {
        for (const double x : vertex) {
          numbers_.values.push_back(mesh.in_micrometres ? 1e-6 * std::round(1e6 * x) : x);
        }
      }
    }
  }

  const mjModel& m_;
  const model::Object& object_;
  Numbers numbers_;
};

// Returns the first line that contains `start`, the beginning of an element, with the line end;
// empty if there is no such line.
std::string LineWith(std::string_view text, const std::string& start) {
  const std::size_t at = text.find(start);
  if (at == text.npos) return {};
  const std::size_t begin = text.rfind('\n', at) + 1;
  return std::string(text.substr(begin, text.find('\n', at) + 1 - begin));
}

// Returns the value of an attribute in an element's text; empty if the attribute is missing.
std::string_view AttributeIn(std::string_view element, std::string_view name) {
  const std::string start = ' ' + std::string(name) + "=\"";
  const std::size_t at = element.find(start);
  if (at == element.npos) return {};
  element.remove_prefix(at + start.size());
  return element.substr(0, element.find('"'));
}

std::vector<Material> MaterialsOf(const mjModel& m, std::string_view text) {
  std::vector<Material> materials;
  const std::string_view assets = text.substr(0, text.find("<worldbody>"));
  std::size_t at = 0;
  for (int id = 0; id < m.nmat; ++id) {
    Material& material = materials.emplace_back();
    material.name = m.names + m.name_matadr[id];
    at = assets.find("<material ", at);
    const std::string line = LineWith(assets.substr(at), "<material ");
    const std::string_view texture = AttributeIn(line, "texture");
    if (!texture.empty())
      material.elements = LineWith(assets, "<texture name=\"" + std::string(texture) + '"');
    material.elements += "    " + line;
    at += line.size();
    double* out = material.numbers.data();
    const auto add = [&](const float* from, int count) {
      out = std::copy_n(from + count * id, count, out);
    };
    add(m.mat_rgba, 4);
    add(m.mat_emission, 1);
    add(m.mat_specular, 1);
    add(m.mat_shininess, 1);
    add(m.mat_reflectance, 1);
    add(m.mat_texrepeat, 2);
  }
  return materials;
}

}  // namespace

std::uint64_t ArrayShape::size() const {
  std::uint64_t size = 1;
  for (const std::uint64_t count : dims) size *= count;
  return size;
}

std::pair<const ArrayShape&, std::size_t> Layout::Find(std::string_view array) const {
  std::size_t at = 0;
  for (const ArrayShape& shape : shapes) {
    if (shape.name == array) return {shape, at};
    at += shape.size();
  }
  throw std::runtime_error("it has no " + std::string(array));
}

std::span<const double> Layout::NumbersOf(std::string_view array, std::size_t element,
                                          std::span<const double> values) const {
  const auto& [shape, at] = Find(array);
  return values.subspan(at + shape.width() * element, shape.width());
}

void Numbers::Add(std::string name, std::vector<std::uint64_t> dims,
                  std::span<const double> numbers, ArrayShape::Type type) {
  ArrayShape& shape = shapes.emplace_back();
  shape.name = std::move(name);
  shape.dims = std::move(dims);
  shape.type = type;
  shape.is_always_stored = true;
  values.insert(values.end(), numbers.begin(), numbers.end());
}

int ElementCount(const mjModel& m, mjtObj kind) {
  constexpr std::pair<mjtObj, engine::Count M::*> kCounts[] = {
      {mjOBJ_BODY, &M::nbody},  {mjOBJ_JOINT, &M::njnt},     {mjOBJ_GEOM, &M::ngeom},
      {mjOBJ_SITE, &M::nsite},  {mjOBJ_CAMERA, &M::ncam},    {mjOBJ_LIGHT, &M::nlight},
      {mjOBJ_PAIR, &M::npair},  {mjOBJ_EQUALITY, &M::neq},   {mjOBJ_TENDON, &M::ntendon},
      {mjOBJ_ACTUATOR, &M::nu}, {mjOBJ_SENSOR, &M::nsensor}, {mjOBJ_NUMERIC, &M::nnumeric},
      {mjOBJ_TUPLE, &M::ntuple}};
  const auto* count =
      std::ranges::find(kCounts, kind, [](const auto& known) { return known.first; });
  return static_cast<int>(m.*count->second);
}

std::string ElementName(const mjModel& m, mjtObj kind, int id) {
  const char* name = mj_id2name(&m, kind, id);
  return name == nullptr ? std::string() : name;
}

Numbers Read(const mjModel_& m, const model::Object& object, const mjcf::MjcfDocument& document) {
  Numbers numbers = Reader(m, object)();
  numbers.structure = structure::StructureOf(m, object.name);
  numbers.materials = MaterialsOf(m, document.text);
  return numbers;
}

}  // namespace mjforge::family
