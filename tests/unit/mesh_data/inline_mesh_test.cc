#include <catch2/catch.hpp>

#include "mjforge/mesh_data/mesh_data.h"

namespace mjforge::mesh_data {
namespace {

constexpr std::string_view kVertex = "0 0 0 1 0 0 0 1 0 0 0 1";

std::string FaceFault(std::string_view face) {
  return FindFault({.vertex = kVertex, .face = face});
}

TEST_CASE("each index of an inline mesh is that of a vertex") {
  CHECK(FaceFault("0 2 1 0 1 3").empty());
  CHECK(FaceFault("").empty());
  CHECK(FaceFault("0 2 1 0 1 9999999") == "face 1 uses vertex 9999999 of 4, counted from 0");
  CHECK(FaceFault("0 2 4") == "face 0 uses vertex 4 of 4, counted from 0");
  CHECK(FaceFault("0 2 -1") == "face 0 uses vertex -1 of 4, counted from 0");
  CHECK(FaceFault("0 2 4294967299") == "face 0 uses vertex 4294967299 of 4, counted from 0");
  CHECK(FaceFault("0 2 1.5") == "'1.5' in its 'face' is not an index");
  CHECK(FaceFault("0 2 0x1") == "'0x1' in its 'face' is not an index");
}

TEST_CASE("faces of an element with a file use the vertices of the file") {
  CHECK(FindFault({.face = "0 1 2", .file_vertices = 3}).empty());
  CHECK(FindFault({.face = "0 1 3", .file_vertices = 3}) ==
        "face 0 uses vertex 3 of 3, counted from 0");
  CHECK(FindFault({.face = "0 1 3"}) == "face 0 uses vertex 0 of 0, counted from 0");
}

TEST_CASE("each number of an inline mesh is finite as float") {
  CHECK(FindFault({.vertex = "0 0 nan"}) == "'nan' in its 'vertex' is not a finite number");
  CHECK(FindFault({.vertex = "0 0 1e39"}) == "'1e39' in its 'vertex' is not a finite number");
  CHECK(FindFault({.vertex = "0 0 1x"}) == "'1x' in its 'vertex' is not a finite number");
  CHECK(FindFault({.normal = "inf"}) == "'inf' in its 'normal' is not a finite number");
  CHECK(FindFault({.texcoord = "-inf"}) == "'-inf' in its 'texcoord' is not a finite number");
  CHECK(FindFault({.vertex = kVertex, .normal = "\n+1. .5 -1E-3\t"}).empty());
}

}  // namespace
}  // namespace mjforge::mesh_data
