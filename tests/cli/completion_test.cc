// Tests of the answers to shells that complete a word (app/completion.h).

#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

class CompletionTest : public CrateTest {
 protected:
  std::string Ask(std::vector<std::string> words,
                  std::map<std::string, std::string> environment = {}) const {
    words.insert(words.begin(), "__complete");
    const auto result = Run(std::move(words), {}, std::move(environment));
    CHECK(result.status == 0);
    CHECK(result.err.empty());
    return result.out;
  }

  // Returns the words without their meanings and without the last line: "generate\n".
  std::string Words(std::vector<std::string> words) const {
    const std::string answer = Ask(std::move(words));
    std::string found;
    REQUIRE(answer.ends_with('\n'));
    for (std::size_t at = 0; answer[at] != ':'; at = answer.find('\n', at) + 1)
      found += answer.substr(at, answer.find('\t', at) - at) + "\n";
    return found;
  }
};

TEST_CASE_METHOD(CompletionTest, "commands are completed, and say what they do") {
  CHECK(Ask({"ge"}) == "generate\tMake variants of objects\n:\n");
  CHECK(Ask({"help", "mer"}) == "merge\tJoin the manifests of all shards of a batch\n:\n");
  CHECK(Ask({"help", "merge", ""}) == ":\n");
  CHECK(Words({""}) ==
        "generate\ncheck\ninspect\nvalidate\npreview\ncustomize\nview\nreport\nmerge\nverify\nrepla"
        "y\n"
        "new\ncatalogue\nschema\nhelp\n");
  CHECK(Words({}) == Words({""}));
  CHECK(Words({"-"}) == "--help\n--version\n");
  CHECK(Ask({"nosuch", ""}) == ":\n");
  CHECK(Ask({"--version", ""}) == ":\n");
}

TEST_CASE_METHOD(CompletionTest, "options are completed as the command has them") {
  CHECK(Ask({"generate", "crate.yaml", "--sam"}) ==
        "--sampler\tSpread of draws: random, sobol, latin, grid\n:\n");
  CHECK(Words({"verify", "-"}) == "--help\n--findings\n--color\n--quiet\n");
  CHECK(Words({"generate", "-M"}) == "-MD\n-MF\n-MT\n-MP\n");
  CHECK(Words({"check", "--s"}) == "--seed\n--set\n--start\n");
  // An option that can be given once is not offered again.
  CHECK(Words({"check", "-s", "7", "--set", "a=1", "--s"}) == "--set\n--start\n");
  CHECK(Words({"check", "-s7", "--s"}) == "--set\n--start\n");
  CHECK(Words({"check", "--seed=7", "--s"}) == "--set\n--start\n");
  CHECK(Words({"generate", "-qv", "--"}).find("--quiet\n--verbose") == std::string::npos);
  CHECK(Words({"generate", "-MD", "-M"}) == "-MF\n-MT\n-MP\n");
  CHECK(Words({"check", "--", "--s"}).empty());
}

TEST_CASE_METHOD(CompletionTest, "values of options are completed where a list of them is fixed") {
  CHECK(Words({"generate", "crate.yaml", "--target", ""}) ==
        "mujoco\nscene\nrobosuite\nrobocasa\nmjx\n");
  CHECK(Words({"generate", "crate.yaml", "--target", "m"}) == "mujoco\nmjx\n");
  CHECK(Words({"generate", "crate.yaml", "--target=m"}) == "--target=mujoco\n--target=mjx\n");
  CHECK(Words({"generate", "--validate", ""}) == "none\nload\nphysics\n");
  CHECK(Words({"generate", "--sampler", ""}) == "random\nsobol\nlatin\ngrid\n");
  CHECK(Words({"check", "--root", ""}) == "free\nnone\n");
  CHECK(Words({"check", "--start", ""}) == "zero\nkeyframe\n");
  CHECK(Words({"check", "--profile", "s"}) == "simready\n");
  CHECK(Words({"preview", "--background", "s"}) == "studio\n");
  CHECK(Words({"preview", "--layer", "col"}) == "collision\n");
  CHECK(Words({"schema", ""}) == "object\nmanifest\nplacement\n");
  CHECK(Words({"schema", "object", ""}).empty());
  // Numbers are not completed.
  CHECK(Ask({"generate", "-n", ""}) == ":\n");
  CHECK(Ask({"generate", "--nosuch", ""}).ends_with(":.yaml .yml\n"));
  CHECK(Ask({"generate", "--nosuch="}) == ":\n");
}

TEST_CASE_METHOD(CompletionTest, "every word that is offered is accepted") {
  for (const char* option :
       {"--target", "--validate", "--sampler", "--on-invalid", "--root", "--start"}) {
    const std::string words = Words({"generate", "crate.yaml", option, ""});
    CHECK_FALSE(words.empty());
    for (std::size_t at = 0; at < words.size(); at = words.find('\n', at) + 1) {
      const std::string word = words.substr(at, words.find('\n', at) - at);
      INFO(option << " " << word);
      CHECK(Run({"generate", "crate.yaml", option, word, "-n", "1", "-o", "-"}).status == 0);
    }
  }
}

TEST_CASE_METHOD(CompletionTest, "specs are completed by whole names and by their last words") {
  CHECK(Ask({"generate", "ham"}) ==
        "hammer\tClaw hammer with a handle of wood, fibreglass or steel tube and a forged head.\n"
        ":.yaml .yml\n");
  CHECK(Words({"generate", "primitives/b"}) == "primitives/ball\nprimitives/box\n");
  CHECK(Words({"replay", "x.xml", "--spec", "hamm"}) == "hammer\n");
  CHECK(Words({"generate", "hammer", "primitives/bo"}) ==
        "primitives/box\n");                        // generate takes several specs
  CHECK(Words({"inspect", "hammer", ""}).empty());  // inspect takes one spec
  // The words are the names listed by `mjforge catalogue`.
  const std::string listed = Run({"catalogue"}).out;
  std::string names;
  for (std::size_t at = listed.find('\n') + 1; at < listed.size(); at = listed.find('\n', at) + 1)
    names += listed.substr(at, listed.find(' ', at) - at) + "\n";
  CHECK(Words({"check", ""}) == names);
}

TEST_CASE_METHOD(CompletionTest, "specs of MJFORGE_PATH are completed, broken ones in silence") {
  folder().Write("mine/boxes/crate.yaml", kText);
  folder().Write("mine/boxes/crooked.yaml", "mjforge: 1\nname: [\nparts:\n");
  const std::map<std::string, std::string> path = {{"MJFORGE_PATH", (folder() / "mine").string()}};
  CHECK(Ask({"check", "boxes/cr"}, path) == "boxes/crate\tA box.\nboxes/crooked\t\n:.yaml .yml\n");
  CHECK(Ask({"check", "crat"}, path) == "crate\tA box.\n:.yaml .yml\n");
  CHECK(Ask({"check", "boxes/crate", "--set", "h"}, path) == "height=\tHalf the height.\n:\n");
  CHECK(Ask({"check", "boxes/crooked", "--set", ""}, path) == ":\n");
  CHECK(Ask({"check", "nosuch", "--set", ""}, path) == ":\n");
}

TEST_CASE_METHOD(CompletionTest, "settings are completed for the spec that is on the line") {
  CHECK(Ask({"generate", "-n", "5", "crate.yaml", "--set", ""}) ==
        "height=\tHalf the height.\n:\n");
  CHECK(Words({"generate", "crate.yaml", "--set=hei"}) == "--set=height=\n");
  CHECK(Words({"inspect", "hammer", "--set", "handle_shape="}) ==
        "handle_shape=wooden\nhandle_shape=fibreglass\nhandle_shape=tubular\n");
  CHECK(Words({"inspect", "robosuite/hammer", "--set", "use_texture=t"}) == "use_texture=true\n");
  CHECK(Words({"inspect", "hammer", "--set", "handle_length="}).empty());
  // A record can be set as a whole or value by value.
  CHECK(Words({"inspect", "fridge", "--set", "kind"}) == "kind=\nkind.height=\nkind.split=\n");
  CHECK(Words({"inspect", "fridge", "--set", "kind="}) == "kind=small\nkind=tall\n");
}

TEST_CASE_METHOD(CompletionTest, "joints are completed for the spec or the file on the line") {
  folder().Write("doors.yaml",
                 "mjforge: 1\nname: doors\nparams: {count: {value: 1}}\n"
                 "parts: [{name: wall, type: box, size: [1, 1, 1]}]\njoints: none\nbodies:\n"
                 "  - {for: {i: count}, name: \"leaf_${i}\", pos: [3 + 3 * i, 0, 0],\n"
                 "     parts: [{name: \"board_${i}\", type: box, size: [1, 1, 1]}],\n"
                 "     joints: [{name: \"swing_${i}\", axis: [0, 0, 1], range: [0, 90deg]},\n"
                 "              {name: \"lift_${i}\", type: slide, axis: [0, 0, 1]}]}\n");
  CHECK(Ask({"preview", "doors.yaml", "--joint", ""}) ==
        "swing_0=\thinge, 0 to 1.57 rad\nlift_0=\tslide\n:\n");
  CHECK(Words({"preview", "doors.yaml", "--joint=doors_sw"}) == "--joint=doors_swing_0=\n");
  CHECK(Words({"preview", "doors.yaml", "--set", "count=2", "--joint", "lift_1"}) == "lift_1=\n");
  CHECK(Words({"preview", "doors.yaml", "--set=count=2", "--joint", "lift_1"}) == "lift_1=\n");
  CHECK(Words({"preview", "doors.yaml", "--sweep", "--joint", "sw"}) == "swing_0\n");
  folder().Write("arm.xml",
                 "<mujoco><worldbody><body><joint name='bend'/><joint type='ball' name='no'/>"
                 "<geom size='1'/></body></worldbody></mujoco>");
  CHECK(Words({"preview", "arm.xml", "--joint", ""}) == "bend=\n");
  // Offered words are accepted; without words there is no message.
  CHECK(Run({"check", "doors.yaml"}).status == 0);
  CHECK(Ask({"preview", "doors.yaml", "--set", "count=x", "--joint", ""}) == ":\n");
  CHECK(Ask({"preview", "nosuch.xml", "--joint", ""}) == ":\n");
  CHECK(Ask({"preview", "-", "--joint", ""}) == ":\n");
  CHECK(Ask({"preview", "--joint", ""}) == ":\n");
}

TEST_CASE_METHOD(CompletionTest, "thresholds are settings, too, also of a file") {
  CHECK(Words({"check", "crate.yaml", "--set", "checks.ti"}) == "checks.tilt=\n");
  CHECK(Words({"validate", "x.xml", "--set", "checks.stable="}) ==
        "checks.stable=true\nchecks.stable=false\n");
  CHECK(Words({"validate", "x.xml", "--set", "checks.profile="}).find("=simready\n") !=
        std::string::npos);
  CHECK(Ask({"validate", "x.xml", "--set", "checks.til"}).starts_with("checks.tilt=\tHow far "));
}

TEST_CASE_METHOD(CompletionTest, "files are left to the shell, which is told how their names end") {
  CHECK(Ask({"validate", ""}) == ":.xml\n");
  CHECK(Ask({"generate", "crate.yaml", "-o", ""}) == ":.\n");
  CHECK(Ask({"generate", "crate.yaml", "-MF", ""}) == ":.\n");
  CHECK(Ask({"generate", "crate.yaml", "--params="}) == ":.yaml .yml\n");
  CHECK(Ask({"replay", "out/"}) == ":.jsonl .zst .xml\n");
  CHECK(Ask({"verify", ""}) == ":.jsonl .npz .tar .zst\n");
  CHECK(Ask({"preview", "./x"}) == ":.yaml .yml .xml\n");
}

TEST_CASE_METHOD(CompletionTest, "nobody waits at the Tab key") {
  // Standard input belongs to the shell, so it is not read.
  CHECK(Ask({"check", "-", "--set", "height"}) == ":\n");
  // The largest valid spec takes two to three seconds to read. Completion gives up after one.
  std::string text = "mjforge: 1\nname: slow\nparams:\n  p0: 1\n";
  for (int i = 1; i < 350'000; ++i)
    text += "  p" + std::to_string(i) + ": p" + std::to_string(i - 1) + " + 1\n";
  folder().Write("slow.yaml", text + "parts: [{name: a, type: sphere, size: p0}]\n");
  CHECK(Ask({"check", "slow.yaml", "--set", "p"}).empty());
}

}  // namespace
}  // namespace mjforge
