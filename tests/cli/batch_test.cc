// Tests of large batches: kills, interrupts, full disks, resuming, samplers, progress.

#include <catch2/catch.hpp>
#include <map>

#include "crate.h"

namespace mjforge {
namespace {

using harness::CommandResult;

class BatchTest : public CrateTest {
 protected:
  /// Runs a shell script, with the program as $mjforge. `children PID` lists the live children of a
  /// process.
  CommandResult Shell(const std::string& script) const {
    const std::string children =
        "children() { for stat in /proc/[0-9]*/stat; do\n"
        "  read -r pid name state parent rest < $stat &&\n"
        "    [ \"$parent\" = \"$1\" ] && [ $state != Z ] && echo $pid\n"
        "done 2>/dev/null; }\n";
    return harness::Command{.program = "bash",
                            .arguments = {"-c", children + script},
                            .environment = {{"mjforge", harness::MjforgeProgram().string()}},
                            .folder = folder().path(),
                            .timeout = std::chrono::minutes(4)}
        .Run();
  }
  std::map<std::string, std::string> Bytes(const std::string& subfolder) const {
    std::map<std::string, std::string> bytes;
    for (const std::string& file : folder().Files()) {
      if (file.starts_with(subfolder + "/"))
        bytes.emplace(file.substr(subfolder.size() + 1), folder().Read(file));
    }
    return bytes;
  }
};

TEST_CASE_METHOD(BatchTest,
                 "a batch that is killed at any moment is gone on with to the same bytes") {
  const std::string output = GENERATE(as<std::string>(), "", "/x.tar", "/x_%04d.tar.zst");
  INFO(output);
  const std::string series = output.ends_with(".zst") ? "--per-archive 500 " : "";
  const std::string command =
      "$mjforge generate crate.yaml -n 4000 -j 2 " + series + "--validate none -q -o ";
  CHECK(Shell(command + "'whole" + output + "'").status == 0);
  // Each run is killed later than the one before. Files with a final name are always complete.
  for (const char* seconds : {"0.01", "0.05", "0.1", "0.2"}) {
    Shell("timeout --signal KILL " + std::string(seconds) + " " + command + "'broken" + output +
          "' --resume");
    const auto whole = Bytes("whole");
    for (const auto& [file, bytes] : Bytes("broken")) {
      if (file.find("/.") != file.npos || file.starts_with('.')) continue;
      INFO(file);
      REQUIRE(whole.contains(file));
      CHECK(whole.at(file) == bytes);
    }
  }
  CHECK(Shell(command + "'broken" + output + "' --resume").status == 0);
  CHECK(Bytes("broken") == Bytes("whole"));
}

TEST_CASE_METHOD(BatchTest, "an interrupted batch ends cleanly and says how to go on") {
  const auto signal = GENERATE("INT", "TERM");
  const CommandResult result = Shell(
      "env --default-signal=INT $mjforge generate crate.yaml -n 2000000 -j 2 -o out & p=$!\n"
      "until [ -s out/.manifest.jsonl.part ]; do sleep 0.02; done\n"
      "kill -" +
      std::string(signal) + " $p; wait $p; echo $?");
  CHECK(result.out == "130\n");
  CHECK(result.err.find(" ok, interrupted (") != std::string::npos);
  CHECK(result.err.find("--resume continues from there\n") != std::string::npos);
  // Every record has its file, and there are no partial files.
  const std::string manifest = folder().Read("out/.manifest.jsonl.part");
  const auto lines = static_cast<std::size_t>(std::count(manifest.begin(), manifest.end(), '\n'));
  CHECK(manifest.ends_with("\n"));
  for (const std::string& file : folder().Files()) CHECK(file.find(".tmp") == file.npos);
  const CommandResult resumed =
      Shell("$mjforge generate crate.yaml -n " + std::to_string(lines + 5) + " -o out --resume");
  CHECK(resumed.status == 0);
  CHECK(resumed.err.find(std::to_string(lines) + " of them kept") != std::string::npos);
}

// Slow variants, so that a worker is busy at any time.
constexpr const char* kHeap =
    "mjforge: 1\nname: heap\nparts:\n"
    "  - {name: \"pebble_${i}\", for: {i: 1000}, type: sphere, size: 1cm, pos: [0, 0, i * 2cm]}\n";

TEST_CASE_METHOD(BatchTest, "a worker that is killed costs one variant, which is named") {
  folder().Write("heap.yaml", kHeap);
  const std::string signal = GENERATE(as<std::string>(), "ABRT", "KILL");
  const CommandResult result = Shell(
      "$mjforge generate heap.yaml -n 100 -j 2 --seed 7 -o out & p=$!\n"
      "until [ -s out/.manifest.jsonl.part ]; do sleep 0.01; done\n"
      "echo '<mujoco' > out/.heap_000033.xml.tmp1-0\n"  // as if the worker was writing it
      "kill -" +
      signal + " $(children $p | head -1); wait $p; echo $?");
  INFO(result.err);
  CHECK(result.out == "1\n");
  // The first line of the spec has nothing to do with the death.
  CHECK(result.err.starts_with("mjforge: error: variant "));
  CHECK_FALSE(std::filesystem::exists(folder() / "out/.heap_000033.xml.tmp1-0"));
  CHECK(result.err.find(": its worker was killed by SIG" + signal + " (seed 7, index ") !=
        std::string::npos);
  CHECK(result.err.find(": 99 ok, 1 failed") != std::string::npos);
  const CommandResult again = Shell(
      "$mjforge generate heap.yaml -n 100 --seed 7 -o out --resume -q &&"
      "$mjforge generate heap.yaml -n 100 --seed 7 -o whole -q && diff -r out whole");
  CHECK(again.status == 0);
  CHECK(again.out.empty());
}

TEST_CASE_METHOD(BatchTest, "a worker that is stopped between two variants holds up nothing") {
  // While the leader is stopped, its workers finish their tasks. One worker is stopped then, gets
  // another task and does not begin it.
  const CommandResult result = Shell(
      "$mjforge generate crate.yaml -n 20000 -j 2 --time-limit 0.1 --validate none -o x.tar & "
      "p=$!\n"
      "until [ -s .x.tar.part ]; do sleep 0.01; done\n"
      "kill -STOP $p\n"
      "for w in $(children $p); do\n"
      "  for i in 1 2 3 4 5; do\n"
      "    until grep -q '^State:.S' /proc/$w/status; do sleep 0.01; done; sleep 0.02\n"
      "  done\n"
      "done\n"
      "kill -STOP $w; kill -CONT $p; wait $p; echo $?");
  INFO(result.err);
  CHECK(result.out == "0\n");
  CHECK(result.err.find(": 20000 ok (") != std::string::npos);
}

TEST_CASE_METHOD(BatchTest, "what hints of check name is there") {
  std::string heap = kHeap;
  folder().Write("heap.yaml", heap.replace(heap.find("1000"), 4, "40000"));
  const std::string help = Run({"check", "--help"}).out;
  for (const char* script : {"$mjforge check heap.yaml -n 1 --time-limit 0.1\n",
                             "$mjforge check heap.yaml -n 1 & p=$!\n"
                             "until [ \"$(children $p)\" ]; do sleep 0.01; done; sleep 0.5\n"
                             "kill -KILL $(children $p | head -1); wait $p\n"}) {
    const std::string words = Shell(script).err;
    INFO(words);
    REQUIRE(words.find("  hint: ") != std::string::npos);
    for (std::size_t at = words.find(" --"); at != words.npos; at = words.find(" --", at + 1)) {
      const std::string option =
          words.substr(at + 1, words.find_first_of(",;. \n", at + 1) - at - 1);
      INFO(option);
      CHECK((help.find(option) != help.npos || words.substr(0, at).ends_with("inspect")));
    }
  }
}

TEST_CASE_METHOD(BatchTest, "workers end with the process that leads them") {
  const CommandResult result = Shell(
      "$mjforge generate crate.yaml -n 2000000 -j 2 -q -o out & p=$!\n"
      "until [ -s out/.manifest.jsonl.part ]; do sleep 0.01; done\n"
      "workers=$(children $p)\n"
      "kill -KILL $p; wait $p 2>/dev/null\n"
      "for i in 1 2 3 4 5 6 7 8 9 10; do\n"
      "  alive=0; for w in $workers; do grep -q '^State:.*[RSDT]' /proc/$w/status 2>/dev/null && "
      "alive=1; done\n"
      "  [ $alive = 0 ] && break; sleep 0.1\n"
      "done; echo alive $alive");
  CHECK(result.out == "alive 0\n");
}

TEST_CASE_METHOD(BatchTest, "a full disk stops a batch, which can go on when there is room") {
  // A limit on the size of files has the effect of a full disk: a write fails.
  const CommandResult result = Shell(
      "(ulimit -f 2000; $mjforge generate crate.yaml -n 4000 --validate none -o x.tar); echo $?");
  CHECK(result.out == "3\n");
  CHECK(result.err.find("error: cannot write 'x.tar': File too large") != std::string::npos);
  CHECK(result.err.find("seed 0, index ") != std::string::npos);
  CHECK(result.err.find(" ok, stopped (") != std::string::npos);
  CHECK(result.err.find("--resume continues from there") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder() / "x.tar"));
  const CommandResult resumed = Shell(
      "$mjforge generate crate.yaml -n 4000 --validate none -o x.tar --resume &&"
      "$mjforge generate crate.yaml -n 4000 --validate none -o whole/x.tar &&"
      "cmp x.tar whole/x.tar && sed s,../crate.yaml,crate.yaml, whole/x.manifest.jsonl |"
      "cmp x.manifest.jsonl -");
  CHECK(resumed.status == 0);
  CHECK(resumed.err.find("of them kept") != std::string::npos);
}

TEST_CASE_METHOD(BatchTest,
                 "a folder that is lost stops a batch, which starts anew when it is back") {
  const CommandResult result = Shell(
      "$mjforge generate crate.yaml -n 2000000 -j 2 -o out & p=$!\n"
      "until [ -s out/.manifest.jsonl.part ]; do sleep 0.01; done\n"
      "while [ -e out ]; do rm -rf out 2>/dev/null; done\n"
      "wait $p; echo $?\n"
      "$mjforge generate crate.yaml -n 100 -o out --resume -q; echo $?");
  CHECK(result.out == "3\n0\n");
  CHECK(result.err.find("error: cannot write 'out/crate_") != std::string::npos);
  CHECK(result.err.find("No such file or directory") != std::string::npos);
}

TEST_CASE_METHOD(BatchTest, "shards are made by several commands and joined by merge") {
  const CommandResult result = Shell(
      "set -e\n"
      "for i in 0 1 2; do $mjforge generate crate.yaml -n 50 --shard $i/3 -o out -q & done; wait\n"
      "$mjforge merge out\n"
      "$mjforge generate crate.yaml -n 50 -o whole -q\n"
      "diff -r --exclude 'manifest-*-of-*' out whole && echo same");
  CHECK(result.out == "same\n");
  CHECK(result.err == "50 variants in out/manifest.jsonl\n");
  const CommandResult missing =
      Shell("rm out/manifest-00001-of-00003.jsonl; $mjforge merge out; echo $?");
  CHECK(missing.out == "1\n");
  CHECK(missing.err.find("error: shard 1/3 is missing") != std::string::npos);
  CHECK(missing.err.find("hint: make it with --shard 1/3 --resume") != std::string::npos);
  const CommandResult one = Shell(
      "for i in 0 1; do $mjforge generate crate.yaml -n 1 --shard $i/2 -o one -q; done\n"
      "$mjforge merge one");
  CHECK(one.err == "1 variant in one/manifest.jsonl\n");
}

TEST_CASE_METHOD(BatchTest,
                 "verify does not take a shortage of file descriptors for a changed file") {
  REQUIRE(Run({"generate", "crate.yaml", "-n", "2", "-q", "-o", "out"}).status == 0);
  // One descriptor is enough for the libraries and the manifest, and none is left for an object.
  const CommandResult result = Shell("exec 3>&-; ulimit -n 4; exec $mjforge verify out");
  CHECK(result.status == 3);
  CHECK(result.err ==
        "mjforge: error: cannot read 'out/crate_000000.xml': Too many open files "
        "[yaml/cannot-read]\n"
        "mjforge: error: cannot read 'out/crate_000001.xml': Too many open files "
        "[yaml/cannot-read]\n");
}

TEST_CASE_METHOD(BatchTest, "inspect shows what a batch achieved") {
  REQUIRE(Run({"generate", "hammer", "-n", "50", "--validate", "none", "-q"}).status == 0);
  const CommandResult tables = Run({"inspect", "hammer/"});
  CHECK(tables.status == 0);
  CHECK(
      tables.out.starts_with("batch of tools/hammer, seed 0, target mujoco, validate none\n"
                             "50 variants: 50 ok\n"));
  CHECK(tables.out.find("\nhandle_length ") != std::string::npos);
  // Without the slash the word is the name of a spec.
  CHECK(Run({"inspect", "hammer"}).out.find("50 variants") == std::string::npos);
  CHECK(Run({"inspect", "hammer/manifest.jsonl"}).out == tables.out);
  const CommandResult json = Run({"inspect", "hammer/", "--json"});
  CHECK(json.out.find(R"("variants":50,"status":{"ok":50},"findings":{})") != std::string::npos);
  CHECK(Run({"inspect", "hammer/", "--sweep"}).status == 2);
  folder().Write("empty/x", "");
  const CommandResult none = Run({"inspect", "empty/"});
  CHECK(none.status == 3);
  CHECK(none.err.find("cannot read 'empty/manifest.jsonl'") != std::string::npos);
}

TEST_CASE_METHOD(UnluckyCrateTest, "inspect counts failed variants, and not their values") {
  REQUIRE(Run({"generate", "crate.yaml", "-n", "40", "-q", "-o", "out/"}).status == 1);
  const std::string text = Run({"inspect", "out/"}).out;
  CHECK(text.find("\n40 variants: 26 failed, 14 ok\n") != std::string::npos);
  CHECK(text.find("\nmodel/bad-value  ") != std::string::npos);
  REQUIRE(text.find("\nheight ") != std::string::npos);
  CHECK(text.substr(text.find("\nheight ")).find('-') ==
        std::string::npos);  // variants with negative heights failed
}

TEST_CASE_METHOD(BatchTest, "inspect and report show the same whole numbers one by one") {
  std::string list = "1";
  for (int last = 2; last <= 25; ++last) {
    list += ", " + std::to_string(last);
    if (last < 24) continue;
    folder().Write("c.yaml", "mjforge: 1\nname: c\nparams: {n: {cycle: [" + list +
                                 "]}}\nparts: [{name: b, type: sphere, size: n}]\n");
    REQUIRE(Run({"generate", "c.yaml", "-n", "25", "-q", "-o", "out/", "--force"}).status == 0);
    const std::string text = Run({"inspect", "out/"}).out;
    CHECK((text.find("and 12 more") != std::string::npos) == (last == 24));
    REQUIRE(Run({"report", "out/", "-q"}).status == 0);
    const std::string page = folder().Read("out/report.html");
    CHECK((page.find("Histogram of 25 values from 1 to") == std::string::npos) == (last == 24));
  }
}

TEST_CASE_METHOD(BatchTest, "samplers spread the draws over the batch") {
  for (const char* sampler : {"sobol", "latin", "grid"}) {
    const CommandResult result =
        Run({"generate", "crate.yaml", "-n", "32", "--sampler", sampler, "-o", sampler});
    CHECK(result.status == 0);
    const std::string manifest = folder().Read(std::string(sampler) + "/manifest.jsonl");
    CHECK(manifest.find(std::string(R"("sampler":")") + sampler) != std::string::npos);
    CHECK(Run({"replay", std::string(sampler) + "/crate_000017.xml"}).status == 0);
    CHECK(Run({"replay", std::string(sampler) + "/manifest.jsonl:5"}).status == 0);
  }
  // A single variant of the same batch.
  const CommandResult one = Run({"generate", "crate.yaml", "--first", "17", "--batch", "32",
                                 "--sampler", "latin", "-o", "-"});
  CHECK(one.out == folder().Read("latin/crate_000017.xml"));
  const CommandResult uneven = Run(
      {"generate", "crate.yaml", "--first", "5", "-n", "10", "--sampler", "latin", "-o", "uneven"});
  CHECK(uneven.status == 0);
  CHECK(uneven.err.find("warning: variants 5 to 14 lie in several blocks of 10") !=
        std::string::npos);
}

TEST_CASE_METHOD(BatchTest, "the progress bar is for terminals only") {
  const std::string command = "$mjforge generate crate.yaml -n 30000 -j 1 --durability none -o ";
  const CommandResult piped = Shell(command + "piped.tar");
  CHECK(piped.err.find('\r') == std::string::npos);
  const CommandResult shown =
      Shell("TERM=xterm script -qec \"" + command + "shown.tar\" /dev/null");
  CHECK(shown.out.find(" of 30000  ") != std::string::npos);
  CHECK(shown.out.find("/s  ") != std::string::npos);
  // The bar is erased at the end.
  CHECK(shown.out.rfind("\r\x1b[K") < shown.out.rfind("30000 variants of crate in shown.tar"));
  const CommandResult quiet =
      Shell("TERM=xterm script -qec \"" + command + "quiet.tar -q\" /dev/null");
  CHECK(quiet.out.empty());
}

TEST_CASE_METHOD(BatchTest, "options that contradict each other are wrong usage") {
  const auto wrong = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"generate", "crate.yaml"});
    const CommandResult result = Run(options);
    CHECK(result.status == 2);
    CHECK(folder().Files() == std::vector<std::string>{"crate.yaml"});
    return result.err;
  };
  CHECK(wrong({"--shard", "8/8"}).find("shards count from 0, so the last one is 7/8") !=
        std::string::npos);
  CHECK(wrong({"--shard", "1"}).find("not of the form I/N") != std::string::npos);
  CHECK(wrong({"--shard", "0/2", "-o", "x.tar"}).find("such as 'x_%05d.tar'") != std::string::npos);
  wrong({"--shard", "0/2", "-o", "x.xml"});
  wrong({"--resume", "-o", "-"});
  wrong({"-o", "x.tar.gz"});
  wrong({"-o", "x_%s.tar"});
  wrong({"-j", "0"});
  wrong({"--per-archive", "0"});
  CHECK(wrong({"--per-archive", "10", "-o", "x.tar"}).find("is for a series") != std::string::npos);
  CHECK(wrong({"--verify"}).find("--resume") != std::string::npos);
  CHECK(wrong({"-o", ""}).find("'' is no place") != std::string::npos);
  wrong({"--time-limit", "0"});
  wrong({"--time-limit", "soon"});
  wrong({"--sampler", "halton"});
  wrong({"-MD", "-o", "-"});
  CHECK(wrong({"-MT", "x"}).find("-MT needs -MD") != std::string::npos);
  CHECK(wrong({"-MP"}).find("-MP needs -MD") != std::string::npos);
  CHECK(wrong({"--name", ""}).find("'' is no name") != std::string::npos);
  CHECK(wrong({"-o", "o\xff.tar"}).find("'o\\xff.tar' is not UTF-8") != std::string::npos);
  wrong({"-MD", "--resume"});
  CHECK(Run({"merge", "x.tar"}).status == 2);
  CHECK(Run({"merge"}).status == 2);
}

}  // namespace
}  // namespace mjforge
