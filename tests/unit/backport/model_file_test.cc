#include "mjforge/backport/model_file.h"

#include <string>

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {
namespace {

constexpr bool kIsOld = mjVERSION_HEADER < 300;

/// A file with the corner of a cube, which weighs 1000 / 6 kg, read and loaded.
struct CornerFile {
  explicit CornerFile(const std::string& sections) {
    const auto file = folder.Write(
        "m.xml", "<mujoco>" + sections +
                     "<asset><mesh name=\"m\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\"/></asset>"
                     "<worldbody>\n<body><freejoint/><geom type=\"mesh\" mesh=\"m\"/></body>"
                     "</worldbody></mujoco>");
    diag::Findings findings;
    read = ReadModelFile(file, sources, findings);
    REQUIRE(read);
    engine::Engine engine;
    CHECK(mj_getTotalmass(LoadFile(engine, file, *read).model.get()) == Approx(1000.0 / 6));
    CHECK(mj_getTotalmass(LoadFile(engine, file).model.get()) == Approx(1000.0 / 6));
    const std::optional<std::string> text = BackportedText(file);
    CHECK(text.has_value() == read->backported.has_value());
    if (text) CHECK(mj_getTotalmass(engine.LoadText(*text).model.get()) == Approx(1000.0 / 6));
  }

  harness::TemporaryFolder folder;
  diag::Sources sources;
  std::optional<ModelFile> read;
};

TEST_CASE("a file has the masses of later releases, whatever the release that it is written for") {
  const CornerFile of_any("");
  CHECK(of_any.read->differences.mass.line == (kIsOld ? 2 : 0));
  CHECK(of_any.read->backported.has_value() == kIsOld);
  const CornerFile of_later("<visual><global ellipsoidinertia=\"false\"/></visual>");
  CHECK_FALSE(of_later.read->differences);
}

TEST_CASE("a file without masses of meshes is read as it is") {
  const harness::TemporaryFolder folder;
  const auto file =
      folder.Write("m.xml", "<mujoco><worldbody><geom size=\"1\"/></worldbody></mujoco>");
  diag::Sources sources;
  diag::Findings findings;
  CHECK_FALSE(ReadModelFile(file, sources, findings)->backported);
  CHECK_FALSE(BackportedText(file));
}

}  // namespace
}  // namespace mjforge::backport
