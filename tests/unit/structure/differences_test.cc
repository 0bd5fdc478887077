// Differences of structures, and their description.
#include <catch2/catch.hpp>

#include "mjforge/structure/structure.h"

#include "loaded.h"

namespace mjforge::structure {
namespace {

using Texts = std::vector<std::string>;

Texts Described(const std::string& a, const std::string& b) {
  Texts texts;
  for (const Difference& difference : DifferencesOf(Of(a), Of(b))) {
    texts.push_back(Describe(difference) + (difference.is_coincidence ? " (coincidence)" : ""));
  }
  return texts;
}

std::string Geom(const std::string& name, const std::string& rest = "") {
  return "<geom name=\"tool_" + name + "\" size='.1 .2 .3' pos='1 2 3' " + rest + "/>";
}
std::string Inertial(const std::string& pos) {
  return "<inertial pos='" + pos + "' mass='1' diaginertia='1 1 1'/>";
}

TEST_CASE("equal structures have no differences") {
  CHECK(Described(Geom("a"), Geom("a")) == Texts{});
}

TEST_CASE("a difference names the field, the elements and the values") {
  CHECK(Described(Geom("a", "type='box'") + Geom("b", "type='box'"),
                  Geom("a", "type='cylinder'") + Geom("b", "type='cylinder'")) ==
        Texts{"geom_type of 'a', 'b' is cylinder, not box"});
  CHECK(Described(Geom("a"), Geom("a", "contype='4'")) == Texts{"geom_contype of 'a' is 4, not 1"});
  CHECK(Described(Geom("a") + Geom("b") + Geom("c") + Geom("d"),
                  Geom("a", "condim='6'") + Geom("b", "condim='6'") + Geom("c", "condim='6'") +
                      Geom("d", "condim='6'")) ==
        Texts{"geom_condim of 'a', 'b', 'c' and 1 more is 6, not 3"});
}

TEST_CASE("counts name the elements that only one structure has") {
  CHECK(Described(Geom("a"), Geom("a") + Geom("b")) == Texts{"ngeom is 2, not 1 ('b')"});
  CHECK(Described(Geom("a"), Geom("b")) == Texts{"geom names differ ('b', not 'a')"});
}

TEST_CASE("elements that both structures have are compared if others are missing") {
  CHECK(Described(Geom("a") + Geom("b") + Geom("c"),
                  Geom("b") + Geom("c", "type='ellipsoid' condim='4'")) ==
        Texts{"ngeom is 2, not 3 ('a')", "geom_type of 'c' is ellipsoid, not sphere",
              "geom_condim of 'c' is 4, not 3"});
  // Ids of elements follow from the names.
  const std::string joints = "<joint name='tool_j'/><joint name='tool_k' axis='1 0 0'/>";
  CHECK(Described(Geom("a") + joints, Geom("a") + "<joint name='tool_k' axis='1 0 0'/>") ==
        Texts{"njnt is 1, not 2 ('j')"});
}

TEST_CASE("what follows from another difference is not reported") {
  // nv and the fields of degrees of freedom follow from the joint.
  CHECK(Described(Inertial("0 0 1") + Geom("a") + "<joint name='tool_j' type='ball'/>",
                  Inertial("0 0 1") + Geom("a") + "<joint name='tool_j' type='hinge'/>") ==
        Texts{"jnt_type of 'j' is hinge, not ball"});
}

TEST_CASE("coincidences are differences of their own kind") {
  CHECK(Described(Inertial("0 0 1") + Geom("a"), Inertial("0 0 0") + Geom("a")) ==
        Texts{"body_sameframe of 'root' is body, not bodyrot (coincidence)",
              "body_simple of 'root' is true, not false (coincidence)"});
  const std::string hinge = "<joint name='tool_j' frictionloss='";
  CHECK(Described(Geom("a") + hinge + "0'/>", Geom("a") + hinge + "0.1'/>") ==
        Texts{"dof_hasfrictionloss of 'j' is true, not false (coincidence)"});
  CHECK(Described(Inertial("1 0 0") + "<geom name='tool_a' size='1' pos='0 0 0'/>",
                  Inertial("1 0 0") + "<geom name='tool_a' size='1' pos='0 0 1'/>") ==
        Texts{"geom_sameframe of 'a' is bodyrot, not body (coincidence)"});
  CHECK(Described(Geom("a") + "<site name='tool_s' quat='0 1 0 0'/>",
                  Geom("a") + "<site name='tool_s'/>") ==
        Texts{"site_sameframe of 's' is body, not none (coincidence)"});
}

TEST_CASE("meshes are compared by their numbers of vertices and faces") {
  const auto mesh = [](const std::string& name, const std::string& vertices) {
    return Of(Inertial("0 0 1") + Geom("a", "type='mesh' mesh='" + name + "'"), "tool", vertices);
  };
  const std::string block = "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1";
  const Structure wedge = mesh("wedge", "0 0 0 1 0 0 0 1 0 0 0 1");
  CHECK(mesh("wedge", "0 0 0 1 0 0 0 1 0 0 0 2") == wedge);
  const std::vector<Difference> counts = DifferencesOf(wedge, mesh("wedge", block));
  REQUIRE(counts.size() == 2);
  CHECK(Describe(counts[0]) == "mesh_vertnum of 'wedge' is 5, not 4");
  CHECK(Describe(counts[1]) == "mesh_facenum of 'wedge' is 6, not 4");
  const std::vector<Difference> other =
      DifferencesOf(wedge, mesh("other", "0 0 0 1 0 0 0 1 0 0 0 1"));
  REQUIRE(other.size() == 1);
  CHECK(Describe(other[0]) == "geom_dataid of 'a' is 1, not 0");
}

}  // namespace
}  // namespace mjforge::structure
