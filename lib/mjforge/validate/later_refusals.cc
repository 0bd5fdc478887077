// Searches compiled models for meshes, cameras and tendons, and objects for attributes, that later
// releases reject.
#include "mjforge/validate/later_refusals.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "mjforge/backport/backport.h"
#include "mjforge/compiled/compiled.h"
#include "mjforge/xml/xml.h"

namespace mjforge::validate {
namespace {

using diag::Code;

constexpr std::string_view kMesh = "mesh";

struct Triangle {
  Eigen::Vector3d centre;
  Eigen::Vector3d normal;  // the length is the triangle's area
};

std::vector<Triangle> TrianglesOf(const model::TriangleMesh& mesh) {
  const auto at = [&](int vertex) { return mesh.vertices[compiled::Index(vertex)]; };
  std::vector<Triangle> triangles;
  for (const auto& [i, j, k] : mesh.triangles)
    triangles.push_back({(at(i) + at(j) + at(k)) / 3, (at(j) - at(i)).cross(at(k) - at(i)) / 2});
  return triangles;
}

// Returns the volume of a mesh, m^3, like mjCMesh::ComputeVolume: the sum of the volumes of the
// pyramids from the centroid of the surface to each face. The vertices are those of the file,
// because MuJoCo 2.2 does not move the vertices of meshes without a volume.
double VolumeOf(const std::vector<Triangle>& triangles) {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double area = 0;
  for (const Triangle& triangle : triangles) {
    area += triangle.normal.norm();
    centroid += triangle.normal.norm() * triangle.centre;
  }
  if (!(area > 0)) return 0;
  centroid /= area;
  double volume = 0;
  for (const Triangle& triangle : triangles)
    volume += std::abs((triangle.centre - centroid).dot(triangle.normal)) / 3;
  return volume;
}

// Returns the joints of a fixed tendon; empty for a spatial one.
std::vector<int> JointsOf(const mjModel& m, int tendon) {
  const int first = m.tendon_adr[tendon];
  if (m.wrap_type[first] != mjWRAP_JOINT) return {};
  return {m.wrap_objid + first, m.wrap_objid + first + m.tendon_num[tendon]};
}

// Calls report(kind, name, message, hint) for each element of the model that later releases reject.
template <typename Report>
void ForEachRefused(const mjModel& m, const Report& report) {
  for (int mesh = 0; mesh < m.nmesh && mjVERSION_HEADER < 330; ++mesh) {
    const double volume = VolumeOf(TrianglesOf(compiled::MeshOf(m, mesh)));
    if (volume >= mjMINVAL) continue;
    report(kMesh, m.names + m.name_meshadr[mesh],
           fmt::format("has a volume of {:.2g} m^3; MuJoCo 3.3.0 and later reject a mesh of less "
                       "than {:g} m^3, even if it is only seen",
                       volume, mjMINVAL),
           "give a flat mesh some thickness, or use a thin box");
  }
  for (int camera = 0; camera < m.ncam && mjVERSION_HEADER < 300; ++camera) {
    if (m.cam_fovy[camera] < 180) continue;
    report("camera", m.names + m.name_camadr[camera],
           fmt::format("has a 'fovy' of {:g} degrees; MuJoCo 3.0.0 and later require less than 180",
                       m.cam_fovy[camera]),
           "");
  }
  for (int tendon = 0; tendon < m.ntendon && mjVERSION_HEADER < 4000000; ++tendon) {
    const char* const name = m.names + m.name_tendonadr[tendon];
    std::vector<int> joints = JointsOf(m, tendon);
    const bool has_ball = std::ranges::any_of(joints, [&](int joint) {
      return m.jnt_type[joint] != mjJNT_HINGE && m.jnt_type[joint] != mjJNT_SLIDE;
    });
    if (has_ball)
      report("tendon", name,
             "has a ball or free joint; MuJoCo 4.0.0 and later require hinges and slides", "");
    std::ranges::sort(joints);
    const auto repeated = std::ranges::adjacent_find(joints);
    if (repeated != joints.end())
      report("tendon", name,
             fmt::format("has joint '{}' twice, which MuJoCo 4.0.0 and later reject",
                         m.names + m.name_jntadr[*repeated]),
             "add the coefficients");
  }
}

// Adds an error for each attribute of an element, and of its descendants, that later releases
// reject. `parent` is the tag of the parent element.
void CheckAttributes(std::string_view parent, const model::Element& element,
                     diag::Findings& findings) {
  for (const model::Attribute& attribute : element.attributes) {
    const std::string value =
        attribute.numbers.empty()
            ? attribute.text
            : xml::TextOf({attribute.numbers.begin(), attribute.numbers.end()});
    const auto refusal =
        backport::FindRefusal(parent, element.tag, attribute.name, value, mjVERSION_HEADER);
    if (refusal)
      findings.Add(Code::kMujocoLaterRefuses, element.mark,
                   fmt::format("{} {}", element.tag, *refusal));
  }
  for (const model::Element& child : element.children)
    CheckAttributes(element.tag, child, findings);
}

// Returns the place of a mesh, camera or tendon in the spec.
diag::SourceMark PlaceOf(const model::Object& object, std::string_view kind,
                         std::string_view name) {
  if (kind == kMesh) {
    for (const auto& mesh : object.meshes) {
      if (mesh->name == name) return mesh->mark;
    }
  }
  for (const model::Element& tendon : model::ElementsOf(object, "tendon")) {
    if (kind == "tendon" && tendon.name == name) return tendon.mark;
  }
  for (const model::Body& body : object.bodies) {
    for (const model::Element& view : body.elements) {
      if (kind == view.tag && view.name == name) return view.mark;
    }
  }
  return {};
}

}  // namespace

void FindLaterRefusals(const mjModel& m, const model::Object& object, diag::Findings& findings) {
  ForEachRefused(m, [&](std::string_view kind, std::string_view name, const std::string& message,
                        const std::string& hint) {
    findings.Add(Code::kMujocoLaterRefuses, PlaceOf(object, kind, name),
                 fmt::format("{} '{}' {}", kind, name, message), hint);
  });
  for (const model::Section& section : object.sections) {
    const std::string_view parent = section.info->is_element ? "mujoco" : section.info->name;
    for (const model::Element& element : section.elements)
      CheckAttributes(parent, element, findings);
  }
}

void FindLaterRefusals(const mjModel& m, diag::SourceMark mark, diag::Findings& findings) {
  ForEachRefused(m, [&](std::string_view kind, std::string_view name, const std::string& message,
                        const std::string& hint) {
    findings.Warn(Code::kMujocoLaterRefuses, mark, fmt::format("{} '{}' {}", kind, name, message),
                  hint);
  });
}

}  // namespace mjforge::validate
