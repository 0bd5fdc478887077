#include "mjforge/mesh_data/mesh_data.h"

#include <catch2/catch.hpp>

namespace mjforge::mesh_data {
namespace {

TEST_CASE("the last three letters of a file's name are its format") {
  CHECK(FormatOf("rod.OBJ") == Format::kObj);
  CHECK(FormatOf("/meshes/rod.stl") == Format::kStl);
  CHECK(FormatOf("msh") == Format::kMsh);
  CHECK_FALSE(FormatOf("rod.png"));
  CHECK_FALSE(FormatOf("a"));
  CHECK_FALSE(FormatOf(""));
}

}  // namespace
}  // namespace mjforge::mesh_data
