// Tests of inline meshes, mesh files and their sharing.

#include <catch2/catch.hpp>

#include "assembling.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::assemble {
namespace {

const std::string kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::string kOpen = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n";

TEST_CASE("a prism is an inline mesh with the inertia written out") {
  const Assembling thing(
      "parts: [{name: a, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], scale: [2, 3], height: 4, "
      "density: 10}]\n");
  REQUIRE(thing.object().meshes.size() == 1);
  CHECK(thing.object().meshes[0]->name == "thing_a");
  CHECK(thing.object().meshes[0]->file.empty());
  CHECK(thing.part("thing_a").mass == Approx(120));
  CHECK(thing.part("thing_a").shape.mesh == &thing.object().meshes[0]->mesh);
  CHECK(thing.body().explicit_inertial);
  CHECK(thing.object().mass_properties.p_FCm.isApprox(Eigen::Vector3d(2 / 3.0, 1, 0), 1e-14));
}

TEST_CASE("equal prisms share one mesh") {
  const Assembling thing(
      "parts:\n"
      "- {name: 'a${i}', for: {i: 3}, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: 1, "
      "pos: [i, 0, 0]}\n"
      "- {name: b, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: 2}\n");
  REQUIRE(thing.object().meshes.size() == 2);
  CHECK(thing.part("thing_a2").mesh == 0);
  CHECK(thing.part("thing_b").mesh == 1);
}

TEST_CASE("a polygon that comes out wrong is reported where it stands") {
  CHECK(
      OnlyFinding("params: {x: -0.5}\n"
                  "parts: [{name: a, type: prism, polygon: [[0, 0], [1, 0], [1, 1], [x, x]], "
                  "height: 1}]\n") ==
      "4:58 polygon of part 'a': point 3 begins a line that crosses or touches the one from point "
      "1 to point 2");
}

TEST_CASE("a mesh file is read beside the spec and shared where file and scale are equal") {
  const TemporaryFolder folder;
  folder.Write("x/t.obj", kTetrahedron);
  folder.Write("y/t.obj", kTetrahedron);
  const Assembling thing(
      "parts:\n"
      "- {name: a, type: mesh, file: x/t.obj, density: 6}\n"
      "- {name: b, type: mesh, file: x/../x/t.obj, density: 6}\n"
      "- {name: c, type: mesh, file: y/t.obj, density: 6}\n"
      "- {name: d, type: mesh, file: x/t.obj, scale: [-1, 2, 3], density: 6}\n",
      1, 0, folder.path());
  const auto& meshes = thing.object().meshes;
  REQUIRE(meshes.size() == 3);
  CHECK(thing.part("thing_b").mesh == 0);
  const std::string hash = bytes::HashOf(kTetrahedron);
  CHECK(meshes[0]->output_file == "t_" + hash + ".obj");
  CHECK(meshes[1]->output_file == "t_" + hash + "_2.obj");
  CHECK(meshes[2]->output_file == "t_" + hash + ".obj");
  CHECK(meshes[2]->scale == Eigen::Vector3d(-1, 2, 3));
  CHECK(thing.part("thing_a").mass == Approx(1));
  CHECK(thing.part("thing_d").mass == Approx(6));
}

TEST_CASE("a mesh file outside of the spec's folder is named by its content, too") {
  const TemporaryFolder folder;
  const std::string other = kTetrahedron + "# other\n";
  folder.Write("s/t.obj", kTetrahedron);
  folder.Write("s/a/t.obj", kTetrahedron);
  folder.Write("s/b/t.obj", other);
  folder.Write("t.obj", other);
  const auto name_of = [&](const std::string& file) {
    const Assembling thing("parts:\n- {name: a, type: mesh, file: '" + file + "', density: 6}\n", 1,
                           0, folder.path() / "s");
    return thing.object().meshes.back()->output_file;
  };
  CHECK(name_of("t.obj") == "t.obj");
  CHECK(name_of("a/../t.obj") == "t.obj");
  CHECK(name_of("a/t.obj") == "t_" + bytes::HashOf(kTetrahedron) + ".obj");
  CHECK(name_of("b/t.obj") == "t_" + bytes::HashOf(other) + ".obj");
  CHECK(name_of("../t.obj") == name_of("b/t.obj"));
  const std::string end = "\xc3\xa4" + std::string(20, 'z') + ".obj";
  folder.Write("s/a/" + std::string(59, 'y') + end, other);
  CHECK(name_of("a/" + std::string(59, 'y') + end) ==
        std::string(59, 'y') + "_" + bytes::HashOf(other) + ".obj");
}

TEST_CASE("a mesh must be closed unless it is only seen") {
  const TemporaryFolder folder;
  folder.Write("open.obj", kOpen);
  const Assembling solid("parts: [{name: a, type: mesh, file: open.obj}]\n", 1, 0, folder.path());
  CHECK(solid.findings() ==
        std::vector<std::string>{"3:37 mesh 'open.obj' is not a closed surface: edge shared by 1 "
                                 "triangle (repair the file, or give the part `role: visual`, or "
                                 "`inertia: shell` and a mass)"});
  const Assembling seen(
      "joints: none\nparts: [{name: a, type: mesh, file: open.obj, role: visual}]\n", 1, 0,
      folder.path());
  CHECK(seen.part("thing_a").mass == 0);
  const Assembling heavy("parts: [{name: a, type: mesh, file: open.obj, role: visual, mass: 1}]\n",
                         1, 0, folder.path());
  CHECK(heavy.findings() == std::vector<std::string>{"3:9 part 'a' has mass but no closed surface "
                                                     "(leave `mass` and `density` out, or write "
                                                     "`inertia: shell`)"});
}

TEST_CASE("an open mesh can be a shell of a known mass") {
  const TemporaryFolder folder;
  // A box of 2 x 2 x 1 m without a lid: a bottom of 4 m^2 and four sides of 2 m^2.
  folder.Write("tray.obj",
               "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
               "f 1 3 2\nf 1 4 3\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\n"
               "f 4 5 8\n");
  const std::string tray = "- {name: a, type: mesh, file: tray.obj, inertia: shell";
  const Assembling thing("parts:\n" + tray + ", mass: 3}\n", 1, 0, folder.path());
  const model::MassProperties& sum = thing.object().mass_properties;
  CHECK(sum.mass == Approx(3));
  CHECK(sum.p_FCm.isApprox(Eigen::Vector3d(0, 0, 8 * 0.5 / 12), 1e-14));
  // The bottom, and four sides about the axis: the sides are 1 m away from it, and 2 m wide.
  CHECK(sum.I_Cm_F(2, 2) == Approx(1 * 4 / 6.0 + 2 * (1 + 4 / 12.0)));
  CHECK(thing.body().explicit_inertial);
  const Assembling heavy("parts:\n" + tray + ", density: 100}\n", 1, 0, folder.path());
  CHECK(heavy.findings() == std::vector<std::string>{"4:3 part 'a' is a shell and has no 'mass' (a "
                                                     "density does not say how thick a shell is)"});
  const Assembling seen("joints: none\nparts:\n" + tray + ", role: visual}\n", 1, 0, folder.path());
  CHECK(seen.part("thing_a").mass == 0);
}

TEST_CASE("missing and unreadable meshes are reported") {
  const TemporaryFolder folder;
  folder.Write("words.obj", "words\n");
  const Assembling thing(
      "parts:\n"
      "- {name: a, type: mesh, file: nowhere.obj}\n"
      "- {name: b, type: mesh, file: words.obj}\n",
      1, 0, folder.path());
  CHECK(thing.findings() ==
        std::vector<std::string>{"4:31 part 'a': no file 'nowhere.obj' (file names are relative to "
                                 "the folder of the spec)",
                                 "5:31 cannot read mesh 'words.obj': no triangles"});
}

TEST_CASE("a scale of zero is refused") {
  const TemporaryFolder folder;
  folder.Write("t.obj", kTetrahedron);
  const Assembling thing("parts: [{name: a, type: mesh, file: t.obj, scale: [1, 0, 1]}]\n", 1, 0,
                         folder.path());
  CHECK(thing.findings() == std::vector<std::string>{"3:51 scale of part 'a' is zero"});
}

}  // namespace
}  // namespace mjforge::assemble
