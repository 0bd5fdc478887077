#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

const std::vector<std::string> kPinned = {"inspect", "crate.yaml", "--set", "height=0.15"};

std::vector<std::string> With(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_CASE_METHOD(CrateTest, "inspect shows parameters, parts, joints, bounds and mass") {
  const auto result = Run(kPinned);
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  CHECK(result.out ==
        "crate: A box.\n"
        "\n"
        "parameter  spec  here  unit  doc\n"
        "height     0.15  0.15  m     Half the height.\n"
        "\n"
        "seed 0, index 0, attempt 0\n"
        "\n"
        "part        type  role  size          pos    kg\n"
        "crate_body  box   both  0.1 0.1 0.15  0 0 0  6\n"
        "\n"
        "joint         type\n"
        "crate_joint0  free\n"
        "\n"
        "bounds   -0.1 -0.1 -0.15 to 0.1 0.1 0.15 m\n"
        "mass     6 kg\n"
        "com      0 0 0 m\n"
        "inertia  0.065 0.065 0.04  0 0 0 kg m^2 (xx yy zz  xy xz yz)\n"
        "radius   0.141421 m about the z axis\n");
}

TEST_CASE_METHOD(CrateTest, "inspect shows a range as the spec has it, and the value drawn") {
  const auto first = Run({"inspect", "crate.yaml", "--seed", "7", "--index", "1"});
  CHECK(first.out.find("height     0.1 .. 0.2  0.1") != std::string::npos);
  CHECK(first.out.find("seed 7, index 1, attempt 0") != std::string::npos);
  CHECK(first.out != Run({"inspect", "crate.yaml", "--seed", "7", "--index", "2"}).out);
}

TEST_CASE_METHOD(CrateTest, "inspect --json is one object") {
  const auto result = Run(With(kPinned, {"--json"}));
  CHECK(result.status == 0);
  CHECK(
      result.out.starts_with("{\"name\":\"crate\",\"description\":\"A box.\","
                             "\"spec\":\"crate.yaml\",\"spec_sha256\":\""));
  CHECK(result.out.find("\"parameters\":[{\"name\":\"height\",\"spec\":\"0.15\",\"value\":0.15,"
                        "\"unit\":\"m\",\"doc\":\"Half the height.\"}]") != std::string::npos);
  CHECK(result.out.find("\"aabb\":{\"min\":[-0.1,-0.1,-0.15],\"max\":[0.1,0.1,0.15]},"
                        "\"mass\":6,\"com\":[0,0,0],") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "inspect --contains says whether a point is inside") {
  const auto contains = [&](const char* point) {
    const auto result = Run(With(kPinned, {"--contains", point}));
    CHECK(result.status == 0);
    return result.out;
  };
  CHECK(contains("0,0,0.149") == "inside\n");
  CHECK(contains("-0.1,0.1,0.15") == "inside\n");
  CHECK(contains("0,0,-0.151") == "outside\n");
  CHECK(Run(With(kPinned, {"--contains", "0,0,0", "--json"})).out == "{\"contains\":true}\n");
  const auto bad = Run(With(kPinned, {"--contains", "0,0"}));
  CHECK(bad.status == 2);
  CHECK(bad.err ==
        "mjforge: error: --contains: '0,0' is not of the form X,Y,Z\n"
        "  hint: see 'mjforge inspect --help'\n");
}

TEST_CASE_METHOD(CrateTest, "inspect of an MJCF file shows what MuJoCo compiled") {
  REQUIRE(Run({"generate", "crate.yaml", "--set", "height=0.15", "-q", "-o", "x.xml"}).status == 0);
  const auto result = Run({"inspect", "x.xml"});
  CHECK(result.status == 0);
  CHECK(result.out.find("mass     6 kg\n") != std::string::npos);
  CHECK(result.out.find("bounds   -0.1 -0.1 -0.15 to 0.1 0.1 0.15 m\n") != std::string::npos);
  CHECK(Run({"inspect", "x.xml", "--json"}).out.find("\"mass\":6,") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "inspect of what is not there is a finding") {
  CHECK(Run({"inspect", "none.yaml"}).status == 3);
  const auto result = Run({"inspect", "none.xml"});
  CHECK(result.status == 3);
  CHECK(result.out.empty());
}

}  // namespace
}  // namespace mjforge
