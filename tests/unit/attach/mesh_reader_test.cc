#include "mjforge/attach/mesh_reader.h"

#include <string>

#include <catch2/catch.hpp>

#include "attaching.h"

namespace mjforge::attach {
namespace {

const std::string kCorner =
    "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string MeshNames(const model::Attachment& attachment) {
  std::string names;
  for (const auto& mesh : attachment.meshes) names += (names.empty() ? "" : " ") + mesh->name;
  return names;
}

model::Box3 BoundsOf(const model::Part& part) { return model::BoundsOf(part.shape, part.X_BG); }

TEST_CASE("a mesh geom has the pose that the file says, and the mesh its own coordinates") {
  Attaching files(Mjcf(
      "<body name=\"b\"><geom name=\"g\" type=\"mesh\" mesh=\"corner\" pos=\"1 1 1\"/></body>\n",
      "<compiler meshdir=\"meshes\"/><asset><mesh file=\"corner.obj\" scale=\"2 1 "
      "1\"/></asset>\n"));
  files.Write("meshes/corner.obj", kCorner);
  const model::Attachment& b = files.Get();
  REQUIRE(MeshNames(b) == "corner");
  const model::MeshAsset& mesh = *b.meshes[0];
  CHECK(mesh.file.is_absolute());
  CHECK(mesh.file.filename() == "corner.obj");
  CHECK(mesh.scale == Eigen::Vector3d(2, 1, 1));
  CHECK(mesh.attributes.empty());
  const model::Part& part = b.bodies[0].parts[0];
  CHECK(part.shape.mesh == &mesh.mesh);
  CHECK(part.X_BG.p.isApprox(Eigen::Vector3d(1, 1, 1)));
  CHECK(part.X_BG.q.isApprox(Eigen::Quaterniond::Identity()));
  CHECK((BoundsOf(part).min - Eigen::Vector3d(1, 1, 1)).norm() < 1e-6);
  CHECK((BoundsOf(part).max - Eigen::Vector3d(3, 3, 4)).norm() < 1e-6);
}

TEST_CASE("reference frames and inline data are carried as they are said") {
  Attaching files(
      Mjcf("<body name=\"b\"><geom name=\"g\" type=\"mesh\" mesh=\"m\"/></body>\n",
           "<asset><mesh name=\"m\" refpos=\"1 0 0\" refquat=\"0 1 0 0\" smoothnormal=\"true\" "
           "vertex=\"1 0 0 2 0 0 1 1 0 1 0 1\"/></asset>\n"));
  const model::Attachment& b = files.Get();
  const model::MeshAsset& mesh = *b.meshes[0];
  CHECK(mesh.file.empty());
  CHECK(Said(mesh.attributes) ==
        "refpos=1 0 0 refquat=0 1 0 0 vertex=1 0 0 2 0 0 1 1 0 1 0 1 smoothnormal=true");
  // Turned by half a turn about x.
  CHECK((BoundsOf(b.bodies[0].parts[0]).min - Eigen::Vector3d(0, -1, -1)).norm() < 1e-6);
  CHECK((BoundsOf(b.bodies[0].parts[0]).max - Eigen::Vector3d(1, 0, 0)).norm() < 1e-6);
}

TEST_CASE("the scale of a mesh comes from its class") {
  Attaching files(Mjcf(
      "<body name=\"b\"><geom type=\"mesh\" mesh=\"m\"/><geom type=\"mesh\" mesh=\"n\"/>"
      "<geom type=\"mesh\" mesh=\"o\"/></body>\n",
      "<default><mesh scale=\"2 2 2\"/><default class=\"small\"><geom density=\"3\"/>"
      "<default class=\"tiny\"><mesh scale=\"0.1 0.1 0.1\"/></default></default></default>\n"
      "<asset><mesh name=\"m\" file=\"c.obj\"/><mesh name=\"n\" class=\"small\" file=\"c.obj\"/>"
      "<mesh name=\"o\" class=\"tiny\" file=\"c.obj\"/></asset>\n"));
  files.Write("c.obj", kCorner);
  const model::Attachment& b = files.Get();
  REQUIRE(MeshNames(b) == "m n o");
  CHECK(b.meshes[0]->scale.x() == 2);
  CHECK(b.meshes[1]->scale.x() == 2);
  CHECK(b.meshes[2]->scale.x() == 0.1);
  CHECK(BoundsOf(b.bodies[0].parts[2]).max.z() == Approx(0.3));
}

TEST_CASE("a primitive fitted to a mesh is that primitive, without the mesh") {
  Attaching files(Mjcf(
      "<body name=\"b\"><geom name=\"g\" type=\"box\" mesh=\"m\"/></body>\n",
      "<compiler fitaabb=\"true\"/><asset><mesh name=\"m\" vertex=\"0 0 0 2 0 0 0 4 0 2 4 0 0 0 "
      "6 2 0 6 0 4 6 2 4 6\"/></asset>\n"));
  const model::Attachment& b = files.Get();
  CHECK(b.meshes.empty());
  const model::Part& part = b.bodies[0].parts[0];
  CHECK(part.shape.type == model::GeomType::kBox);
  // Do not compare positions: 2.2 measures them from the centre of mass.
  CHECK((BoundsOf(part).max - BoundsOf(part).min - Eigen::Vector3d(2, 4, 6)).norm() < 1e-6);
}

TEST_CASE("a mesh file that is missing is named with its place in the XML") {
  Attaching files(
      Mjcf("<body name=\"b\"><geom type=\"mesh\" mesh=\"m\"/></body>\n",
           "<compiler meshdir=\"meshes\"/>\n<asset>\n<mesh name=\"m\" file=\"gone.stl\"/>"
           "</asset>\n"));
  CHECK(files.Try() == nullptr);
  CHECK(files.OnlyFinding() ==
        "error model/file-not-found: cannot read 'meshes/gone.stl', the file of mesh 'm': No such "
        "file or directory "
        "[arm.xml:4:1 here]");
}

TEST_CASE("paths are taken off where the file says so") {
  Attaching files(
      Mjcf("<body name=\"b\"><geom type=\"mesh\" mesh=\"m\"/></body>\n",
           "<compiler meshdir=\"meshes/\" strippath=\"true\"/>\n<asset><mesh name=\"m\" "
           "file=\"/elsewhere/m.obj\"/></asset>\n"));
  files.Write("meshes/m.obj", kCorner);
  CHECK(files.Get().meshes[0]->file.parent_path().filename() == "meshes");
}

TEST_CASE("a broken mesh is refused by its own name, not by an absolute path") {
  Attaching files(Mjcf("<body name=\"b\"><geom type=\"mesh\" mesh=\"m\"/></body>\n",
                       "<asset><mesh name=\"m\" file=\"m.stl\"/></asset>\n"));
  files.Write("m.stl", "no triangles");
  CHECK(files.Try() == nullptr);
  const std::string finding = files.OnlyFinding();
  CHECK(finding.starts_with("error mujoco/error: MuJoCo refused mesh 'm' of 'arm.xml': "));
  CHECK(finding.ends_with("[arm.xml:2:8 here]"));
}

}  // namespace
}  // namespace mjforge::attach
