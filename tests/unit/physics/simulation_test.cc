// Reuse of simulation data.
#include <catch2/catch.hpp>

#include "examined.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

engine::Model LoadBodies(const std::string& bodies) {
  return Load("<worldbody>" + bodies + "</worldbody>");
}

TEST_CASE("memory is kept from one model to the next of the same sizes") {
  const engine::Model small = LoadBodies("<body><freejoint/><geom size=\"0.1\"/></body>");
  const engine::Model large = LoadBodies("<body><freejoint/><geom size=\"0.9\"/></body>");
  const engine::Model other = LoadBodies("<body><joint/><geom size=\"0.9\"/></body>");
  Workspace workspace;
  mjData* first = &workspace.For(*small);
  const mjtNum* qpos = first->qpos;
  first->qpos[2] = 5;
  first->time = 9;
  mjData* second = &workspace.For(*large);
  CHECK(second->qpos == qpos);
  CHECK(second->qpos[2] == 0);
  CHECK(second->time == 0);
  CHECK(workspace.For(*other).nbuffer != 0);
  CHECK(workspace.For(*other).qvel != nullptr);
  mj_step(other.get(), &workspace.For(*other));  // with memory of the right sizes
}

TEST_CASE("what is measured does not depend on what was examined before") {
  const std::string low = Free(0, R"(<geom type="box" size="0.05 0.05 0.02" euler="0.7 0.2 0"/>)");
  const std::string high = Free(0, R"(<geom type="box" size="0.03 0.05 0.1" euler="0.1 0.7 0"/>)");
  const Examined alone = Examine(low);
  Examine(high);
  Examine("<body><joint name=\"j\" axis=\"1 0 0\"/><geom size=\"0.9\"/></body>");
  CHECK(Examine(low).result == alone.result);
}

}  // namespace
}  // namespace mjforge::physics
