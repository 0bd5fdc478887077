// Padding of objects: null elements, order and names.

#include "mjforge/padding/padding.h"

#include <catch2/catch.hpp>

#include "harness/spec_object.h"

namespace mjforge::padding {
namespace {

using harness::ObjectOf;
using Texts = std::vector<std::string>;

// Completes the objects of specs by the elements of all.
std::vector<model::Object> Completed(const Texts& bodies) {
  Superset superset;
  for (const std::string& body : bodies) superset.Add(ObjectOf(body));
  std::vector<model::Object> objects;
  for (const std::string& body : bodies) {
    objects.push_back(ObjectOf(body));
    superset.Complete(objects.back());
  }
  return objects;
}

template <typename Elements>
Texts NamesOf(const Elements& elements) {
  Texts names;
  for (const auto& element : elements) {
    if constexpr (requires { element.name; })
      names.push_back(element.name);
    else
      names.push_back(element->name);
  }
  return names;
}

const model::Part& PartOf(const model::Object& object, const std::string& name) {
  const std::vector<model::Part>& parts = object.bodies[0].parts;
  const auto found = std::ranges::find(parts, name, &model::Part::name);
  REQUIRE(found != parts.end());
  return *found;
}

constexpr const char* kCore =
    "  - {name: core, type: box, size: [0.1, 0.1, 0.3], pos: [1, 0, 0]}\n";

TEST_CASE("a part that a variant lacks is null and in the largest part") {
  const std::string knob =
      "  - {name: knob, type: sphere, size: 0.05, friction: [2, 0, 0], margin: 0.01,\n"
      "     condim: 4, material: red, fluidshape: ellipsoid}\n";
  const std::string materials = "materials: {red: {rgba: [1, 0, 0, 1]}}\nparts:\n";
  const auto objects = Completed({materials + kCore, materials + knob + kCore});
  CHECK(NamesOf(objects[0].bodies[0].parts) == Texts{"knob", "core"});
  CHECK(NamesOf(objects[1].bodies[0].parts) == Texts{"knob", "core"});
  const model::Part& null = PartOf(objects[0], "knob");
  CHECK(null.X_BG.p == Eigen::Vector3d(1, 0, 0));
  CHECK(null.shape.size[0] == 1e-6);
  CHECK(null.mass == 0);
  CHECK(null.density == 0);
  CHECK(null.material == -1);
  CHECK(model::FindAttribute(null.attributes, "margin")->numbers == sample::Numbers{-2000});
  CHECK(model::FindAttribute(null.attributes, "gap")->numbers == sample::Numbers{1000});
  REQUIRE(model::FindAttribute(null.attributes, "condim") != nullptr);
  CHECK(model::FindAttribute(null.attributes, "fluidshape") == nullptr);
  CHECK(model::FindAttribute(null.attributes, "rgba")->numbers == sample::Numbers{0, 0, 0, 0});
  CHECK(PartOf(objects[1], "knob").shape.size[0] == 0.05);
  CHECK(model::FindAttribute(PartOf(objects[1], "knob").attributes, "margin")->numbers ==
        sample::Numbers{0.01});
}

TEST_CASE("parts of another type have a name of their own, and references follow") {
  const std::string sensor =
      "mjcf:\n  sensor: [{framepos: {name: where, objtype: geom, objname: grip}}]\n";
  const auto with = [&](const std::string& shape) {
    return "parts:\n" + std::string(kCore) + "  - {name: grip, " + shape + "}\n" + sensor;
  };
  const auto objects =
      Completed({with("type: box, size: [0.1, 0.1, 0.1]"), with("type: cylinder, size: [0.1, 0.1]"),
                 with("type: box, size: [0.1, 0.1, 0.1], condim: 1")});
  const Texts names = {"core", "grip.box", "grip.cylinder", "grip"};
  for (const model::Object& object : objects) {
    Texts sorted = NamesOf(object.bodies[0].parts);
    CHECK(sorted == NamesOf(objects[0].bodies[0].parts));
    CHECK(std::ranges::is_permutation(sorted, names));
  }
  const auto referred = [](const model::Object& object) {
    return model::FindAttribute(object.sections[0].elements[0].attributes, "objname")->text;
  };
  CHECK(referred(objects[0]) == "grip");
  CHECK(referred(objects[1]) == "grip.cylinder");
  CHECK(referred(objects[2]) == "grip.box");
  CHECK(PartOf(objects[1], "grip.cylinder").shape.size[0] == 0.1);
  CHECK(PartOf(objects[1], "grip").shape.size[0] == 1e-6);
}

TEST_CASE("sites are completed, too") {
  const std::string parts = "parts:\n" + std::string(kCore);
  const auto objects = Completed({parts + "sites: [{name: grasp, size: 0.02}]\n", parts});
  REQUIRE(NamesOf(objects[1].bodies[0].sites) == Texts{"grasp"});
  CHECK(objects[1].bodies[0].sites[0].size[0] == 1e-6);
  CHECK(objects[0].bodies[0].sites[0].size[0] == 0.02);
}

TEST_CASE("a part with a mesh that may be null shares it with no other part") {
  const std::string one =
      "  - {name: a, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: 1}\n";
  const std::string two =
      "  - {name: b, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: 1, pos: [3, 0, 0]}\n";
  const auto objects = Completed({"parts:\n" + one + two, "parts:\n" + one});
  CHECK(NamesOf(objects[0].meshes) == NamesOf(objects[1].meshes));
  for (const model::Object& object : objects) {
    for (const model::Part& part : object.bodies[0].parts) {
      REQUIRE(part.mesh >= 0);
      CHECK(part.shape.mesh == &object.meshes[static_cast<std::size_t>(part.mesh)]->mesh);
    }
  }
  for (std::size_t i = 0; i < objects[0].bodies[0].parts.size(); ++i) {
    const model::Part& part = objects[0].bodies[0].parts[i];
    CHECK(part.mesh == objects[1].bodies[0].parts[i].mesh);
    CHECK(part.shape.mesh->vertices.size() ==
          objects[1].bodies[0].parts[i].shape.mesh->vertices.size());
  }
  const auto size = [](const model::Part& part) {
    const model::Box3 box = model::BoundsOf(part.shape, part.X_BG);
    return (box.max - box.min).maxCoeff();
  };
  CHECK(size(PartOf(objects[0], "b")) == Approx(1));
  CHECK(size(PartOf(objects[1], "b")) == Approx(2e-4));
  CHECK(model::Contains(PartOf(objects[1], "a").shape, PartOf(objects[1], "a").X_BG,
                        PartOf(objects[1], "b").X_BG.p));
}

TEST_CASE("a null geom of a body without colliding parts is at its origin") {
  const std::string core = "parts:\n" + std::string(kCore);
  const std::string look = "{name: look, type: sphere, size: 0.1, pos: [1, 1, 1], role: visual}";
  const auto objects = Completed(
      {core + "bodies: [{name: arm, parts: [{name: bar, type: box, size: [0.1, 0.1, 0.1]}]}]\n",
       core + "bodies: [{name: arm, parts: [" + look + "]}]\n"});
  REQUIRE(NamesOf(objects[1].bodies[1].parts) == Texts{"look", "bar"});
  CHECK(objects[1].bodies[1].parts[1].X_BG.p == Eigen::Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace mjforge::padding
