// Tables of the kinds of elements and of the fields that make up a structure.
#include "mjforge/structure/tables.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "mjforge/structure/frames.h"

namespace mjforge::structure {
namespace {

using Model = const mjModel&;

// Returns an integer or flag of element `i` from an array of mjModel.
template <auto array, int width = 1, int column = 0>
int At(Model m, int i) {
  return static_cast<int>((m.*array)[width * i + column]);
}

// Returns 1 if a number of element `i` is positive, otherwise 0. Engines detect friction loss,
// springs and dampers by this condition.
template <auto array>
int IsPositive(Model m, int i) {
  return (m.*array)[i] > 0 ? 1 : 0;
}

template <auto count>
int CountOf(Model m, int /*element*/) {
  return static_cast<int>(m.*count);
}

template <auto option>
int Option(Model m, int /*element*/) {
  return static_cast<int>(m.opt.*option);
}

int EnableFlags(Model m, int /*element*/) { return engine::EnableFlags(m.opt); }

int HasFluid(Model m, int /*element*/) {
  const bool has_wind = std::ranges::any_of(m.opt.wind, [](mjtNum speed) { return speed != 0; });
  return has_wind || m.opt.density > 0 || m.opt.viscosity > 0 ? 1 : 0;
}

// Returns 0 or 1, as in MuJoCo 2.2.2; later releases also have 2 (all joints are slides).
int BodyIsSimple(Model m, int i) { return m.body_simple[i] != 0 ? 1 : 0; }

int BodySameFrame(Model m, int i) { return i == 0 ? kBody : SameFrameOfBody(m, i); }

// Returns kNone for a mesh, because releases of MuJoCo choose different frames for meshes.
int GeomSameFrame(Model m, int i) {
  if (m.geom_type[i] == mjGEOM_MESH) return kNone;
  return SameFrameOf(m, m.geom_bodyid[i], m.geom_pos + 3L * i, m.geom_quat + 4L * i);
}

int SiteSameFrame(Model m, int i) {
  return SameFrameOf(m, m.site_bodyid[i], m.site_pos + 3L * i, m.site_quat + 4L * i);
}

int HasFluidShape(Model m, int i) { return m.geom_fluid[mjNFLUID * i] > 0 ? 1 : 0; }

template <bool second>
int ExcludedBody(Model m, int i) {
  const auto [body1, body2] = engine::ExcludedBodies(m, i);
  return second ? body2 : body1;
}

int EqualityIsActive(Model m, int i) { return (m.*engine::kEqualityActive)[i] != 0 ? 1 : 0; }
int LightIsDirectional(Model m, int i) { return (m.*engine::kLightDirectional)[i] == 1 ? 1 : 0; }

// Returns the position of an enumerator in a list of MuJoCo 2.2.2, because later releases insert
// enumerators. Returns a number beyond the end of the list for an enumerator that 2.2.2 does not
// have.
template <const auto& list>
int PositionIn(int value) {
  const auto found = std::ranges::find(list, value);
  const auto at = static_cast<int>(found - std::begin(list));
  return found == std::end(list) ? at + 1 + value : at;
}

// Enumerators of mjtDyn in MuJoCo 2.2.2, in order.
constexpr std::array<int, 5> kDynamics = {mjDYN_NONE, mjDYN_INTEGRATOR, mjDYN_FILTER, mjDYN_MUSCLE,
                                          mjDYN_USER};
// Enumerators of mjtGain and mjtBias in MuJoCo 2.2.2, in order.
constexpr std::array<int, 4> kGains = {mjGAIN_FIXED, mjGAIN_AFFINE, mjGAIN_MUSCLE, mjGAIN_USER};
constexpr std::array<int, 4> kBiases = {mjBIAS_NONE, mjBIAS_AFFINE, mjBIAS_MUSCLE, mjBIAS_USER};
// Enumerators of mjtSensor in MuJoCo 2.2.2, in order.
constexpr auto kSensors = [] {
  std::array<mjtSensor, std::size(engine::kSensorTypes)> types{};
  std::ranges::transform(engine::kSensorTypes, types.begin(), &engine::SensorType::type);
  return types;
}();
// Object types that a frame sensor can have. All other object types get the same number, because
// they follow from the type of the sensor.
constexpr std::array<int, 6> kTargets = {mjOBJ_UNKNOWN, mjOBJ_BODY, mjOBJ_XBODY,
                                         mjOBJ_GEOM,    mjOBJ_SITE, mjOBJ_CAMERA};

int Dynamics(Model m, int i) { return PositionIn<kDynamics>(m.actuator_dyntype[i]); }
int Gain(Model m, int i) { return PositionIn<kGains>(m.actuator_gaintype[i]); }
int Bias(Model m, int i) { return PositionIn<kBiases>(m.actuator_biastype[i]); }
int SensorType(Model m, int i) { return PositionIn<kSensors>(m.sensor_type[i]); }

template <auto array>
int Target(Model m, int i) {
  const auto found = std::ranges::find(kTargets, (m.*array)[i]);
  return static_cast<int>(found - kTargets.begin());
}

constexpr std::string_view kGeomWords[] = {"plane",     "hfield",   "sphere", "capsule",
                                           "ellipsoid", "cylinder", "box",    "mesh"};
constexpr std::string_view kJointWords[] = {"free", "ball", "slide", "hinge"};
constexpr std::string_view kFrameWords[] = {"none", "body", "inertia", "bodyrot", "inertiarot"};
constexpr std::string_view kFlagWords[] = {"false", "true"};

using M = mjModel;

constexpr Kind kKinds[] = {
    {mjOBJ_UNKNOWN, "model", ""},
    {mjOBJ_BODY, "body", "nbody", &M::nbody, &M::name_bodyadr},
    {mjOBJ_JOINT, "joint", "njnt", &M::njnt, &M::name_jntadr},
    {mjOBJ_DOF, "degree of freedom", "nv", &M::nv},
    {mjOBJ_GEOM, "geom", "ngeom", &M::ngeom, &M::name_geomadr},
    {mjOBJ_SITE, "site", "nsite", &M::nsite, &M::name_siteadr},
    {mjOBJ_CAMERA, "camera", "ncam", &M::ncam, &M::name_camadr},
    {mjOBJ_LIGHT, "light", "nlight", &M::nlight, &M::name_lightadr},
    {mjOBJ_MESH, "mesh", "nmesh", &M::nmesh, &M::name_meshadr},
    {mjOBJ_HFIELD, "height field", "nhfield", &M::nhfield, &M::name_hfieldadr},
    {mjOBJ_PAIR, "pair", "npair", &M::npair, &M::name_pairadr},
    {mjOBJ_EXCLUDE, "exclude", "nexclude", &M::nexclude, &M::name_excludeadr},
    {mjOBJ_EQUALITY, "equality", "neq", &M::neq, &M::name_eqadr},
    {mjOBJ_TENDON, "tendon", "ntendon", &M::ntendon, &M::name_tendonadr},
    {mjOBJ_NUMERIC, "wrap", "nwrap", &M::nwrap},  // stands for wraps of tendons, which mjtObj lacks
    {mjOBJ_ACTUATOR, "actuator", "nu", &M::nu, &M::name_actuatoradr},
    {mjOBJ_SENSOR, "sensor", "nsensor", &M::nsensor, &M::name_sensoradr},
    {mjOBJ_KEY, "keyframe", "nkey", &M::nkey, &M::name_keyadr}};

constexpr bool kIsCoincidence = true;

constexpr Field kFields[] = {
    {"option integrator", mjOBJ_UNKNOWN, Option<&mjOption::integrator>},
    {"option cone", mjOBJ_UNKNOWN, Option<&mjOption::cone>},
    {"option jacobian", mjOBJ_UNKNOWN, Option<&mjOption::jacobian>},
    {"option solver", mjOBJ_UNKNOWN, Option<&mjOption::solver>},
    {"option iterations", mjOBJ_UNKNOWN, Option<&mjOption::iterations>},
    {"option noslip_iterations", mjOBJ_UNKNOWN, Option<&mjOption::noslip_iterations>},
    {"option disableflags", mjOBJ_UNKNOWN, Option<&mjOption::disableflags>},
    {"option enableflags", mjOBJ_UNKNOWN, EnableFlags},
    {"option has_fluid", mjOBJ_UNKNOWN, HasFluid, kFlagWords},
    {"nuserdata", mjOBJ_UNKNOWN, CountOf<&M::nuserdata>},
    {"nskin", mjOBJ_UNKNOWN, CountOf<&M::nskin>},
    {"nnumeric", mjOBJ_UNKNOWN, CountOf<&M::nnumeric>},
    {"ntext", mjOBJ_UNKNOWN, CountOf<&M::ntext>},
    {"ntuple", mjOBJ_UNKNOWN, CountOf<&M::ntuple>},
    {"body_parentid", mjOBJ_BODY, At<&M::body_parentid>},
    {"body_mocapid", mjOBJ_BODY, At<&M::body_mocapid>},
    {"body_sameframe", mjOBJ_BODY, BodySameFrame, kFrameWords, kIsCoincidence},
    {"body_simple", mjOBJ_BODY, BodyIsSimple, kFlagWords, kIsCoincidence},
    {"jnt_type", mjOBJ_JOINT, At<&M::jnt_type>, kJointWords},
    {"jnt_bodyid", mjOBJ_JOINT, At<&M::jnt_bodyid>},
    {"jnt_limited", mjOBJ_JOINT, At<&M::jnt_limited>, kFlagWords},
    {"jnt_group", mjOBJ_JOINT, At<&M::jnt_group>},
    {"dof_jntid", mjOBJ_DOF, At<&M::dof_jntid>},
    {"dof_hasfrictionloss", mjOBJ_DOF, IsPositive<&M::dof_frictionloss>, kFlagWords,
     kIsCoincidence},
    {"geom_type", mjOBJ_GEOM, At<&M::geom_type>, kGeomWords},
    {"geom_bodyid", mjOBJ_GEOM, At<&M::geom_bodyid>},
    {"geom_dataid", mjOBJ_GEOM, At<&M::geom_dataid>},
    {"geom_contype", mjOBJ_GEOM, At<&M::geom_contype>},
    {"geom_conaffinity", mjOBJ_GEOM, At<&M::geom_conaffinity>},
    {"geom_condim", mjOBJ_GEOM, At<&M::geom_condim>},
    {"geom_priority", mjOBJ_GEOM, At<&M::geom_priority>},
    {"geom_group", mjOBJ_GEOM, At<&M::geom_group>},
    {"geom_fluidshape", mjOBJ_GEOM, HasFluidShape, kFlagWords},
    {"geom_sameframe", mjOBJ_GEOM, GeomSameFrame, kFrameWords, kIsCoincidence},
    {"site_type", mjOBJ_SITE, At<&M::site_type>, kGeomWords},
    {"site_bodyid", mjOBJ_SITE, At<&M::site_bodyid>},
    {"site_group", mjOBJ_SITE, At<&M::site_group>},
    {"site_sameframe", mjOBJ_SITE, SiteSameFrame, kFrameWords, kIsCoincidence},
    {"cam_mode", mjOBJ_CAMERA, At<&M::cam_mode>},
    {"cam_bodyid", mjOBJ_CAMERA, At<&M::cam_bodyid>},
    {"cam_targetbodyid", mjOBJ_CAMERA, At<&M::cam_targetbodyid>},
    {"light_mode", mjOBJ_LIGHT, At<&M::light_mode>},
    {"light_bodyid", mjOBJ_LIGHT, At<&M::light_bodyid>},
    {"light_targetbodyid", mjOBJ_LIGHT, At<&M::light_targetbodyid>},
    {"light_directional", mjOBJ_LIGHT, LightIsDirectional, kFlagWords},
    {"light_castshadow", mjOBJ_LIGHT, At<&M::light_castshadow>, kFlagWords},
    {"light_active", mjOBJ_LIGHT, At<&M::light_active>, kFlagWords},
    {"mesh_vertnum", mjOBJ_MESH, At<&M::mesh_vertnum>},
    {"mesh_facenum", mjOBJ_MESH, At<&M::mesh_facenum>},
    {"hfield_nrow", mjOBJ_HFIELD, At<&M::hfield_nrow>},
    {"hfield_ncol", mjOBJ_HFIELD, At<&M::hfield_ncol>},
    {"pair_dim", mjOBJ_PAIR, At<&M::pair_dim>},
    {"pair_geom1", mjOBJ_PAIR, At<&M::pair_geom1>},
    {"pair_geom2", mjOBJ_PAIR, At<&M::pair_geom2>},
    {"exclude_body1", mjOBJ_EXCLUDE, ExcludedBody<false>},
    {"exclude_body2", mjOBJ_EXCLUDE, ExcludedBody<true>},
    {"eq_type", mjOBJ_EQUALITY, At<&M::eq_type>},
    {"eq_obj1id", mjOBJ_EQUALITY, At<&M::eq_obj1id>},
    {"eq_obj2id", mjOBJ_EQUALITY, At<&M::eq_obj2id>},
    {"eq_active", mjOBJ_EQUALITY, EqualityIsActive, kFlagWords},
    {"tendon_num", mjOBJ_TENDON, At<&M::tendon_num>},
    {"tendon_limited", mjOBJ_TENDON, At<&M::tendon_limited>, kFlagWords},
    {"tendon_group", mjOBJ_TENDON, At<&M::tendon_group>},
    {"tendon_hasfrictionloss", mjOBJ_TENDON, IsPositive<&M::tendon_frictionloss>, kFlagWords},
    {"tendon_hasstiffness", mjOBJ_TENDON, IsPositive<&M::tendon_stiffness>, kFlagWords},
    {"tendon_hasdamping", mjOBJ_TENDON, IsPositive<&M::tendon_damping>, kFlagWords},
    {"wrap_type", mjOBJ_NUMERIC, At<&M::wrap_type>},
    {"wrap_objid", mjOBJ_NUMERIC, At<&M::wrap_objid>},
    {"actuator_trntype", mjOBJ_ACTUATOR, At<&M::actuator_trntype>},
    {"actuator_trnid", mjOBJ_ACTUATOR, At<&M::actuator_trnid, 2>},
    {"actuator_trnid2", mjOBJ_ACTUATOR, At<&M::actuator_trnid, 2, 1>},
    {"actuator_dyntype", mjOBJ_ACTUATOR, Dynamics},
    {"actuator_gaintype", mjOBJ_ACTUATOR, Gain},
    {"actuator_biastype", mjOBJ_ACTUATOR, Bias},
    {"actuator_ctrllimited", mjOBJ_ACTUATOR, At<&M::actuator_ctrllimited>, kFlagWords},
    {"actuator_forcelimited", mjOBJ_ACTUATOR, At<&M::actuator_forcelimited>, kFlagWords},
    {"actuator_actlimited", mjOBJ_ACTUATOR, At<&M::actuator_actlimited>, kFlagWords},
    {"actuator_group", mjOBJ_ACTUATOR, At<&M::actuator_group>},
    {"sensor_type", mjOBJ_SENSOR, SensorType},
    {"sensor_objtype", mjOBJ_SENSOR, Target<&M::sensor_objtype>},
    {"sensor_objid", mjOBJ_SENSOR, At<&M::sensor_objid>},
    {"sensor_reftype", mjOBJ_SENSOR, Target<&M::sensor_reftype>},
    {"sensor_refid", mjOBJ_SENSOR, At<&M::sensor_refid>},
    {"sensor_dim", mjOBJ_SENSOR, At<&M::sensor_dim>},
    {"sensor_datatype", mjOBJ_SENSOR, At<&M::sensor_datatype>},
    {"sensor_needstage", mjOBJ_SENSOR, At<&M::sensor_needstage>}};

}  // namespace

std::span<const Kind> Kinds() { return kKinds; }
std::span<const Field> Fields() { return kFields; }

}  // namespace mjforge::structure
