#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "adapted.h"

namespace mjforge::mjcf {
namespace {

using namespace adapted;

std::string Names(const std::vector<model::Part>& parts) {
  std::string names;
  for (const model::Part& part : parts) names += part.name + " ";
  return names;
}

/// Returns two cylinders of equal size, an ellipsoid and a capsule.
model::Object Rounds() {
  model::Object object = hand_made::Empty("rounds");
  std::vector<model::Part>& parts = object.bodies[0].parts;
  parts.push_back(hand_made::Solid("can", GeomType::kCylinder, {0.03, 0.05, 0},
                                   {{0.1, 0, 0}, model::FromEuler({0.2, 0.3, 0})}, 10));
  parts.back().attributes = {Numbers("rgba", Applies::kVisual, {1, 0, 0, 1}),
                             Numbers("friction", Applies::kCollision, {2})};
  parts.back().material = 0;
  object.materials.emplace_back().name = "tin";
  parts.push_back(hand_made::Solid("tin_can", GeomType::kCylinder, {0.03, 0.05, 0}, {}, 11));
  parts.back().role = Role::kCollision;
  parts.push_back(hand_made::Solid("egg", GeomType::kEllipsoid, {0.02, 0.03, 0.04}, {}, 12));
  parts.push_back(hand_made::Solid("pill", GeomType::kCapsule, {0.01, 0.02, 0}, {}, 13));
  hand_made::Weigh(object);
  return object;
}

TEST_CASE("for MJX cylinders and ellipsoids collide as convex meshes") {
  model::Object object = Rounds();
  const model::MassProperties meant = object.bodies[0].mass_properties;
  CHECK(Adapted(object, "mjx") ==
        Said{"10: mjx does not collide cylinders and ellipsoids with boxes and meshes: 2 cylinders "
             "collide as 16-sided prisms, 1 ellipsoid collides as a 42-cornered mesh"});
  const std::vector<model::Part>& parts = object.bodies[0].parts;
  CHECK(Names(parts) == "can can tin_can egg egg pill ");
  REQUIRE(object.meshes.size() == 2);  // the cans share a mesh
  CHECK(object.meshes[0]->name == "can_convex");
  CHECK(object.meshes[1]->name == "egg_convex");
  for (const model::Part& part : parts) {
    const bool is_round =
        part.shape.type == GeomType::kCylinder || part.shape.type == GeomType::kEllipsoid;
    CHECK((part.role == Role::kVisual) == is_round);
  }
  CHECK(object.bodies[0].explicit_inertial);
  CHECK(object.bodies[0].mass_properties.mass == meant.mass);
  CHECK(object.bodies[0].mass_properties.I_Cm_F == meant.I_Cm_F);

  const pugi::xml_document file = Written(object, "mjx");
  const pugi::xml_node can = file.select_node("//geom[@name='can']").node();
  CHECK(std::string(can.attribute("type").value()) == "mesh");
  CHECK(std::string(can.attribute("friction").value()) == "2");
  CHECK(std::string(can.attribute("rgba").value()) == "0.5 0 0 1");
  CHECK_FALSE(can.attribute("material"));
  const pugi::xml_node look = file.select_node("//geom[@name='can_vis']").node();
  CHECK(std::string(look.attribute("type").value()) == "cylinder");
  CHECK(std::string(look.attribute("material").value()) == "tin");
}

TEST_CASE("the meshes for MJX reach the true shape's bounds and are solid inside it") {
  model::Object object = Rounds();
  Adapted(object, "mjx");
  const model::Shape shapes[] = {{GeomType::kCylinder, {0.03, 0.05, 0}, nullptr},
                                 {GeomType::kEllipsoid, {0.02, 0.03, 0.04}, nullptr}};
  const double shares[] = {0.97, 0.87};  // of the volume of the true shape
  for (std::size_t i = 0; i < 2; ++i) {
    const model::TriangleMesh& mesh = object.meshes[i]->mesh;
    CHECK_FALSE(model::FindSurfaceDefect(mesh));
    const model::Shape hull{GeomType::kMesh, Eigen::Vector3d::Zero(), &mesh};
    const model::Box3 box = model::BoundsOf(hull, {});
    const model::Box3 meant = model::BoundsOf(shapes[i], {});
    CHECK(box.max.isApprox(meant.max, 1e-12));
    CHECK(box.min.isApprox(meant.min, 1e-12));
    const double share = model::Volume(hull) / model::Volume(shapes[i]);
    CHECK(share > shares[i]);
    CHECK(share < 1);
  }
  CHECK(object.meshes[0]->mesh.vertices.size() == 32);
  CHECK(object.meshes[1]->mesh.vertices.size() == 42);
}

TEST_CASE("for MJX what refers to a replaced geom goes to its true shape, contacts aside") {
  model::Object object = Rounds();
  Add(object, "contact",
      {Made("contact", "pair", "touch", 20, {Text("geom1", "can"), Text("geom2", "pill")})});
  model::Element tendon = Made("tendon", "spatial", "rope", 21);
  model::Element wrap;
  wrap.tag = "geom";
  wrap.attributes = {{"geom", Applies::kBoth, {}, "tin_can", "geom"}};
  tendon.children.push_back(wrap);
  Add(object, "tendon", {tendon});
  Add(object, "sensor",
      {Made("sensor", "framepos", "where", 22, {Text("objtype", "geom"), Text("objname", "can")})});
  CHECK(Adapted(object, "mjx").size() == 1);
  CHECK(ElementsOf(object, "contact")[0].attributes[0].text == "can");
  CHECK(ElementsOf(object, "tendon")[0].children[0].attributes[0].text == "tin_can_vis");
  CHECK(ElementsOf(object, "sensor")[0].attributes[1].text == "can_vis");
  CHECK(Names(object.bodies[0].parts) == "can can tin_can tin_can egg egg pill ");
}

}  // namespace
}  // namespace mjforge::mjcf
