// Tests that a lack of memory is reported as an error.

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "harness/command.h"

namespace mjforge {
namespace {

class MemoryTest : public harness::ProgramTest {
 protected:
  /// Runs the program with this limit of memory, including the 45,000 kB of the program itself.
  harness::CommandResult RunWithin(int kilobytes, const std::string& arguments) const {
    return harness::Command{
        .program = "bash",
        .arguments = {"-c", "ulimit -v " + std::to_string(kilobytes) + "; \"" +
                                harness::MjforgeProgram().string() + "\" " + arguments},
        .folder = folder().path()}
        .Run();
  }
};

TEST_CASE_METHOD(MemoryTest, "a variant that needs too much memory fails, and no other") {
  folder().Write("heap.yaml",
                 "mjforge: 1\nname: heap\nparams: {n: {cycle: [10, 40000]}}\nparts:\n"
                 "  - {name: \"pebble_${i}\", for: {i: n}, type: sphere, size: 1cm}\n");
  const auto result = RunWithin(100'000, "generate heap.yaml -n 4 -j 1 --validate none -o out");
  INFO(result.err);
  CHECK(result.status == 1);
  CHECK(result.err.find("error: variant 1: its worker needs more memory than there is") !=
        std::string::npos);
  CHECK(result.err.find("internal error") == std::string::npos);
  CHECK(result.err.find(": 2 ok, 2 failed (") != std::string::npos);
  CHECK(std::filesystem::exists(folder() / "out/heap_000002.xml"));
  const auto check = RunWithin(100'000, "check heap.yaml -n 2 -j 1");
  CHECK(check.status == 1);
  CHECK(check.err.find("heap.yaml: 1 of 2 variants ok\n") != std::string::npos);
}

TEST_CASE_METHOD(MemoryTest, "a spec that needs too much memory is an input failure") {
  std::string text = "mjforge: 1\nname: heap\nparts:\n";
  for (int i = 0; i < 100'000; ++i)
    text += "  - {name: p" + std::to_string(i) + ", type: sphere, size: 1cm}\n";
  folder().Write("heap.yaml", text);
  for (const char* arguments : {"check heap.yaml", "generate heap.yaml"}) {
    const auto result = RunWithin(100'000, arguments);
    CHECK(result.status == 3);
    CHECK(result.err == "mjforge: error: not enough memory\n");
    CHECK(folder().Files() == std::vector<std::string>{"heap.yaml"});
  }
  const auto inspected = RunWithin(100'000, "inspect heap.yaml");
  CHECK(inspected.status == 3);
  CHECK(inspected.err.starts_with("mjforge: error: 'heap.yaml' needs more memory than there is"));
}

TEST_CASE_METHOD(MemoryTest, "with any memory a command works or says that it has too little") {
  REQUIRE(Run({"generate", "hammer", "-n", "3", "-q", "-o", "out"}).status == 0);
  folder().Write("box.xml",
                 "<mujoco><worldbody><body name=\"b\"><freejoint/><geom type=\"box\" "
                 "size=\".1 .1 .1\" density=\"100\"/></body></worldbody></mujoco>\n");
  const std::string commands[] = {"--version",
                                  "catalogue",
                                  "schema",
                                  "check hammer -n 2 -j 2",
                                  "generate hammer -n 2 -o new --force",
                                  "generate mug -n 2 -o new.tar.zst --force",
                                  "inspect hammer",
                                  "inspect out",
                                  "inspect out/hammer_000001.xml --sweep",
                                  "validate box.xml --physics",
                                  "replay out/manifest.jsonl:1",
                                  "replay out/hammer_000001.xml",
                                  "verify out",
                                  "report out --force --thumbnails 0",
                                  "__complete generate hammer --set ''"};
  for (const std::string& command : commands) {
    bool is_enough = false;
    for (int kilobytes = 20'000; kilobytes <= 100'000 && !is_enough; kilobytes += 2'000) {
      const auto result = RunWithin(kilobytes, command);
      if (result.status == 127) continue;  // the system's loader has no memory for the libraries
      INFO(command << " within " << kilobytes << " kB: " << result.err);
      // A variant that needs too much fails; the batch is done.
      const bool is_variant = result.err.find("its worker needs more memory") != std::string::npos;
      CHECK((result.status == 0 || result.status == 3 || (result.status == 1 && is_variant)));
      if (result.status == 3) CHECK(result.err.find("mjforge: error: ") != std::string::npos);
      is_enough = result.status == 0;
    }
    CHECK(is_enough);
  }
}

TEST_CASE_METHOD(MemoryTest, "a model that MuJoCo has no memory for is not called wrong") {
  folder().Write("stack.xml",
                 "<mujoco><size nstack=\"2000000000\"/><worldbody><body><freejoint/>"
                 "<geom size=\"1\"/></body></worldbody></mujoco>\n");
  for (const char* command : {"validate", "inspect"}) {
    const auto result = RunWithin(500'000, std::string(command) + " stack.xml");
    INFO(result.err);
    CHECK(result.status == 3);
    CHECK(result.err.find("error: 'stack.xml' needs more memory than there is") !=
          std::string::npos);
  }
}

TEST_CASE_METHOD(MemoryTest, "a process that cannot be started is an error of the system") {
  // A limit of processes does not apply to root, so the program runs as another user.
  const bool is_root = ::geteuid() == 0;
  std::filesystem::permissions(folder().path(), std::filesystem::perms(0777));
  for (const std::string arguments : {"generate hammer -n 2 -o out", "inspect hammer"}) {
    const auto result =
        harness::Command{
            .program = "bash",
            .arguments = {"-c", "ulimit -u 1; exec " +
                                    std::string(is_root ? "setpriv --reuid=65533 --regid=65533 "
                                                          "--clear-groups "
                                                        : "") +
                                    "\"" + harness::MjforgeProgram().string() + "\" " + arguments},
            .folder = folder().path()}
            .Run();
    INFO(result.err);
    CHECK(result.status == 3);
    CHECK(result.err.find("Resource temporarily unavailable") != std::string::npos);
  }
}

TEST_CASE_METHOD(MemoryTest,
                 "specs that double at each level are too many before they fill memory") {
  const std::string last = GENERATE(
      as<std::string>(),
      // Specs with parts, without parts, with bodies, with sites.
      "parts: [{name: s, type: sphere, size: 1cm}]",
      "parts: [{name: s, if: 1 > 2, type: sphere, size: 1cm}]", "bodies: [{name: s, parts: []}]",
      "parts: []\nsites: [{name: s}, {name: t}, {name: u}, {name: v}]");
  const std::string list = GENERATE("parts", "bodies");
  constexpr int kLevels = 24;
  for (int i = 0; i < kLevels; ++i) {
    const std::string next = "spec: level" + std::to_string(i + 1) + "}";
    folder().Write("level" + std::to_string(i) + ".yaml", "mjforge: 1\nname: level\n" + list +
                                                              ": [{name: a, " + next +
                                                              ", {name: b, " + next + "]\n");
  }
  folder().Write("level" + std::to_string(kLevels) + ".yaml",
                 "mjforge: 1\nname: last\n" + last + "\n");
  const auto result = RunWithin(500'000, "check level0.yaml -n 2 -j 1");
  INFO(result.err);
  CHECK(result.status == 1);
  CHECK(result.err.find(": error: the object has more than 40000 ") != std::string::npos);
  CHECK(result.err.find("[model/too-many-parts]") == result.err.rfind("[model/too-many-parts]"));
}

}  // namespace
}  // namespace mjforge
