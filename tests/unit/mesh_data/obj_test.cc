#include <catch2/catch.hpp>

#include "mjforge/mesh_data/mesh_data.h"

namespace mjforge::mesh_data {
namespace {

constexpr std::string_view kObjVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

/// Returns the fault of a file with four vertices and these further lines, which begin with line 5.
std::string FaultOf(std::string_view lines) {
  return CheckFile(Format::kObj, std::string(kObjVertices).append(lines)).fault;
}

TEST_CASE("each index of an OBJ file is that of a vertex") {
  CHECK(FaultOf("f 1 3 2\nf 1 2 4\r\n f -4 -1 -3 # comment\n").starts_with("line 7: '#'"));
  CHECK(FaultOf("f 1 3 2\nf 1 2 4\r\n\tf -4 -1 -3\n").empty());
  CHECK(FaultOf("f 1 3 5\nv 0 0 0").empty());
  CHECK(FaultOf("f 1 2 3\n\nf 1 2 9") == "line 7: a face uses vertex 9 of 4");
  CHECK(FaultOf("f 1 2 -5") == "line 5: a face uses vertex -5 of 4");
  CHECK(FaultOf("f 0 1 2") == "line 5: a face uses vertex 0 of 4");
  CHECK(FaultOf("f 2 3 4294967300") == "line 5: a face uses vertex 4294967300 of 4");
  CHECK(FaultOf("f 2 3 18446744073709551620") ==
        "line 5: a face uses vertex 18446744073709551620 of 4");
  CHECK(CheckFile(Format::kObj, kObjVertices).vertices == 4);
}

TEST_CASE("lines of an OBJ file end as on each system") {
  CHECK(FaultOf("\r\n\r\nf 9 1 2") == "line 7: a face uses vertex 9 of 4");
  CHECK(FaultOf("\r\rf 9 1 2") == "line 7: a face uses vertex 9 of 4");
}

TEST_CASE("an index of an OBJ file is an integer") {
  CHECK(FaultOf("f 1.5 2 3") == "line 5: '1.5' is not the number of a vertex");
  CHECK(FaultOf("f 1 2 4x") == "line 5: '4x' is not the number of a vertex");
  CHECK(FaultOf("f /1 2 3") == "line 5: '' is not the number of a vertex");
  CHECK(FaultOf("f 1/x 2 3") == "line 5: 'x' is not the number of a texture coordinate");
  CHECK(FaultOf("f 1/1/1/1 2 3") == "line 5: '1/1/1/1' is not a corner of a face");
}

TEST_CASE("normals and texture coordinates of an OBJ file have the indices of faces") {
  CHECK(FaultOf("vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\n").empty());
  CHECK(FaultOf("vn 0 0 1\nf 1//1 2//7 3//1") == "line 6: a face uses normal 7 of 1");
  CHECK(FaultOf("vt 0 0\nf 1/1 2/2 3/1") == "line 6: a face uses texture coordinate 2 of 1");
  CHECK(FaultOf("vt 0 0\nf 1/-2 2/1 3/1") == "line 6: a face uses texture coordinate -2 of 1");
  CHECK(FaultOf("f 1/1/1 2/2/2 3/3/3").empty());  // nothing reads the indices
}

TEST_CASE("each number of an OBJ file is finite as float, used or not") {
  CHECK(FaultOf("v nan 0 0\n") == "line 5: 'nan' of a vertex is not a finite number");
  CHECK(FaultOf("v 0 1e39 0\n") == "line 5: '1e39' of a vertex is not a finite number");
  CHECK(FaultOf("vn 0 0 inf\n") == "line 5: 'inf' of a normal is not a finite number");
  CHECK(FaultOf("vt 0 1x\n") == "line 5: '1x' of a texture coordinate is not a finite number");
  CHECK(FaultOf("v 1 0\n") == "line 5: a vertex has fewer than 3 numbers");
  CHECK(FaultOf("v 1 0 0 1 .5 .5 .5\nvt .5\no name\n# f 9\nvp 1\nl 1 9\n").empty());
}

}  // namespace
}  // namespace mjforge::mesh_data
