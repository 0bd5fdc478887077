// Padded families, and families of each structure.

#include <algorithm>
#include <filesystem>

#include "family_test.h"

namespace mjforge {
namespace {

using harness::CommandResult;
using Shape = std::vector<std::uint64_t>;

constexpr const char* kMixed = R"(mjforge: 1
name: mixed
params: {shape: {cycle: [box, ball]}, knobs: {cycle: [0, 2, 1]}, r: 1cm .. 2cm}
parts:
  - {name: core, type: box, size: [3cm, 3cm, r]}
  - {name: body, if: shape == 'box', type: box, size: [r, r, r], pos: [0, 0, 4cm]}
  - {name: body, if: shape == 'ball', type: sphere, size: r, pos: [0, 0, 4cm]}
  - {name: "knob_${i}", for: {i: knobs}, type: prism, polygon: [[0, 0], [2cm, 0], [0, 1cm]],
     height: 1cm, pos: [5cm, 0, 1cm * i]}
)";

TEST_CASE_METHOD(FamilyTest, "padded variants have the geoms of all") {
  folder().Write("mixed.yaml", kMixed);
  CHECK(Generate({"mixed.yaml", "-n", "6", "-o", "no.npz"}, 1).err.find("--pad makes geoms") !=
        std::string::npos);
  Generate({"mixed.yaml", "-n", "6", "--pad", "-o", "m.npz"});
  CHECK(Facts("m.npz").at("pad") == true);
  const auto arrays = Arrays("m.npz");
  CHECK(arrays.at("index").shape == Shape{6});
  const std::size_t knob = NumberOf(arrays, "geom_rgba", "mixed_knob_1");
  const std::size_t ball = NumberOf(arrays, "geom_size", "mixed_body.sphere");
  const std::size_t box = NumberOf(arrays, "geom_size", "mixed_body");
  const std::vector<double> colors = arrays.at("geom_rgba").Numbers();
  const std::vector<double> sizes = arrays.at("geom_size").Numbers();
  const std::size_t elements = arrays.at("geom_rgba").shape[1];
  const std::size_t sized = arrays.at("geom_size").shape[1];
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK((colors[4 * (elements * i + knob) + 3] > 0) == (i % 3 == 1));
    CHECK((sizes[3 * (sized * i + ball)] > 0.005) == (i % 2 == 1));
    CHECK((sizes[3 * (sized * i + box)] > 0.005) == (i % 2 == 0));
  }
}

TEST_CASE_METHOD(FamilyTest, "each structure has a family, however they are made") {
  folder().Write("mixed.yaml", kMixed);
  const auto make = [&](const std::string& place, std::vector<std::string> more) {
    more.insert(more.begin(), {"mixed.yaml", "-n", "300", "--layout", "split", "-o", place});
    Generate(std::move(more));
  };
  const auto families = [&](const std::string& where) {
    std::map<std::string, std::string> files;
    for (const std::string& file : folder().Files()) {
      if (file.starts_with(where) && !file.ends_with(".rows"))
        files[file.substr(2)] = folder().Read(file);
    }
    std::erase_if(files, [](const auto& file) {
      return file.first.find("-of-") != std::string::npos || file.first.ends_with(".seal.json");
    });
    return files;
  };
  make("a/m_%s.npz", {"-j", "1"});
  CHECK(families("a").size() == 6 + 1);  // two shapes, three numbers of knobs; the manifest
  make("b/m_%s.npz", {"-j", "3"});
  CHECK(families("b") == families("a"));
  for (const char* seconds : {"0.05", "0.15"}) {
    harness::Command{.program = "timeout",
                     .arguments = {"--signal", "KILL", seconds, harness::MjforgeProgram().string(),
                                   "generate", "-q", "--seed", "7", "mixed.yaml", "-n", "300", "-j",
                                   "2", "--layout", "split", "-o", "c/m_%s.npz", "--resume"},
                     .folder = folder().path()}
        .Run();
  }
  make("c/m_%s.npz", {"--resume"});
  CHECK(families("c") == families("a"));
  for (const char* shard : {"1/2", "0/2"}) make("d/m_%s.npz", {"--shard", shard});
  CHECK(Run({"merge", "d/m_%s.npz"}).status == 0);
  CHECK(families("d") == families("a"));
  CHECK(Run({"verify", "a/m.manifest.jsonl"}).err.find("7 files") != std::string::npos);
  CHECK(Run({"replay", "a/m.manifest.jsonl:5"}).status == 0);
  const std::string first = "a/" + families("a").begin()->first;
  std::filesystem::remove(folder() / first);
  make("a/m_%s.npz", {"--resume"});
  CHECK(families("a") == families("b"));
}

TEST_CASE_METHOD(FamilyTest, "a padded family does not depend on how it is made") {
  folder().Write("mixed.yaml", kMixed);
  Generate({"mixed.yaml", "-n", "9", "--first", "2", "--pad", "-j", "1", "-o", "a.npz"});
  Generate({"mixed.yaml", "-n", "9", "--first", "2", "--pad", "-j", "3", "-o", "b.npz"});
  CHECK(folder().Read("a.npz") == folder().Read("b.npz"));
  for (const char* shard : {"0/3", "1/3", "2/3"}) {
    Generate({"mixed.yaml", "-n", "9", "--first", "2", "--pad", "--shard", shard, "-o", "c.npz"});
  }
  CHECK(Run({"merge", "c.npz"}).status == 0);
  CHECK(folder().Read("a.npz") == folder().Read("c.npz"));
  CHECK(Run({"verify", "a.manifest.jsonl"}).status == 0);
  const CommandResult replay = Run({"replay", "a.manifest.jsonl:5"});
  INFO(replay.err);
  CHECK(replay.status == 0);
}

TEST_CASE_METHOD(FamilyTest, "the search for geoms does not count as time of a variant") {
  folder().Write("mixed.yaml", kMixed);
  Generate({"mixed.yaml", "-n", "20000", "--shard", "0/10000", "--pad", "--time-limit", "0.2", "-o",
            "m.npz"});
}

TEST_CASE_METHOD(FamilyTest, "geoms of variants that are drawn again count, too") {
  folder().Write("luck.yaml",
                 "mjforge: 1\nname: luck\n"
                 "params: {knobs: {choice: [1, 2, 3, 4]}, width: -1cm .. 1cm}\n"
                 "parts:\n"
                 "  - {name: core, type: box, size: [1cm, 1cm, width]}\n"
                 "  - {name: 'knob_${i}', for: {i: knobs}, type: sphere, size: 1cm}\n");
  Generate({"luck.yaml", "-n", "12", "--pad", "--on-invalid", "resample", "--layout", "split", "-o",
            "l_%s.npz"});
  CHECK(std::ranges::count_if(folder().Files(),
                              [](const std::string& file) { return file.ends_with(".npz"); }) == 1);
}

TEST_CASE_METHOD(FamilyTest, "a joint cannot be null") {
  folder().Write("arms.yaml",
                 "mjforge: 1\nname: arms\nparams: {count: {cycle: [1, 2]}}\n"
                 "parts: [{name: core, type: box, size: [1cm, 1cm, 1cm]}]\n"
                 "bodies:\n  - {name: 'arm_${i}', for: {i: count}, pos: [0, 0, 5cm * (i + 1)],\n"
                 "     parts: [{name: 'bar_${i}', type: box, size: [1cm, 1cm, 1cm]}],\n"
                 "     joints: [{name: 'turn_${i}', type: hinge}]}\n");
  const CommandResult result = Generate({"arms.yaml", "-n", "4", "--pad", "-o", "arms.npz"}, 1);
  CHECK(result.err.find("only geoms and sites can be null") != std::string::npos);
  CHECK(result.err.find("mujoco/structure") != std::string::npos);
}

}  // namespace
}  // namespace mjforge
