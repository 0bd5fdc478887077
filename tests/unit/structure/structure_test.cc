// Keys of structures.
#include "mjforge/structure/structure.h"

#include <catch2/catch.hpp>

#include "loaded.h"

namespace mjforge::structure {
namespace {

constexpr const char* kHandle =
    R"(<geom name="tool_handle" type="box" size=".1 .2 .3" pos="1 0 0"/>)";

TEST_CASE("numbers and appearance do not change the structure") {
  const std::string key = Of(kHandle).Key();
  CHECK(key.size() == 12);
  CHECK(key.find_first_not_of("0123456789abcdef") == key.npos);
  CHECK(Of(R"(<geom name="tool_handle" type="box" size=".4 .2 .3" pos="1 2 0" density="7"
                    friction="2" rgba="1 0 0 1"/>)")
            .Key() == key);
  CHECK(Of(R"(<geom name="tool_handle" type="box" size=".1 .2 .3" pos="1 0 0" material="red"/>)")
            .Key() == key);
}

TEST_CASE("the name of the object does not change the structure") {
  const Structure tool = Of(kHandle);
  CHECK(Of(R"(<geom name="axe_handle" type="box" size=".1 .2 .3" pos="1 0 0"/>)", "axe") == tool);
  CHECK(Of(R"(<geom name="toolhandle" type="box" size=".1 .2 .3" pos="1 0 0"/>)").Key() !=
        tool.Key());
}

TEST_CASE("integers change the structure") {
  const std::string key = Of(kHandle).Key();
  for (const char* other :
       {R"(<geom name="tool_handle" type="ellipsoid" size=".1 .2 .3" pos="1 0 0"/>)",
        R"(<geom name="tool_handle" type="box" size=".1 .2 .3" pos="1 0 0" contype="2"/>)",
        R"(<geom name="tool_handle" type="box" size=".1 .2 .3" pos="1 0 0" conaffinity="2"/>)",
        R"(<geom name="tool_handle" type="box" size=".1 .2 .3" pos="1 0 0" condim="4"/>)",
        R"(<geom name="tool_handle" type="box" size=".1 .2 .3" pos="1 0 0" group="2"/>)",
        R"(<geom name="tool_grip" type="box" size=".1 .2 .3" pos="1 0 0"/>)",
        R"(<freejoint/><geom name="tool_handle" type="box" size=".1 .2 .3" pos="1 0 0"/>)"}) {
    CAPTURE(other);
    CHECK(Of(other).Key() != key);
  }
}

TEST_CASE("an empty structure has no key") { CHECK(Structure().Key().empty()); }

TEST_CASE("frames of meshes do not change the structure") {
  // Each release has its own frame of a mesh; a turned mesh may coincide with the body by chance.
  const auto mesh = [](const char* pose) {
    return Of(R"(<inertial pos=".1 .2 .3" mass="1" diaginertia="1 1 1"/>
                 <geom name="tool_blade" type="mesh" mesh="wedge" )" +
              std::string(pose) + "/>");
  };
  CHECK(mesh("pos='0 0 0'") == mesh("pos='1 2 3' quat='0 1 0 0'"));
}

}  // namespace
}  // namespace mjforge::structure
