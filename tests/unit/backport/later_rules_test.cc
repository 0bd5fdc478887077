#include "mjforge/backport/later_rules.h"

#include <array>
#include <string>

#include "backported.h"

namespace mjforge::backport {
namespace {

/// A file that was changed by the rules of later releases, and loaded.
struct Compiled {
  explicit Compiled(const std::string& inner) {
    const auto file = folder.Write("m.xml", "<mujoco>\n" + inner + "\n</mujoco>\n");
    diag::Sources sources;
    diag::Findings found;
    std::optional<xml::XmlElement> root = xml::ReadXml(file, sources, found);
    REQUIRE(root);
    engine::Engine engine;
    rules = ApplyLaterRules(*root, [&](const std::string& text) { return engine.LoadText(text); });
    text = xml::FlattenInPlace(*root);
    loaded = engine.LoadText(text);
  }
  const mjModel& model() const {
    INFO(loaded.error);
    REQUIRE(loaded.model);
    return *loaded.model;
  }

  harness::TemporaryFolder folder;
  RuleDifferences rules;
  std::string text;
  engine::Loaded loaded;
};

/// A geom that is fitted to a corner of a cuboid.
std::string Fitted(const std::string& type, const std::string& geom = {},
                   const std::string& defaults = {}) {
  return "<compiler fitaabb=\"true\"/><default><default class=\"t\"><mesh scale=\"2 1 1\"/><geom "
         "density=\"10\" " +
         defaults +
         "/></default></default><asset><mesh class=\"t\" name=\"m\" vertex=\"1 0 0 2 0 0 1 1 0 1 0 "
         "3\"/></asset><worldbody><body name=\"b\"><freejoint/>\n<geom class=\"t\" name=\"g\" "
         "type=\"" +
         type + "\" pos=\"0 0 1\" " + geom + " fitscale=\"1.5\"/></body></worldbody>";
}

TEST_CASE("shapes are fitted to bounding boxes as by MuJoCo 3.3.7") {
  struct Expected {
    std::string type;
    double mass;  // kg
    std::array<double, 3> size;
  };
  // MuJoCo 3.3.7 computes these numbers.
  const Expected all[] = {{"sphere", 737.906649, {2.6019819, 0, 0}},
                          {"capsule", 333.722625, {1.60270759, 0.999274315, 0}},
                          {"cylinder", 419.9453, {1.60270759, 2.6019819, 0}},
                          {"ellipsoid", 123.082666, {0.704611493, 1.60270759, 2.6019819}},
                          {"box", 235.070577, {0.704611493, 1.60270759, 2.6019819}}};
  constexpr double kPos[] = {-0.104904111, 2.45151507, 2.3245257};
  for (const auto& [type, mass, size] : all) {
    for (const bool of_class : {false, true}) {
      INFO(type);
      const Compiled compiled(of_class ? Fitted(type, "euler=\"0 0 90\"", "mesh=\"m\"")
                                       : Fitted(type, "mesh=\"m\" euler=\"0 0 90\""));
      const mjModel& m = compiled.model();
      CHECK(m.body_mass[1] == Approx(mass).epsilon(1e-5));
      for (int i = 0; i < 3; ++i) {
        CHECK(m.geom_size[i] == Approx(size[static_cast<std::size_t>(i)]).epsilon(1e-5));
        CHECK(m.geom_pos[i] == Approx(kPos[i]).epsilon(1e-5));
      }
      CHECK(compiled.rules.fitted.line == (mjVERSION_HEADER < 337 ? 3 : 0));
    }
  }
}

TEST_CASE("a geom stays fitted to its mesh if it cannot be replaced") {
  // The orientation is that of a default class, the size would be 0, or the shape is not fitted to
  // a bounding box.
  CHECK_FALSE(Compiled(Fitted("box", "mesh=\"m\"", "euler=\"0 0 9\"")).rules);
  CHECK_FALSE(
      Compiled("<compiler fitaabb=\"true\"/><asset><mesh name=\"m\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 "
               "1\"/></asset><worldbody><geom type=\"box\" mesh=\"m\" fitscale=\"0\"/></worldbody>")
          .rules);
  CHECK_FALSE(
      Compiled("<asset><mesh name=\"m\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 .9\"/></asset><worldbody>"
               "<geom type=\"capsule\" mesh=\"m\"/></worldbody>")
          .rules);
}

TEST_CASE("`discardvisual` keeps geoms that an element refers to") {
  const std::string visual = " size=\".1\" contype=\"0\" conaffinity=\"0\"/>";
  const std::string bodies =
      "<compiler discardvisual=\"true\"/><worldbody><body name=\"a\">\n<geom name=\"kept\"" +
      visual + "<geom name=\"lost\"" + visual +
      "<geom size=\".1\"/></body><body name=\"b\" pos=\"1 0 0\"><freejoint/><geom name=\"h\" "
      "size=\".1\" mass=\"1\"/><geom mass=\"2\"" +
      visual + "<site name=\"s\" size=\".1\"/></body></worldbody>";
  const std::string references[] = {
      "<contact><pair geom1=\"h\" geom2=\"kept\"/></contact>",
      "<sensor><framepos objtype=\"geom\" objname=\"kept\"/></sensor>",
      "<sensor><framepos objtype=\"site\" objname=\"s\" reftype=\"geom\" refname=\"kept\"/>"
      "</sensor>",
      "<custom><tuple name=\"t\"><element objtype=\"geom\" objname=\"kept\"/></tuple></custom>"};
  for (const std::string& reference : references) {
    INFO(reference);
    const Compiled compiled(bodies + reference);
    const mjModel& m = compiled.model();
    CHECK(m.ngeom == 3);
    CHECK(mj_name2id(&m, mjOBJ_GEOM, "kept") >= 0);
    CHECK(m.body_mass[2] == Approx(3));
    CHECK(compiled.rules.visible.line == (mjVERSION_HEADER < 312 ? 3 : 0));
  }
  CHECK_FALSE(Compiled(bodies).rules.visible);
  CHECK(Compiled(bodies).model().ngeom == 2);
}

}  // namespace
}  // namespace mjforge::backport
