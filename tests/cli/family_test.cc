// Families: `generate -o NAME.npz`.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "family_test.h"

namespace mjforge {
namespace {

using harness::CommandResult;
using harness::NpyArray;
using Shape = std::vector<std::uint64_t>;

constexpr const char* kTool = R"(mjforge: 1
name: tool
params:
  length: 0.1 .. 0.2
  wood: {choice: [oak, beech]}
  widths: {each: 1cm .. 2cm, count: 2}
  painted: {bernoulli: 0.5}
  turns: {choice: [0.01, 0.02]}
materials:
  oak: {rgba: [0.6 .. 0.8, 0.4, 0.2, 1]}
  beech: {rgba: [0.9, 0.8, 0.6, 1]}
parts:
  - {name: handle, type: box, size: [0.01, 0.01, length], density: "painted ? 520 : 500", material: "${wood}"}
  - {name: head, type: cylinder, size: ["widths[0]", 0.02], pos: [0.01, 0, length], density: 2000}
  - {name: wedge, type: prism, polygon: [[0, 0], [0.02, 0], [0, turns]], height: 0.02,
     pos: [0, 0, 0.3], density: 900}
)";

class FamilyFileTest : public FamilyTest {
 protected:
  FamilyFileTest() { folder().Write("tool.yaml", kTool); }
};

TEST_CASE_METHOD(FamilyFileTest, "a family has the numbers of each variant, by element") {
  Generate({"tool.yaml", "-n", "9", "-o", "tools.npz"});
  Generate({"tool.yaml", "-n", "9", "-o", "out"});
  const auto arrays = Arrays("tools.npz");
  const NpyArray& size = arrays.at("geom_size");
  const std::size_t names = arrays.at("geom_size.names").Texts().size();
  REQUIRE(size.shape == Shape{9, names, 3});
  const std::vector<double> sizes = size.Numbers();
  const std::vector<double> lengths = arrays.at("params/length").Numbers();
  for (std::size_t i = 0; i < 9; ++i) {
    const std::size_t at = 3 * (names * i + NumberOf(arrays, "geom_size", "tool_handle"));
    CHECK(sizes[at + 2] == lengths[i]);
    CHECK(sizes[at] == 0.01);
  }
  CHECK(arrays.at("mesh_vert/tool_wedge").shape == Shape{9, 6, 3});
  CHECK(arrays.at("params/widths").shape == Shape{9, 2});
  CHECK(arrays.at("params/painted").type == "|b1");
  CHECK(arrays.at("params/wood").type == "<U5");
  CHECK(arrays.at("index").type == "<u8");
  CHECK(arrays.at("bounds").shape == Shape{9, 2, 3});
  CHECK_FALSE(arrays.contains("geom_friction"));  // constant
  CHECK_FALSE(arrays.contains("dof_damping"));
}

TEST_CASE_METHOD(FamilyFileTest, "the base has the materials of all variants") {
  Generate({"tool.yaml", "-n", "9", "-o", "tools.npz"});
  const auto arrays = Arrays("tools.npz");
  const std::vector<std::string> materials = arrays.at("materials").Texts();
  const std::vector<std::string> woods = arrays.at("params/wood").Texts();
  REQUIRE(std::ranges::count(woods, "oak") > 0);
  REQUIRE(std::ranges::count(woods, "beech") > 0);
  const std::size_t width = arrays.at("geom_matid.names").Texts().size();
  const std::size_t at = NumberOf(arrays, "geom_matid", "tool_handle_vis");
  for (std::size_t i = 0; i < woods.size(); ++i) {
    std::int32_t id = 0;
    std::memcpy(&id, &arrays.at("geom_matid").bytes[4 * (width * i + at)], 4);
    CHECK(materials.at(static_cast<std::size_t>(id)) == "tool_" + woods[i]);
  }
  CHECK(arrays.at("mat_rgba.names").Texts() == std::vector<std::string>{"tool_oak"});
  const std::string& base = arrays.at("base").bytes;
  for (const std::string& name : materials)
    CHECK(base.find("<material name=\"" + name + '"') != base.npos);
  CHECK(base.find("<inertial pos=") != base.npos);
  CHECK_FALSE(base.starts_with("<!--"));
}

TEST_CASE_METHOD(FamilyFileTest, "a family's bytes are the same for all jobs, stops and shards") {
  Generate({"tool.yaml", "-n", "300", "-j", "1", "-o", "a/t.npz"});
  Generate({"tool.yaml", "-n", "300", "-j", "3", "-o", "b/t.npz"});
  const std::string bytes = folder().Read("a/t.npz");
  CHECK(folder().Read("b/t.npz") == bytes);
  for (const char* seconds : {"0.05", "0.1"}) {
    harness::Command{.program = "timeout",
                     .arguments = {"--signal", "KILL", seconds, harness::MjforgeProgram().string(),
                                   "generate", "-q", "--seed", "7", "tool.yaml", "-n", "300", "-j",
                                   "2", "-o", "c/t.npz", "--resume"},
                     .folder = folder().path()}
        .Run();
  }
  Generate({"tool.yaml", "-n", "300", "-o", "c/t.npz", "--resume"});
  CHECK(folder().Read("c/t.npz") == bytes);
  for (const char* shard : {"2/3", "0/3", "1/3"})
    Generate({"tool.yaml", "-n", "300", "-o", "d/t.npz", "--shard", shard});
  CHECK(Run({"merge", "d/t.npz"}).status == 0);
  CHECK(folder().Read("d/t.npz") == bytes);
  CHECK(folder().Read("d/t.manifest.jsonl") == folder().Read("a/t.manifest.jsonl"));
}

TEST_CASE_METHOD(FamilyFileTest,
                 "a family is verified, inspected, replayed and kept as archives are") {
  Generate({"tool.yaml", "-n", "70", "-o", "t.npz"});
  CHECK(Run({"verify", "t.npz"}).status == 0);
  CHECK(Run({"verify", "t.manifest.jsonl"}).status == 0);
  CHECK(Run({"inspect", "t.npz"}).out.find("70") != std::string::npos);
  const CommandResult replayed = Run({"replay", "t.manifest.jsonl:42"});
  CHECK((replayed.out + replayed.err).find("regenerated, same bytes") != std::string::npos);
  const CommandResult kept =
      Run({"generate", "--seed", "7", "tool.yaml", "-n", "70", "-o", "t.npz", "--resume"});
  CHECK((kept.out + kept.err).find("70 of them kept") != std::string::npos);
  std::string bytes = folder().Read("t.npz");
  bytes[bytes.size() / 2] ^= 1;
  folder().Write("t.npz", bytes);
  const CommandResult changed = Run({"verify", "t.npz"});
  CHECK(changed.status == 1);
  CHECK(changed.err.find("batch/changed") != std::string::npos);
}

TEST_CASE_METHOD(FamilyFileTest, "invalid variants have no row") {
  folder().Write("luck.yaml",
                 "mjforge: 1\nname: luck\n"
                 "params: {r: {cycle: [1cm, -1cm, 2cm]}}\n"
                 "parts: [{name: body, type: box, size: [1cm, 1cm, r]}]\n");
  Generate({"luck.yaml", "-n", "6", "-o", "m.npz"}, 1);
  const auto arrays = Arrays("m.npz");
  REQUIRE(arrays.at("index").shape == Shape{4});
  std::vector<std::uint64_t> indices(4);
  std::memcpy(indices.data(), arrays.at("index").bytes.data(), 32);
  CHECK(indices == std::vector<std::uint64_t>{0, 2, 3, 5});
  CHECK(Facts("m.npz").at("variants") == 4);
  CHECK(Facts("m.npz").at("count") == 6);
}

TEST_CASE_METHOD(FamilyFileTest, "a second structure is an error that says what differs") {
  folder().Write("mixed.yaml",
                 "mjforge: 1\nname: mixed\n"
                 "params: {shape: {cycle: [box, ball, box]}, r: 1cm .. 2cm}\n"
                 "parts:\n"
                 "  - {name: body, if: shape == 'box', type: box, size: [r, r, r]}\n"
                 "  - {name: body, if: shape == 'ball', type: sphere, size: r}\n");
  const CommandResult result = Generate({"mixed.yaml", "-n", "6", "-o", "m.npz"}, 1);
  CHECK(result.err.find("geom_type of 'body', 'body_vis' is sphere, not box") != std::string::npos);
  CHECK(result.err.find("mujoco/structure") != std::string::npos);
  CHECK(Arrays("m.npz").at("index").shape == Shape{4});
  // The structure is that of the batch's first variant in each shard.
  for (const char* shard : {"0/2", "1/2"})
    Run({"generate", "mixed.yaml", "-n", "4", "-o", "s.npz", "--shard", shard});
  CHECK(Run({"merge", "s.npz"}).status == 0);
  CHECK(Arrays("s.npz").at("index").shape == Shape{3});
}

TEST_CASE_METHOD(FamilyFileTest, "a coincidence of some variants is not in the base") {
  folder().Write("shifted.yaml",
                 "mjforge: 1\nname: shifted\n"
                 "params: {shift: {cycle: [0, 0.05, 0.1]}, r: 1cm .. 2cm}\n"
                 "parts:\n"
                 "  - {name: ball, type: sphere, size: r, pos: [shift, 0, 0]}\n"
                 "  - {name: core, type: box, size: [1cm, 1cm, 1cm]}\n"
                 "sites: [{name: grip, pos: [0, 0, shift]}]\n");
  Generate({"shifted.yaml", "-n", "6", "-o", "s.npz"});
  const nlohmann::json moved = Facts("s.npz").at("moved");
  CHECK(moved.at("geom_pos") == nlohmann::json({"shifted_ball", "shifted_ball_vis"}));
  CHECK(moved.at("site_pos") == nlohmann::json({"shifted_grip"}));
  CHECK(moved.at("body_ipos") == nlohmann::json({"shifted"}));
  const auto arrays = Arrays("s.npz");
  CHECK(arrays.at("base").bytes.find("name=\"shifted_ball\" type=\"sphere\"") != std::string::npos);
  CHECK(arrays.at("base").bytes.find("pos=\"2e-05 2e-05 2e-05\"") != std::string::npos);
  const std::vector<double> pos = arrays.at("geom_pos").Numbers();
  CHECK(pos[0] == 0);
  // A family in which it is in all variants keeps it.
  Generate({"shifted.yaml", "-n", "6", "--set", "shift=0", "-o", "z.npz"});
  CHECK(Facts("z.npz").at("moved") == nlohmann::json::object());
}

TEST_CASE_METHOD(FamilyFileTest, "fixed bodies become mocap bodies if they are wanted") {
  folder().Write(
      "post.yaml",
      "mjforge: 1\nname: post\nparams: {h: 0.1 .. 0.2}\njoints: none\n"
      "parts: [{name: pole, type: box, size: [1cm, 1cm, h]}]\n"
      "bodies:\n"
      "  - {name: arm, pos: [0, 0, h], parts: [{name: bar, type: box, size: [h, 5mm, 5mm]}],\n"
      "     joints: [{name: turn, type: hinge}]}\n");
  Generate({"post.yaml", "-n", "3", "--mocap", "-o", "p.npz"});
  const std::string base = Arrays("p.npz").at("base").bytes;
  CHECK(base.find("<body name=\"post\" pos=\"0 0 0\" mocap=\"true\">") != base.npos);
  CHECK(base.find("<body name=\"post_arm\" pos=\"0 0 0.1") != base.npos);
  CHECK(std::count(base.begin(), base.end(), '\n') > 5);
  CHECK(base.find("mocap") == base.rfind("mocap"));
  CHECK(Facts("p.npz").at("mocap") == true);
  Generate({"post.yaml", "-n", "3", "-o", "q.npz"});
  CHECK(Arrays("q.npz").at("base").bytes.find("mocap") == std::string::npos);
}

TEST_CASE_METHOD(FamilyFileTest, "options that a family cannot have are wrong usage") {
  const auto refused = [&](std::vector<std::string> more, const std::string& words) {
    more.insert(more.begin(), "tool.yaml");
    const CommandResult result = Generate(std::move(more), 2);
    INFO(result.err);
    CHECK(result.err.find(words) != std::string::npos);
  };
  refused({"-n", "1", "-o", "t.npz"}, "a family has at least two variants");
  refused({"tool.yaml", "-n", "2", "-o", "t.npz"}, "takes one spec");
  refused({"-n", "2", "--validate", "none", "-o", "t.npz"}, "--validate none");
  refused({"-n", "2", "--each", "-o", "t.npz"}, "--each: a family has one model");
  refused({"-n", "2", "--layout", "split", "-o", "t.npz"}, "needs a name such as NAME_%s.npz");
  refused({"-n", "2", "-o", "t_%s.npz"}, "needs --layout split");
  refused({"-n", "2", "--assets", "files", "-o", "t.npz"}, "--assets files");
  refused({"-n", "2", "--target", "robosuite", "-o", "t.npz"}, "--target robosuite");
  refused({"-n", "2", "--name", "t${index}", "-o", "t.npz"}, "one name");
  refused({"-n", "2", "-o", "t_%d.npz"}, "one %s in their file's name");
  refused({"-n", "2", "--pad", "-o", "t"}, "--pad is for families");
  refused({"-n", "2", "--mocap", "-o", "t.tar"}, "--mocap is for families");
}

TEST_CASE_METHOD(FamilyFileTest, "a file that is no family is not overwritten") {
  folder().Write("t.npz", "PK\x03\x04 something else, which is longer than a header of a member");
  const CommandResult result = Generate({"tool.yaml", "-n", "2", "-o", "t.npz"}, 3);
  CHECK(result.err.find("'t.npz' exists and was not made by mjforge") != std::string::npos);
  CHECK(folder().Files() == std::vector<std::string>{"t.npz", "tool.yaml"});
  Generate({"tool.yaml", "-n", "2", "-o", "t.npz", "--force"});
  CHECK(Arrays("t.npz").at("index").shape == Shape{2});
}

TEST_CASE_METHOD(FamilyFileTest,
                 "a mesh from a file has its scale, because its vertices have no order") {
  folder().Write("t.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.3 0.9 0.1\n"
                 "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 5 4\nf 3 4 5\nf 2 3 5\n");
  folder().Write("rock.yaml",
                 "mjforge: 1\nname: rock\nparams: {s: 0.05 .. 0.1}\n"
                 "parts: [{name: k, type: mesh, file: t.obj, scale: [s, s, 0.1], density: 500}]\n");
  Generate({"rock.yaml", "-n", "4", "-o", "rock.npz"});
  const auto arrays = Arrays("rock.npz");
  const auto found = std::ranges::find_if(
      arrays, [](const auto& entry) { return entry.first.starts_with("mesh_"); });
  REQUIRE(found != arrays.end());
  CHECK(found->first.starts_with("mesh_scale/"));
  CHECK(found->second.shape == Shape{4, 3});
  const std::vector<double> scales = found->second.Numbers();
  const std::vector<double> drawn = arrays.at("params/s").Numbers();
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(scales[3 * i] == drawn[i]);
    CHECK(scales[3 * i + 1] == drawn[i]);
    CHECK(scales[3 * i + 2] == 0.1);
  }
}

TEST_CASE_METHOD(FamilyFileTest, "friction of tendons is in all variants or in none") {
  folder().Write(
      "bow.yaml",
      "mjforge: 1\nname: bow\nparams: {loss: {choice: [0, 0.1]}}\n"
      "parts: [{name: a, type: box, size: [0.1, 0.1, 0.1]}]\n"
      "bodies:\n  - {name: b, pos: [0.5, 0, 0],\n"
      "     joints: [{name: j, type: slide, axis: [1, 0, 0], range: [0, 0.1]}],\n"
      "     parts: [{name: b, type: box, size: [0.1, 0.1, 0.1]}]}\n"
      "mjcf:\n  tendon:\n"
      "    - fixed: {name: w, frictionloss: loss, children: [{joint: {joint: j, coef: 1}}]}\n");
  const CommandResult result = Generate({"bow.yaml", "-n", "16", "-o", "bow.npz"}, 1);
  CHECK(result.err.find("tendon_hasfrictionloss") != std::string::npos);
}

}  // namespace
}  // namespace mjforge
