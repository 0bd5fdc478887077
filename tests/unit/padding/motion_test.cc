// Motion of padded variants: that of the same variants alone.

#include <catch2/catch.hpp>
#include <memory>

#include <mujoco/mujoco.h>

#include "harness/temporary_folder.h"
#include "mjforge/forge/forge.h"

namespace mjforge::padding {
namespace {

// A tool whose handle is round or not, with a drawn number of studs, and a hinged cover that may
// have a plate with a mesh. It falls onto a plane.
constexpr const char* kTool = R"(mjforge: 1
name: tool
params:
  turned: {cycle: [true, false]}
  studs: {cycle: [0, 3, 1]}
  has_plate: {cycle: [false, true, true, false]}
  length: 0.1 .. 0.2
parts:
  - {name: grip, if: turned, type: cylinder, size: [0.01, length], density: 500}
  - {name: grip, if: not turned, type: box, size: [0.01, 0.012, length], density: 500}
  - {name: "stud_${i}", for: {i: studs}, type: sphere, size: 4mm, pos: [11mm, 0, 3cm * i],
     friction: [1.5, 0.01, 0.001], condim: 6}
bodies:
  - name: cover
    pos: [0, 0, length]
    joints: [{name: turn, type: hinge, axis: [0, 1, 0], range: [-90deg, 90deg]}]
    parts:
      - {name: rod, type: capsule, size: [8mm, 3cm], pos: [0, 0, 5cm], density: 700}
      - {name: plate, if: has_plate, type: prism, polygon: [[0, 0], [4cm, 0], [0, 3cm]],
         height: 5mm, pos: [0, 0, 8cm], density: 900}
)";

using Model = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

Model Load(std::string text, const harness::TemporaryFolder& folder) {
  const std::string floor = "<worldbody>\n<geom type=\"plane\" size=\"2 2 1\" pos=\"0 0 -0.3\"/>";
  text.replace(text.find("<worldbody>"), std::string_view("<worldbody>").size(), floor);
  folder.Write("tool.xml", text);
  char error[500] = "";
  Model model(mj_loadXML((folder / "tool.xml").c_str(), nullptr, error, sizeof(error)),
              &mj_deleteModel);
  INFO(error);
  REQUIRE(model != nullptr);
  return model;
}

// Positions of all joints during a fall.
std::vector<double> Fall(const std::string& text, const harness::TemporaryFolder& folder,
                         int& contacts) {
  const Model m = Load(text, folder);
  const Data d(mj_makeData(m.get()), &mj_deleteData);
  d->qvel[2] = -3;  // so fast that the floor reaches the middle of the tool
  d->qvel[4] = 2;
  std::vector<double> positions;
  for (int step = 0; step < 300; ++step) {
    mj_step(m.get(), d.get());
    positions.insert(positions.end(), d->qpos, d->qpos + m->nq);
    contacts += d->ncon;
  }
  return positions;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST_CASE("a padded variant moves exactly like the same variant alone") {
  const harness::TemporaryFolder folder;
  folder.Write("tool.yaml", kTool);
  diag::Sources sources;
  diag::Findings findings;
  const auto recipe = forge::LoadRecipe((folder / "tool.yaml").string(), {}, sources, findings);
  REQUIRE(recipe);
  constexpr std::uint64_t kVariants = 12;
  forge::Options options;
  options.seed = 5;
  forge::Generator alone(*recipe, sources, options);
  options.pad = kVariants;
  forge::Generator padded(*recipe, sources, options);
  forge::Variant a, b;
  int contacts = 0;
  for (std::uint64_t i = 0; i < kVariants; ++i) {
    alone.Make(i, a);
    padded.Make(i, b);
    for (const diag::Finding& finding : b.findings) UNSCOPED_INFO(finding.message);
    REQUIRE(a.ok());
    REQUIRE(b.ok());
    CHECK(b.record.ngeom == 2 * (2 + 3 + 1) + 1 + 1);  // the plate has a look and a solid
    CHECK(b.record.mass_properties.mass == a.record.mass_properties.mass);
    CHECK(b.record.bounds.aabb.min == a.record.bounds.aabb.min);
    CHECK(LargestDifference(Fall(b.document.text, folder, contacts),
                            Fall(a.document.text, folder, contacts)) < 1e-12);
  }
  CHECK(contacts > 1000);
}

}  // namespace
}  // namespace mjforge::padding
