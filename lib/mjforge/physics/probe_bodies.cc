// Adds probe bodies to MJCF texts, sets positions of objects, and holds degrees of freedom in
// place.
#include "mjforge/physics/probe_bodies.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "mjforge/engine/engine.h"

namespace mjforge::physics {
namespace {

// Armature of a held degree of freedom (kg or kg m^2), as a multiple of the mass of all bodies. A
// larger armature would let small bodies tremble in MuJoCo 3.17 and 4.0, whose solver tolerance is
// proportional to the mean inertia.
constexpr double kHeldMass = 1e6;

}  // namespace

std::string WithBodies(std::string_view text, std::string_view bodies,
                       std::string_view equalities) {
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  pugi::xml_node root = document.document_element();
  while (root.remove_child("keyframe")) {
  }
  const auto append = [&](const char* section, std::string_view elements) {
    pugi::xml_node parent = root.child(section);
    if (!parent) parent = root.append_child(section);
    parent.append_buffer(elements.data(), elements.size(),
                         pugi::parse_default | pugi::parse_fragment);
  };
  append("worldbody", bodies);
  if (!equalities.empty()) append("equality", equalities);
  std::ostringstream out;
  document.save(out, "", pugi::format_raw);
  return std::move(out).str();
}

std::string ProbeGeom(std::string_view shape, double mass, std::string_view contact) {
  return fmt::format(R"(<geom {} mass="{}" contype="2147483647" conaffinity="2147483647" {} )"
                     R"(solref="0.02 1" solimp="0.9 0.95 0.001 0.5 2" solmix="1" )"
                     R"(priority="0" margin="0" gap="0"/>)",
                     shape, mass, contact);
}

void PlaceObject(const mjModel& m, mjData& d, std::span<const mjtNum> start, int first, int count) {
  const int at = count > 0 ? m.jnt_qposadr[first] : m.nq;
  std::copy(start.begin(), start.begin() + at, d.qpos);
  std::copy(start.begin() + at, start.end(), d.qpos + at + count);
}

// Sets dof_M0, too, because MuJoCo takes the diagonal of the inertia matrix from dof_M0 where the
// matrix is diagonal (dof_simplenum).
void HoldDof(mjModel& m, int dof) {
  m.dof_armature[dof] = m.dof_M0[dof] = kHeldMass * m.body_subtreemass[0];
}

void HoldOthers(mjModel& m, int first, int count) {
  for (int i = 0; i < m.nv; ++i) {
    if (i < first || i >= first + count) HoldDof(m, i);
  }
  m.opt.disableflags |= mjDSBL_EQUALITY | mjDSBL_LIMIT | engine::kDisablePassive | mjDSBL_ACTUATION;
}

}  // namespace mjforge::physics
