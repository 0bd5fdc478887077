// Tests of `mjforge preview --watch`: which changes of files it notices.

#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

class WatchTest : public CrateTest {
 protected:
  // Runs a script of the shell beside a preview of cube.yaml that watches its files, and returns
  // the script's output. `waits` prints how often the preview has waited, and `until_true
  // CONDITION` waits up to 60 s.
  std::string Watch(const std::string& script) const {
    const std::string begin =
        "until_true() { for i in $(seq 1200); do if eval \"$1\"; then return; fi; sleep 0.05; "
        "done; "
        "echo \"never: $1\"; }\n"
        "waits() { grep -c 'waiting for a change' err; }\n"
        "\"$1\" preview cube.yaml --watch -o x.png --size 64 2>err & pid=$!\n";
    return harness::Command{
        .program = "bash",
        .arguments = {"-c", begin + script, "bash", harness::MjforgeProgram().string()},
        .folder = folder().path()}
        .Run()
        .out;
  }
};

TEST_CASE_METHOD(WatchTest, "with --watch a picture follows its files, and survives mistakes") {
  folder().Write("size.yaml", "mjforge: 1\nparams: {a: 0.1}\n");
  folder().Write("cube.yaml",
                 "mjforge: 1\nname: cube\nimport: [size.yaml]\n"
                 "parts: [{name: cube, type: box, size: [a, a, a]}]\n");
  const std::string out = Watch(
      "until_true '[ $(waits) = 1 ]'; cp x.png first.png\n"
      "printf 'mjforge: 1\\nparams: {a: unknown}\\n' >new; mv new size.yaml\n"
      "until_true '[ $(waits) = 2 ]'; cmp x.png first.png && echo same\n"
      "grep -q 'cube.yaml:4:.*: error: ' err && echo reported\n"
      "printf 'mjforge: 1\\nparams: {a: [0.1, 0.2]}\\n' >size.yaml\n"
      "printf 'mjforge: 1\\nname: cube\\nparts: [{name: c, type: sphere, size: 1}]\\n' >cube.yaml\n"
      "until_true '! cmp -s x.png first.png'\n"
      "kill -TERM $pid; wait $pid; echo $?\n");
  CHECK(out == "same\nreported\n143\n");
}

TEST_CASE_METHOD(WatchTest,
                 "with --watch a missing import, and a mesh, are noticed when they appear") {
  folder().Write("cube.yaml",
                 "mjforge: 1\nname: cube\nimport: [size.yaml]\n"
                 "parts: [{name: cube, type: mesh, file: cube.obj, scale: a}]\n");
  const std::string out = Watch(
      "until_true '[ $(waits) = 1 ]'; grep -q \"cannot find 'size.yaml'\" err && echo no import\n"
      "printf 'mjforge: 1\\nparams: {a: 0.1}\\n' >size.yaml\n"
      "until_true '[ $(waits) = 2 ]'; grep -q \"no file 'cube.obj'\" err && echo no mesh\n"
      "printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nv 0 0 1\\nf 1 3 2\\nf 1 2 4\\nf 2 3 4\\nf 3 1 4\\n' "
      ">new\n"
      "mv new cube.obj\n"
      "until_true '[ $(waits) = 3 ]'; cp x.png first.png && echo drawn\n"
      "printf 'v 0 0 0\\nv 2 0 0\\nv 0 1 0\\nv 0 0 1\\nf 1 3 2\\nf 1 2 4\\nf 2 3 4\\nf 3 1 4\\n' "
      ">new\n"
      "mv new cube.obj\n"
      "until_true '[ $(waits) = 4 ]'; cmp -s x.png first.png || echo drawn again\n"
      "kill -TERM $pid; wait $pid\n");
  CHECK(out == "no import\nno mesh\ndrawn\ndrawn again\n");
}

TEST_CASE_METHOD(WatchTest, "a preview that watches takes files only") {
  CHECK(Run({"preview", "-", "--watch"}, "x").status == 2);
  CHECK(Run({"preview", "cube.yaml", "--watch", "-o", "-"}).status == 2);
}

}  // namespace
}  // namespace mjforge
