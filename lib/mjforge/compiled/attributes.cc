// Table of MJCF attributes with their defaults and the arrays of mjModel that contain their values,
// and the elements on the paths of tendons.
#include "mjforge/compiled/attributes.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>

#include "mjforge/compiled/compiled.h"

namespace mjforge::compiled {
namespace {

using Rows = ArrayField::Rows;
using M = mjModel;

constexpr std::array<double, 6> kSolref = {0.02, 1};
constexpr std::array<double, 6> kSolimp = {0.9, 0.95, 0.001, 0.5, 2};
constexpr std::array<double, 6> kGray = {0.5, 0.5, 0.5, 1};
constexpr std::array<double, 6> kOne = {1};
constexpr std::nullopt_t kNone = std::nullopt;

constexpr ArrayField User(mjtNum* M::*array, engine::Count M::*count) {
  return {.attribute = "user", .array = array, .variable = count};
}

constexpr ArrayField kBody[] = {User(&M::body_user, &M::nuser_body)};
constexpr ArrayField kGeom[] = {{"contype", &M::geom_contype, 1, kOne},
                                {"conaffinity", &M::geom_conaffinity, 1, kOne},
                                {"condim", &M::geom_condim, 1, {{3}}},
                                {"group", &M::geom_group},
                                {"priority", &M::geom_priority},
                                {"friction", &M::geom_friction, 3, {{1, 0.005, 0.0001}}},
                                {"solmix", &M::geom_solmix, 1, kOne},
                                {"solref", &M::geom_solref, mjNREF, kSolref},
                                {"solimp", &M::geom_solimp, mjNIMP, kSolimp},
                                {"margin", &M::geom_margin},
                                {"gap", &M::geom_gap},
                                {"rgba", &M::geom_rgba, 4, kGray},
                                User(&M::geom_user, &M::nuser_geom)};
constexpr ArrayField kJoint[] = {{"group", &M::jnt_group},
                                 {"stiffness", &M::jnt_stiffness},
                                 {"damping", &M::dof_damping, 1, {{}}, Rows::kDof},
                                 {"frictionloss", &M::dof_frictionloss, 1, {{}}, Rows::kDof},
                                 {"armature", &M::dof_armature, 1, {{}}, Rows::kDof},
                                 {"ref", &M::qpos0, 1, {{}}, Rows::kQpos},
                                 {"springref", &M::qpos_spring, 1, {{}}, Rows::kQpos},
                                 {"margin", &M::jnt_margin},
                                 {"solreflimit", &M::jnt_solref, mjNREF, kSolref},
                                 {"solimplimit", &M::jnt_solimp, mjNIMP, kSolimp},
                                 {"solreffriction", &M::dof_solref, mjNREF, kSolref, Rows::kDof},
                                 {"solimpfriction", &M::dof_solimp, mjNIMP, kSolimp, Rows::kDof},
                                 User(&M::jnt_user, &M::nuser_jnt)};
constexpr ArrayField kSite[] = {{"rgba", &M::site_rgba, 4, kGray},
                                {"group", &M::site_group},
                                User(&M::site_user, &M::nuser_site)};
constexpr ArrayField kCamera[] = {{"pos", &M::cam_pos, 3, kNone},
                                  {"quat", &M::cam_quat, 4, kOne},
                                  {"fovy", &M::cam_fovy, 1, {{45}}},
                                  {"ipd", &M::cam_ipd, 1, {{0.068}}},
                                  User(&M::cam_user, &M::nuser_cam)};
constexpr ArrayField kLight[] = {{"pos", &M::light_pos, 3, kNone},
                                 {"dir", &M::light_dir, 3, kNone},
                                 {"directional", engine::kLightDirectional},
                                 {"castshadow", &M::light_castshadow, 1, kOne},
                                 {"active", &M::light_active, 1, kOne},
                                 {"attenuation", &M::light_attenuation, 3, kOne},
                                 {"cutoff", &M::light_cutoff, 1, {{45}}},
                                 {"exponent", &M::light_exponent, 1, {{10}}},
                                 {"ambient", &M::light_ambient, 3},
                                 {"diffuse", &M::light_diffuse, 3, {{0.7, 0.7, 0.7}}},
                                 {"specular", &M::light_specular, 3, {{0.3, 0.3, 0.3}}}};
constexpr ArrayField kTendon[] = {
    {"group", &M::tendon_group},
    {"limited", &M::tendon_limited, 1, kNone},
    {"range", &M::tendon_range, 2, kNone, Rows::kElement, &M::tendon_limited},
    {"solreflimit", &M::tendon_solref_lim, mjNREF, kSolref},
    {"solimplimit", &M::tendon_solimp_lim, mjNIMP, kSolimp},
    {"solreffriction", &M::tendon_solref_fri, mjNREF, kSolref},
    {"solimpfriction", &M::tendon_solimp_fri, mjNIMP, kSolimp},
    {"frictionloss", &M::tendon_frictionloss},
    {"springlength", &M::tendon_lengthspring, 1, kNone},
    {"margin", &M::tendon_margin},
    {"stiffness", &M::tendon_stiffness},
    {"damping", &M::tendon_damping},
    User(&M::tendon_user, &M::nuser_tendon)};
constexpr ArrayField kActuator[] = {
    {"group", &M::actuator_group},
    {"ctrllimited", &M::actuator_ctrllimited, 1, kNone},
    {"ctrlrange", &M::actuator_ctrlrange, 2, kNone, Rows::kElement, &M::actuator_ctrllimited},
    {"forcelimited", &M::actuator_forcelimited, 1, kNone},
    {"forcerange", &M::actuator_forcerange, 2, kNone, Rows::kElement, &M::actuator_forcelimited},
    {"actlimited", &M::actuator_actlimited, 1, kNone},
    {"actrange", &M::actuator_actrange, 2, kNone, Rows::kElement, &M::actuator_actlimited},
    {"lengthrange", &M::actuator_lengthrange, 2},
    {"gear", &M::actuator_gear, 6, kOne},
    User(&M::actuator_user, &M::nuser_actuator)};
constexpr ArrayField kPair[] = {
    {"condim", &M::pair_dim, 1, kNone},         {"friction", &M::pair_friction, 5, kNone},
    {"solref", &M::pair_solref, mjNREF, kNone}, {"solimp", &M::pair_solimp, mjNIMP, kNone},
    {"margin", &M::pair_margin, 1, kNone},      {"gap", &M::pair_gap, 1, kNone}};
constexpr ArrayField kEquality[] = {{"active", engine::kEqualityActive, 1, kOne},
                                    {"solref", &M::eq_solref, mjNREF, kSolref},
                                    {"solimp", &M::eq_solimp, mjNIMP, kSolimp}};
constexpr ArrayField kMaterial[] = {{"rgba", &M::mat_rgba, 4, {{1, 1, 1, 1}}},
                                    {"specular", &M::mat_specular, 1, {{0.5}}},
                                    {"shininess", &M::mat_shininess, 1, {{0.5}}},
                                    {"reflectance", &M::mat_reflectance},
                                    {"emission", &M::mat_emission},
                                    {"texrepeat", &M::mat_texrepeat, 2, {{1, 1}}},
                                    {"texuniform", &M::mat_texuniform}};
constexpr ArrayField kSensor[] = {{"cutoff", &M::sensor_cutoff},
                                  {"noise", &M::sensor_noise},
                                  User(&M::sensor_user, &M::nuser_sensor)};

struct Kind {
  mjtObj kind;
  std::span<const ArrayField> fields;
};
constexpr Kind kKinds[] = {
    {mjOBJ_BODY, kBody},         {mjOBJ_GEOM, kGeom},         {mjOBJ_JOINT, kJoint},
    {mjOBJ_SITE, kSite},         {mjOBJ_CAMERA, kCamera},     {mjOBJ_LIGHT, kLight},
    {mjOBJ_TENDON, kTendon},     {mjOBJ_ACTUATOR, kActuator}, {mjOBJ_PAIR, kPair},
    {mjOBJ_EQUALITY, kEquality}, {mjOBJ_MATERIAL, kMaterial}, {mjOBJ_SENSOR, kSensor}};

/// Returns the row of the field's array that belongs to element `id`; nullopt if the attribute does
/// not apply to the element.
std::optional<int> RowOf(const mjModel& m, const ArrayField& field, int id) {
  if (field.needs != nullptr && (m.*field.needs)[id] == 0) return std::nullopt;
  if (field.rows == Rows::kElement) return id;
  if (field.rows == Rows::kDof) return m.jnt_dofadr[id];
  return HasOneNumber(m, id) ? std::optional(m.jnt_qposadr[id]) : std::nullopt;
}

double Number(double value) { return value; }
double Number(int value) { return value; }
/// Returns the value of the shortest decimal that reads back as `value`: 0.1 for 0.1f.
double Number(float value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = value;
  std::from_chars(text.data(), end, number);
  return number;
}

}  // namespace

std::span<const ArrayField> ArrayFields(mjtObj kind) {
  const auto found = std::ranges::find(kKinds, kind, &Kind::kind);
  return found == std::end(kKinds) ? std::span<const ArrayField>() : found->fields;
}

sample::Numbers NumbersOf(const mjModel& m, const ArrayField& field, int id) {
  sample::Numbers numbers;
  const std::optional<int> row = RowOf(m, field, id);
  if (!row) return numbers;
  const auto count = field.variable != nullptr ? static_cast<int>(m.*field.variable) : field.count;
  std::visit(
      [&](auto array) {
        const auto* first = m.*array + static_cast<std::ptrdiff_t>(*row) * count;
        for (int i = 0; i < count; ++i) numbers.push_back(Number(first[i]));
      },
      field.array);
  if (field.variable == nullptr) return numbers;
  while (!numbers.empty() && numbers.back() == 0) numbers.pop_back();
  return numbers;
}

Wrap WrapAt(const mjModel& m, int wrap) {
  const int object = m.wrap_objid[wrap];
  const int type = m.wrap_type[wrap];
  if (type == mjWRAP_JOINT) return {"joint", mjOBJ_JOINT, object};
  if (type == mjWRAP_PULLEY) return {"pulley"};
  if (type == mjWRAP_SITE) return {"site", mjOBJ_SITE, object};
  return {"geom", mjOBJ_GEOM, object, static_cast<int>(m.wrap_prm[wrap])};
}

}  // namespace mjforge::compiled
