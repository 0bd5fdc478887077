#include "mjforge/engine/referenced_files.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/engine/engine.h"

namespace mjforge::engine {
namespace {

std::string MeshesIn(const std::string& file) {
  return "<mujoco>\n<asset>\n<mesh name=\"m\"\nfile=\"" + file + "\"/></asset></mujoco>";
}

TEST_CASE("a file that MuJoCo would wait for is a fault at its element") {
  const harness::TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe.stl").c_str(), 0600) == 0);
  folder.Write("mesh.stl", "solid");
  std::filesystem::create_directory(folder / "folder.stl");
  CHECK_FALSE(FindFileFault(MeshesIn("mesh.stl"), folder.path()));
  CHECK_FALSE(FindFileFault(MeshesIn("missing.stl"), folder.path()));
  CHECK_FALSE(FindFileFault(MeshesIn(""), folder.path()));
  const auto fault = FindFileFault(MeshesIn("pipe.stl"), folder.path());
  REQUIRE(fault);
  CHECK(fault->code == diag::Code::kYamlCannotRead);
  CHECK(fault->line == 3);
  CHECK(MeshesIn("pipe.stl").substr(fault->offset).starts_with("<mesh "));
  CHECK(fault->message ==
        "cannot read '" + (folder / "pipe.stl").string() + "', the file of mesh 'm': it is a pipe");
  CHECK(FindFileFault(MeshesIn("folder.stl"), folder.path()));
  CHECK(FindFileFault(MeshesIn((folder / "pipe.stl").string()), {}));
  folder.Write("inner.xml", MeshesIn("pipe.stl"));
  const std::string outer = "<mujoco>\n<size/><include file=\"inner.xml\"/></mujoco>";
  const auto inner = FindFileFault(outer, folder.path());
  REQUIRE(inner);
  CHECK(inner->line == 2);
  CHECK(outer.substr(inner->offset).starts_with("<include "));
  Engine engine;
  const Loaded loaded = engine.LoadTextIn(folder.path(), MeshesIn("pipe.stl"));
  CHECK_FALSE(loaded.model);
  CHECK(loaded.error == fault->message);
  CHECK(loaded.fault);
}

TEST_CASE("a mesh with an index out of range is a fault at its element") {
  const harness::TemporaryFolder folder;
  folder.Write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  const auto in_file = FindFileFault(MeshesIn("bad.obj"), folder.path());
  REQUIRE(in_file);
  CHECK(in_file->code == diag::Code::kModelBadMesh);
  CHECK(in_file->line == 3);
  CHECK(in_file->message == "cannot read '" + (folder / "bad.obj").string() +
                                "', the file of mesh 'm': line 4: a face uses vertex 9 of 3");
  const std::string mesh = R"(<mesh name="t" vertex="0 0 0 1 0 0 0 1 0 0 0 1" face="0 2 9"/>)";
  const auto in_text = FindFileFault("<mujoco>\n<asset>" + mesh + "</asset></mujoco>", {});
  REQUIRE(in_text);
  CHECK(in_text->line == 2);
  CHECK(in_text->message == "mesh 't': face 0 uses vertex 9 of 4, counted from 0");
  const auto skin = FindFileFault(
      R"(<mujoco><asset><skin name="s" vertex="0 0 0 1 0 0 0 1 0" face="0 1 3"/></asset></mujoco>)",
      {});
  REQUIRE(skin);
  CHECK(skin->message == "skin 's': face 0 uses vertex 3 of 3, counted from 0");
  folder.Write("meshes.xml", "<mujocoinclude>" + mesh + "</mujocoinclude>");
  CHECK(FindFileFault(R"(<mujoco><asset><include file="meshes.xml"/></asset></mujoco>)",
                      folder.path()));
  Engine engine;
  CHECK(engine.LoadTextIn(folder.path(), MeshesIn("bad.obj")).fault);
  const auto problem = engine.SetAssets({{.name = "bad.obj", .file = folder / "bad.obj"}});
  REQUIRE(problem);
  CHECK(problem->code == diag::Code::kModelBadMesh);
}

TEST_CASE("the last setting of a folder counts, in the order of the document") {
  const harness::TemporaryFolder folder;
  folder.Write("sub/mesh.stl", "solid");
  folder.Write("inner.xml",
               "<mujoco><include file=\"inner.xml\"/><compiler meshdir=\".\"/></mujoco>");
  REQUIRE(::mkfifo((folder / "pipe.stl").c_str(), 0600) == 0);
  const std::string include = "<include file=\"inner.xml\"/>";
  const std::string sub = "<compiler meshdir=\"sub\"/>";
  const auto is_fault = [&](const std::string& sections) {
    const std::string asset = "<asset><mesh file=\"pipe.stl\"/></asset>";
    return FindFileFault("<mujoco>" + sections + asset + "</mujoco>", folder.path()).has_value();
  };
  CHECK_FALSE(is_fault(include + sub));
  CHECK(is_fault(sub + include));
}

}  // namespace
}  // namespace mjforge::engine
