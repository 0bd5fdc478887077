#include "mjforge/engine/engine.h"

#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "harness/standard_error.h"

namespace mjforge::engine {
namespace {

const std::string kBox =
    "<mujoco><worldbody><body name=\"b\"><geom type=\"box\" size=\"1 1 1\"/></body></worldbody>"
    "</mujoco>";

TEST_CASE("MuJoCo's errors become exceptions that the process survives") {
  Engine engine;
  CHECK_THROWS_WITH(mju_error("out of order"), "out of order");
  CHECK_THROWS_AS(mju_error("Could not allocate memory"), std::bad_alloc);
  CHECK(engine.LoadText(kBox).model);
}

#if mjVERSION_HEADER < 312
TEST_CASE("an error that leaves mj_loadXML releases its lock") {
  Engine engine;
  mjVFS* vfs = static_cast<mjVFS*>(std::calloc(1, sizeof(mjVFS)));
  const std::string name(2 * mjMAXVFSNAME, 'x');
  char error[100] = "";
  CHECK_THROWS_WITH(mj_loadXML(name.c_str(), vfs, error, sizeof error), "Filename too long in VFS");
  std::free(vfs);
  CHECK(engine.LoadText(kBox).model);  // would wait for ever
}
#endif  // from 3.1.2 on a load holds no lock

/// Returns a model with this many boxes that lie on a floor, with four contacts each.
std::string Boxes(int count, const std::string& sections = "") {
  std::string text = "<mujoco>" + sections + "<worldbody><geom type=\"plane\" size=\"9 9 1\"/>";
  for (int i = 0; i < count; ++i) {
    text += "<body pos=\"" + std::to_string(i) +
            " 0 0.0999\"><freejoint/><geom type=\"box\" size=\"0.1 0.1 0.1\"/></body>";
  }
  return text + "</worldbody></mujoco>";
}

/// Returns the remedies of the shortages of a load that succeeded without warnings.
std::vector<std::string> Remedies(const Loaded& loaded) {
  INFO(loaded.error);
  REQUIRE(loaded.model);
  CHECK(loaded.warnings.empty());
  std::vector<std::string> remedies;
  for (const Shortage& shortage : loaded.shortages) remedies.emplace_back(shortage.remedy);
  return remedies;
}

using Strings = std::vector<std::string>;

TEST_CASE("limits of memory in MuJoCo 2.2 are no faults of a model") {
  Engine engine;
  const auto expected = [](const char* remedy) {
    return kHasFixedBuffers ? Strings{remedy} : Strings{};
  };
  CHECK(Remedies(engine.LoadText(Boxes(25))).empty());
  CHECK(Remedies(engine.LoadText(Boxes(26))) == expected("a larger `nconmax`"));
  CHECK(Remedies(engine.LoadText(Boxes(26, "<size nconmax=\"200\" njmax=\"400\"/>"))) ==
        expected("a larger `njmax`"));
  std::string bodies;
  for (int i = 0; i < 1700; ++i) bodies += "<body><geom size=\"0.1\"/></body>";
  std::string crowd = kBox;
  CHECK(Remedies(engine.LoadText(crowd.insert(crowd.find("</worldbody"), bodies))) ==
        expected("a larger `nstack`"));
  CHECK(Remedies(engine.LoadText(Boxes(1, "<size njmax=\"20000\"/>"))) ==
        expected("a smaller `njmax`"));
}

#if mjVERSION_HEADER < 230
TEST_CASE("a model has the usual stack, and an engine error is an error of that load only") {
  Engine engine;
  const Loaded usual = engine.LoadText(kBox);
  const Loaded starved = engine.LoadText(std::string(kBox).insert(8, "<size nstack=\"1\"/>"));
  CHECK(Remedies(starved) == Strings{"a larger `nstack`"});
  CHECK(starved.model->nstack > usual.model->nstack);
  const Loaded frugal = engine.LoadText(std::string(kBox).insert(8, "<size nstack=\"9000\"/>"));
  CHECK(Remedies(frugal).empty());
  CHECK(frugal.model->nstack >= 5 * 500 * 500);
  CHECK(engine.LoadText(kBox).shortages.empty());
}
#endif  // later releases have an arena

#if mjVERSION_HEADER < 300
std::string MeshOf(const std::string& height) {
  return "<mujoco><asset><mesh name=\"m\" face=\"0 2 1 0 1 3 1 2 3 0 3 2\" vertex=\"0 0 0 1 0 0 0 "
         "1 0 "
         "0.2 0.2 " +
         height + "\"/></asset><worldbody><geom type=\"mesh\" mesh=\"m\"/></worldbody></mujoco>";
}

TEST_CASE("Qhull prints nothing, and its reason is a part of MuJoCo's error") {
  Engine engine;
  Loaded loaded;
  CHECK(harness::StandardErrorOf([&] { loaded = engine.LoadText(MeshOf("0")); }).empty());
  CHECK_FALSE(loaded.model);
  CHECK(loaded.error.starts_with("Error: qhull error: Initial simplex is flat (facet "));
  CHECK(loaded.error.find("\nObject name = m") != std::string::npos);
}

TEST_CASE("Qhull's doubts about a hull that it made are a warning") {
  Engine engine;
  Loaded loaded;
  CHECK(harness::StandardErrorOf([&] { loaded = engine.LoadText(MeshOf("1e-9")); }).empty());
  CHECK(loaded.model);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].starts_with("qhull: The initial hull is narrow."));
}
#endif  // later ones refuse such meshes before they call Qhull

TEST_CASE("warnings are collected for the load they belong to and no log is written") {
  Engine engine;
  std::string with_nan = kBox;
  with_nan.insert(with_nan.find("<geom"), "<geom size=\"1\" pos=\"nan 0 0\"/>");
  const Loaded loaded = engine.LoadText(with_nan);
  REQUIRE_FALSE(loaded.warnings.empty());
  CHECK(loaded.warnings[0] == "XML contains a 'NaN'. Please check it carefully.");
  CHECK(engine.LoadText(kBox).warnings.empty());
  CHECK_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
}

}  // namespace
}  // namespace mjforge::engine
