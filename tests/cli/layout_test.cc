// Tests of `--layout` and of what `mjforge inspect` says about the structures of a batch.

#include <catch2/catch.hpp>

#include "harness/command.h"

namespace mjforge {
namespace {

class ShapesTest : public harness::ProgramTest {
 protected:
  ShapesTest() {
    folder().Write(
        "crate.yaml",
        "mjforge: 1\n"
        "name: crate\n"
        "params:\n"
        "  half: 0.1 .. 0.2\n"
        "  knobs: {choice: [1, 2]}\n"
        "  shape: {choice: [box, cylinder]}\n"
        "parts:\n"
        "  - {name: body, if: \"shape == 'box'\", type: box, size: [half, half, half]}\n"
        "  - {name: body, if: \"shape == 'cylinder'\", type: cylinder, size: [half, half]}\n"
        "  - name: knob_${i}\n"
        "    for: {i: knobs}\n"
        "    type: sphere\n"
        "    size: [1cm]\n"
        "    pos: [0.3 + 0.1 * i, 0, 0]\n");
  }
};

// Returns the lines of a text that contain some words.
std::string LinesWith(const std::string& text, const std::string& words) {
  std::string lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (line.find(words) != line.npos) lines += line + "\n";
    at = end + 1;
  }
  return lines;
}

constexpr const char* kDifferences =
    "geom_type differs in 18 of 40: shape (geom_type of 'body', 'body_vis' is cylinder, not box)\n"
    "ngeom differs in 22 of 40: knobs (ngeom is 6, not 4 ('knob_1', 'knob_1_vis'))\n";

TEST_CASE_METHOD(ShapesTest,
                 "inspect counts structures and names the parameters that separate them") {
  CHECK(Run({"generate", "crate.yaml", "-n", "40", "-q", "-o", "out"}).status == 0);
  const auto text = Run({"inspect", "out/"});
  CHECK(text.status == 0);
  CHECK(LinesWith(text.out, " structures") == "4 structures\n");
  CHECK(LinesWith(text.out, " differs in ") == kDifferences);
  const auto json = Run({"inspect", "out/", "--json"});
  CHECK(json.out.find(R"("field":"geom_type","elements":["body","body_vis"],)") !=
        std::string::npos);
  CHECK(json.out.find(R"("coincidence":false,"variants":18,"of":40,)"
                      R"("parameters":[{"name":"shape","by":"value"}]})") != std::string::npos);
}

TEST_CASE_METHOD(ShapesTest, "inspect of archives and of one structure") {
  Run({"generate", "crate.yaml", "-n", "20", "-q", "-o", "x.tar.zst"});
  CHECK(LinesWith(Run({"inspect", "x.tar.zst"}).out, " structures") == "4 structures\n");
  Run({"generate", "crate.yaml", "-n", "5", "-q", "-o", "one", "--set", "shape=box", "--set",
       "knobs=1"});
  CHECK(LinesWith(Run({"inspect", "one/"}).out, "1 structure: ").size() ==
        std::string("1 structure: 0123456789ab\n").size());
  Run({"generate", "crate.yaml", "-n", "5", "-q", "-o", "none", "--validate", "none"});
  CHECK(LinesWith(Run({"inspect", "none/"}).out, "structure").empty());
}

TEST_CASE_METHOD(ShapesTest, "inspect counts structures without the spec") {
  Run({"generate", "crate.yaml", "-n", "20", "-q", "-o", "out", "--set", "knobs=1"});
  std::filesystem::remove(folder() / "crate.yaml");
  const auto text = Run({"inspect", "out/"});
  CHECK(text.status == 0);
  CHECK(LinesWith(text.out, " structures") == "2 structures\n");
  CHECK(LinesWith(text.out, "separated by") == "separated by: shape\n");
  CHECK(LinesWith(text.out, "not known") ==
        "the fields that differ are not known: cannot find the spec 'crate.yaml'\n");
  folder().Write("crate.yaml",
                 "mjforge: 1\nname: crate\nparams: {knobs: 1}\n"
                 "parts: [{name: a, type: sphere, size: [1]}]\n");
  CHECK(LinesWith(Run({"inspect", "out/"}).out, "not known").find("has changed since") !=
        std::string::npos);
}

TEST_CASE_METHOD(ShapesTest, "a batch of one structure fails, and says which parameters separate") {
  const auto result = Run({"generate", "crate.yaml", "-n", "40", "-o", "out", "--layout", "one"});
  CHECK(result.status == 1);
  CHECK(LinesWith(result.err, " differs in ") ==
        "  geom_type differs in 18 of 40: shape (geom_type of 'body', 'body_vis' is cylinder, not "
        "box)\n"
        "  ngeom differs in 22 of 40: knobs (ngeom is 6, not 4 ('knob_1', 'knob_1_vis'))\n");
  CHECK(LinesWith(result.err, "[mujoco/structure]").find("crate.yaml:") == 0);
  const auto other =
      Run({"generate", "crate.yaml", "-n", "40", "-o", "other", "--layout", "one", "-j", "7"});
  CHECK(folder().Read("other/manifest.jsonl") == folder().Read("out/manifest.jsonl"));
  CHECK(Run({"generate", "crate.yaml", "-n", "40", "-o", "good", "--layout", "one", "--set",
             "shape=box", "--set", "knobs=2"})
            .status == 0);
  CHECK(Run({"replay", "out/manifest.jsonl:0"}).status == 0);
}

TEST_CASE_METHOD(ShapesTest, "layouts need a validation, and a folder per structure a folder") {
  const auto fails = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"generate", "crate.yaml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = Run(arguments);
    CHECK(result.status == 2);
    return result.err.substr(0, result.err.find('\n'));
  };
  CHECK(fails({"--layout", "one", "--validate", "none"}) ==
        "mjforge: error: --layout one reads structures from the models that MuJoCo loads, and "
        "--validate none loads none");
  CHECK(fails({"--layout", "split", "-o", "x.xml"}) ==
        "mjforge: error: --layout split makes folders: -o x.xml must be a folder or an archive");
  CHECK(fails({"--layout", "two"}).find("--layout") != std::string::npos);
}

}  // namespace
}  // namespace mjforge
