// Tests that balls dropped into bundled containers stay inside, although MuJoCo's default contacts
// yield by more than the thickness of a thin bottom.

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

#include "harness/source_folder.h"
#include "mjforge/assemble/assemble.h"
#include "mjforge/engine/engine.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge {
namespace {

struct Container {
  std::string spec;
  std::string bottom;  // part below the content
};

using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

constexpr double kStart = 0.03;  // m above the middle of the bottom; below the lid of a jar
constexpr double kHeight = 0.1;  // m, height of the fall

std::string SceneOf(const spec::ObjectSpec& spec, std::uint64_t index,
                    model::Bounds* bounds = nullptr) {
  diag::Findings findings;
  auto values =
      sample::Sample(spec, {.seed = 3, .index = index}, sample::kRootStream, {}, findings);
  REQUIRE(values);
  const auto object = assemble::Assembler().Assemble(*values, {}, findings);
  REQUIRE(object);
  if (bounds != nullptr) *bounds = object->bounds;
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(*object, mjcf::Target::kScene, {}, document);
  document.text.insert(document.text.find("  </worldbody>"),
                       "    <body name=\"ball\"><joint name=\"ball\" type=\"free\"/>"
                       "<geom type=\"sphere\" size=\"0.004\"/></body>\n");
  return document.text;
}

std::unique_ptr<spec::ObjectSpec> SpecOf(const std::string& name) {
  diag::Sources sources;
  diag::Findings findings;
  auto spec = spec::LoadSpec(
      name,
      {.settings = {}, .parameter_files = {}, .search_path = {harness::SourceFolder() / "specs"}},
      sources, findings);
  REQUIRE(spec != nullptr);
  return spec;
}

// Computes the position of the ball in the frame of the container's bottom.
void PlaceOf(const mjModel& m, const mjData& d, int bottom, double place[3]) {
  const int ball = mj_name2id(&m, mjOBJ_BODY, "ball");
  double offset[3];
  mju_sub3(offset, d.xpos + 3 * ball, d.geom_xpos + 3 * bottom);
  mju_mulMatTVec(place, d.geom_xmat + 9 * bottom, offset, 3, 3);
}

// Drops the ball onto the bottom, off its middle in a direction that depends on the index.
void Drop(const mjModel& m, mjData& d, int bottom, std::uint64_t index) {
  mj_kinematics(&m, &d);
  const int ball = mj_name2id(&m, mjOBJ_JOINT, "ball");
  const double angle = 2.4 * static_cast<double>(index);
  double* position = d.qpos + m.jnt_qposadr[ball];
  mju_copy3(position, d.geom_xpos + 3 * bottom);
  position[0] += 0.01 * std::cos(angle);
  position[1] += 0.01 * std::sin(angle);
  position[2] += kStart;
  d.qvel[m.jnt_dofadr[ball] + 2] = -std::sqrt(2 * 9.81 * (kHeight - kStart));
  while (d.time < 2) mj_step(&m, &d);
}

}  // namespace

TEST_CASE("a small ball that falls into a bundled container stays in it") {
  const auto container = GENERATE(values<Container>({{"robosuite/pot_with_handles", "base"},
                                                     {"robosuite/bin", "base"},
                                                     {"articulated/drawer_cabinet", "bottom_0"}}));
  const auto spec = SpecOf(container.spec);
  engine::Engine engine;
  for (std::uint64_t index = 0; index < 8; ++index) {
    const engine::Loaded loaded = engine.LoadText(SceneOf(*spec, index));
    INFO(container.spec << " " << index << " " << loaded.error);
    REQUIRE(loaded.model);
    const mjModel& m = *loaded.model;
    const Data d(mj_makeData(&m), &mj_deleteData);
    const int bottom = mj_name2id(&m, mjOBJ_GEOM, (spec->name + "_" + container.bottom).c_str());
    REQUIRE(bottom >= 0);
    Drop(m, *d, bottom, index);
    double place[3];
    PlaceOf(m, *d, bottom, place);
    INFO(place[0] << " " << place[1] << " " << place[2]);
    const double* size = m.geom_size + 3 * bottom;
    const bool is_round = m.geom_type[bottom] == mjGEOM_CYLINDER;
    const double floor = is_round ? size[1] : size[2];
    CHECK(place[2] > floor);
    CHECK(std::abs(place[0]) < size[0]);
    CHECK(std::abs(place[1]) < size[is_round ? 0 : 1]);
  }
}

TEST_CASE("a small ball that falls into a turned container stays in it") {
  const std::string name =
      GENERATE("containers/mug", "containers/bowl", "containers/wine_glass", "containers/bottle");
  const auto spec = SpecOf(name);
  engine::Engine engine;
  for (std::uint64_t index = 0; index < 8; ++index) {
    model::Bounds bounds;
    const engine::Loaded loaded = engine.LoadText(SceneOf(*spec, index, &bounds));
    INFO(name << " " << index << " " << loaded.error);
    REQUIRE(loaded.model);
    const mjModel& m = *loaded.model;
    const Data d(mj_makeData(&m), &mj_deleteData);
    mj_kinematics(&m, d.get());
    const int ball = mj_name2id(&m, mjOBJ_JOINT, "ball");
    double* position = d->qpos + m.jnt_qposadr[ball];
    // The container is the first body.
    mju_copy3(position, d->xpos + 3);
    const double height = bounds.top_offset - bounds.bottom_offset;
    position[0] += 0.004 * std::cos(2.4 * static_cast<double>(index));
    position[1] += 0.004 * std::sin(2.4 * static_cast<double>(index));
    position[2] += bounds.bottom_offset + 0.7 * height;
    d->qvel[m.jnt_dofadr[ball] + 2] = -1.4;  // speed after a fall of 0.1 m
    while (d->time < 2) mj_step(&m, d.get());
    double offset[3];
    double place[3];
    mju_sub3(offset, d->xpos + 3 * m.jnt_bodyid[ball], d->xpos + 3);
    mju_mulMatTVec(place, d->xmat + 9, offset, 3, 3);
    INFO(place[0] << " " << place[1] << " " << place[2]);
    CHECK(place[2] > bounds.bottom_offset + 0.004);
    CHECK(place[2] < bounds.bottom_offset + 0.6 * height);
    CHECK(std::hypot(place[0], place[1]) < bounds.horizontal_radius);
  }
}

}  // namespace mjforge
