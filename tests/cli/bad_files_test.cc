// Tests of input files that are not valid specs, and of missing or broken assets.

#include <sys/stat.h>

#include <filesystem>
#include <future>

#include "bad_input.h"

namespace mjforge {
namespace {

const std::string kGood =
    "mjforge: 1\n"
    "name: crate\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1, 0.1, 0.1]}\n";

TEST_CASE_METHOD(BadInputTest, "a spec that does not exist is an input failure") {
  CheckOneFinding(Run({"generate", "none.yaml", "-o", "out"}), 3, "yaml/cannot-read");
}

TEST_CASE_METHOD(BadInputTest, "a spec that is a folder is an input failure") {
  std::filesystem::create_directory(folder() / "s.yaml");
  CheckOneFinding(Run({"generate", "s.yaml", "-o", "out"}), 3, "yaml/cannot-read");
}

TEST_CASE_METHOD(BadInputTest, "an empty file is one finding") {
  CheckSpec("", "yaml/empty");
  CheckSpec("# only words\n", "yaml/empty");
}

TEST_CASE_METHOD(BadInputTest, "a binary file is one finding") {
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 37 % 256);
  CheckSpec(bytes, "yaml/not-text");
  CheckSpec(std::string("\x7f"
                        "ELF\0\0\x01",
                        7),
            "yaml/not-text");
}

TEST_CASE_METHOD(BadInputTest, "100 MB of YAML are too large") {
  std::string text = kGood;
  text.reserve(100'000'100);
  while (text.size() < 100'000'000) text += "# a comment of forty characters, no more\n";
  CheckSpec(text, "yaml/too-large");
}

TEST_CASE_METHOD(BadInputTest, "10,000 nested brackets are too deep") {
  CheckSpec("mjforge: 1\nname: crate\nparts: " + std::string(10'000, '[') +
                std::string(10'000, ']') + "\n",
            "yaml/too-deep");
  CheckSpec("mjforge: 1\nname: crate\nparts: " + std::string(10'000, '[') + "\n", "yaml/too-deep");
}

TEST_CASE_METHOD(BadInputTest, "an alias bomb is one finding") {
  std::string text = "mjforge: 1\nname: crate\nparams:\n  a: &a [1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (char c = 'b'; c <= 'k'; ++c) {
    text += std::string("  ") + c + ": &" + c + " [";
    for (int i = 0; i < 9; ++i) text += std::string("*") + static_cast<char>(c - 1) + ", ";
    text += "1]\n";
  }
  CheckSpec(text + "parts: []\n", "yaml/alias");
}

TEST_CASE_METHOD(BadInputTest, "an anchor inside itself is one finding") {
  CheckSpec("mjforge: 1\nname: crate\nparts: &a [*a]\n", "yaml/alias");
}

TEST_CASE_METHOD(BadInputTest, "a spec that imports itself is one finding") {
  CheckSpec(kGood + "import: [s.yaml]\n", "spec/import-cycle");
  CheckSpec("mjforge: 1\nname: crate\nparts: [{name: a, spec: s.yaml}]\n", "spec/import-cycle");
}

TEST_CASE_METHOD(BadInputTest, "a missing mesh is one finding") {
  CheckSpec("mjforge: 1\nname: crate\nparts: [{name: a, type: mesh, file: none.obj}]\n",
            "model/file-not-found");
}

TEST_CASE_METHOD(BadInputTest, "a mesh that makes MuJoCo 2.2 crash is a finding") {
  folder().Write("bad.xml",
                 "<mujoco><asset><mesh name=\"m\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\" "
                 "face=\"0 2 1 0 1 3 0 3 2 1 2 90000000\"/></asset><worldbody><body name=\"b\">"
                 "<geom type=\"mesh\" mesh=\"m\"/></body></worldbody></mujoco>\n");
  folder().Write("good.xml", "<mujoco><worldbody><geom size=\"1\"/></worldbody></mujoco>\n");
  const std::string message = "mesh 'm': face 3 uses vertex 90000000 of 4, counted from 0";
  const auto both = Run({"validate", "bad.xml", "good.xml"});
  CHECK(both.status == 1);
  CHECK(both.out.starts_with("bad.xml: failed\ngood.xml: ok"));
  CHECK(CountOf(both.err, message) == 1);
  const auto json = Run({"validate", "bad.xml", "--json"});
  CHECK(json.out.find("\"ok\":false,\"findings\":[{\"severity\":\"error\"") != std::string::npos);
  for (const char* command : {"inspect", "preview"}) {
    const auto result = Run({command, "bad.xml"});
    CHECK(result.status == 1);
    CHECK(CountOf(result.err, message) == 1);
  }
  CHECK(folder().Files() == std::vector<std::string>{"bad.xml", "good.xml"});
}

TEST_CASE_METHOD(BadInputTest, "waiting has a time limit, too, although it takes no CPU time") {
  folder().Write("good.xml", "<mujoco><worldbody><geom size=\"1\"/></worldbody></mujoco>\n");
  REQUIRE(::mkfifo((folder().path() / "pipe").c_str(), 0600) == 0);
  // The shell keeps the pipe open, so that standard input never ends.
  const auto wait = [&](const std::string& arguments) {
    return harness::Command{
        .program = "bash",
        .arguments = {"-c", "exec 3<>pipe; \"" + harness::MjforgeProgram().string() + "\" " +
                                arguments + " <&3"},
        .folder = folder().path()}
        .Run();
  };
  const auto both = wait("validate --time-limit 0.01 - good.xml");
  CHECK(both.status == 1);
  CHECK(both.out.starts_with("<stdin>: failed\ngood.xml: ok"));
  CHECK(CountOf(both.err, "error: '<stdin>' took more than 5.1 s of wall time") == 1);
  // Runs the two commands at the same time, because each waits until its time limit is over.
  std::vector<std::future<harness::CommandResult>> results;
  for (const char* command : {"check", "generate"})
    results.push_back(
        std::async(std::launch::async, wait, std::string(command) + " --time-limit 0.01 -"));
  for (auto& waiting : results) {
    const auto result = waiting.get();
    CHECK(result.status == 1);
    CHECK(result.err ==
          "mjforge: error: loading '-' took more than 5.1 s of wall time [batch/too-slow]\n"
          "  hint: raise --time-limit, or see what the spec and what it imports have so much of\n");
  }
}

TEST_CASE_METHOD(BadInputTest, "pipes and devices that an MJCF file names are not opened") {
  std::filesystem::create_directory(folder() / "f");
  for (const char* name : {"p.xml", "p.png", "p.stl", "p.skn", "f/p.obj", "f/p.png"})
    REQUIRE(::mkfifo((folder() / name).c_str(), 0600) == 0);
  std::filesystem::create_symlink("/dev/zero", folder().path() / "zero.png");
  folder().Write("inner.xml", "<mujocoinclude><include file='p.xml'/></mujocoinclude>");
  folder().Write("folders.xml",
                 "<mujocoinclude><compiler meshdir='f' texturedir='f'/></mujocoinclude>");
  const std::string cases[] = {
      "<include file='p.xml'/>",
      "<INCLUDE file='p.xml'/>",
      "<include file='inner.xml'/>",
      "<asset><mesh name='m' file='p.stl'/></asset>",
      "<compiler meshdir='f'/><asset><mesh file='p.obj'/></asset>",
      "<include file='folders.xml'/><asset><mesh file='p.obj'/></asset>",
      "<compiler meshdir='f' strippath='true'/><asset><mesh file='/no/p.obj'/></asset>",
      "<asset><texture name='t' type='2d' file='p.png'/></asset>",
      "<asset><texture name='t' type='2d' file='zero.png'/></asset>",
      "<asset><texture name='t' type='cube' fileright='p.png'/></asset>",
      "<include file='folders.xml'/><asset><texture type='2d' file='p.png'/></asset>",
      "<asset><hfield name='h' size='1 1 1 1' file='p.png'/></asset>",
      "<asset><skin name='s' file='p.skn'/></asset>"};
  for (const std::string& text : cases) {
    folder().Write("a.xml", "<mujoco>" + text +
                                "<worldbody><body name='b'><geom size='1'/></body>"
                                "</worldbody></mujoco>\n");
    for (const std::vector<std::string>& command : {std::vector<std::string>{"validate", "a.xml"},
                                                    {"validate", "a.xml", "--physics"},
                                                    {"inspect", "a.xml", "--sweep"},
                                                    {"preview", "a.xml"},
                                                    {"view", "a.xml"}}) {
      const auto result = Run(command);
      INFO(text << ' ' << command.front() << ": " << result.err);
      CHECK(result.status == 3);
      CHECK(CountOf(result.err, "a.xml:1:") == 1);
      CHECK(CountOf(result.err, ": it is a ") == 1);
      CHECK(CountOf(result.err, "[yaml/cannot-read]") == 1);
    }
    folder().Write("s.yaml", "mjforge: 1\nname: s\nbodies: [{name: b, mjcf: a.xml}]\n");
    const auto attached = Run({"check", "s.yaml", "-n", "1"});
    INFO(text << ": " << attached.err);
    CHECK(attached.status == 3);
    CHECK(CountOf(attached.err, ": it is a ") == 1);
    CHECK(Run({"__complete", "preview", "a.xml", "--joint", ""}).status == 0);
  }
}

TEST_CASE_METHOD(BadInputTest, "only a pipe on the command line has the hint of standard input") {
  for (const char* name : {"p.xml", "p.yaml", "p.stl"})
    REQUIRE(::mkfifo((folder() / name).c_str(), 0600) == 0);
  const std::string hint = "  hint: '-' stands for standard input\n";
  CHECK(Run({"validate", "p.xml"}).err ==
        "mjforge: error: cannot read 'p.xml': it is a pipe [yaml/cannot-read]\n" + hint);
  CHECK(Run({"check", "p.yaml"}).err ==
        "mjforge: error: cannot read 'p.yaml': it is a pipe [yaml/cannot-read]\n" + hint);
  folder().Write("a.xml", "<mujoco><asset><mesh name='m' file='p.stl'/></asset></mujoco>\n");
  CHECK(Run({"validate", "a.xml"}).err ==
        "a.xml:1:16: error: cannot read 'p.stl', the file of mesh 'm': it is a pipe "
        "[yaml/cannot-read]\n"
        "<mujoco><asset><mesh name='m' file='p.stl'/></asset></mujoco>\n"
        "               ^\n");
}

TEST_CASE_METHOD(BadInputTest, "pipes that a spec or a manifest names are not opened") {
  for (const char* name : {"p.yaml", "p.csv", "p.png", "p.stl", "p.xml", "p.tar", "p.jsonl"})
    REQUIRE(::mkfifo((folder() / name).c_str(), 0600) == 0);
  const std::string parts = "parts: [{name: a, type: sphere, size: 1}]\n";
  const std::string cases[] = {"import: [p.yaml]\n" + parts,
                               "parts: [{name: a, spec: p.yaml}]\n",
                               "bodies: [{name: a, spec: p.yaml}]\n",
                               "bodies: [{name: a, mjcf: p.xml}]\n",
                               "parts: [{name: a, type: mesh, file: p.stl}]\n",
                               "materials: {m: {texture: {file: p.png}}}\n"
                               "parts: [{name: a, type: sphere, size: 1, material: m}]\n"};
  for (const std::string& text : cases) {
    folder().Write("s.yaml", "mjforge: 1\nname: s\n" + text);
    for (const char* command : {"check", "inspect"}) {
      const auto result = Run({command, "s.yaml"});
      INFO(text << ": " << result.err);
      CHECK(result.status == 3);
      CHECK(CountOf(result.err, "it is a pipe") == 1);
    }
  }
  folder().Write("s.yaml", "mjforge: 1\nname: s\n" + parts);
  CHECK(Run({"check", "s.yaml", "--params", "p.yaml"}).status == 3);
  for (const char* command : {"inspect", "report", "verify"}) {
    CHECK(Run({command, "p.jsonl"}).status > 0);
    CHECK(Run({command, "p.tar"}).status > 0);
  }
  REQUIRE(Run({"generate", "s.yaml", "-n", "2", "-q", "-o", "x.tar"}).status == 0);
  std::filesystem::rename(folder() / "p.tar", folder() / "x.tar");
  CHECK(Run({"replay", "x.manifest.jsonl:1"}).status == 3);
  CHECK(Run({"verify", "x.tar"}).status > 0);
  CHECK(Run({"verify", "x.manifest.jsonl"}).status > 0);
  CHECK(Run({"report", "x.manifest.jsonl"}).status == 0);
}

TEST_CASE_METHOD(BadInputTest, "what is not a file is not read") {
  REQUIRE(::mkfifo((folder().path() / "pipe").c_str(), 0600) == 0);
  for (const char* what : {"pipe", "/dev/zero"}) {
    for (const char* command : {"check", "generate", "inspect", "preview", "validate", "replay"}) {
      const auto result = Run({command, what});
      INFO(command << ' ' << what << ": " << result.err);
      CHECK(result.status == 3);
      CHECK(CountOf(result.err, std::string("cannot read '") + what + "': it is a ") == 1);
    }
  }
  std::filesystem::create_symlink("/dev/zero", folder().path() / "wood.png");
  folder().Write("crate.yaml",
                 "mjforge: 1\nname: crate\nmaterials: {wood: {texture: {file: wood.png}}}\n"
                 "parts: [{name: a, type: sphere, size: 0.1, material: wood}]\n");
  CHECK(Run({"generate", "crate.yaml", "-n", "2"}).status == 3);
}

TEST_CASE_METHOD(BadInputTest, "a record that is nested too deep is refused") {
  folder().Write("manifest.jsonl", "{\"findings\":" + std::string(200'000, '[') + "\n");
  for (const char* command : {"report", "inspect"}) {
    const auto result = Run({command, "manifest.jsonl"});
    INFO(command << ": " << result.err);
    CHECK(result.status > 0);
    CHECK(result.status <= 3);
    CHECK(result.err.find("values are nested more than 64 deep") != std::string::npos);
  }
}

TEST_CASE_METHOD(BadInputTest,
                 "pictures that would fill the memory are refused before they are read") {
  using namespace std::string_literals;
  const auto png = [](const std::string& side) {  // the first 24 bytes, which contain the size
    return "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s + side + side;
  };
  folder().Write("pictures/fits.png", png("\0\0\x14\0"s));     // 5120 pixels
  folder().Write("pictures/large.png", png("\0\0\x9c\x40"s));  // 40000 pixels
  const std::string rest = "parts: [{name: a, type: sphere, size: 1, material: m}";
  const auto with = [&](const std::string& texture) {
    return "mjforge: 1\nname: crate\nmaterials: {m: {texture: " + texture + "}}\n" + rest + "]\n";
  };
  CheckSpec(with("{file: pictures/large.png}"), "model/bad-texture");
  const std::string three =
      "mjforge: 1\nname: crate\nmaterials: {m: {texture: {file: pictures/fits.png}}, "
      "n: {texture: {file: pictures/fits.png, type: cube}}, "
      "o: {texture: {file: pictures/fits.png, type: 2d}}}\n" +
      rest + ", {name: b, type: sphere, size: 1, material: n}" +
      ", {name: c, type: sphere, size: 1, material: o}]\n";
  CheckSpec(three, "model/bad-texture");
  folder().Write("more.xml", "<mujocoinclude><compiler texturedir='pictures'/></mujocoinclude>");
  folder().Write("a.xml",
                 "<mujoco><include file='more.xml'/>\n"
                 "<asset><texture name='t' file='large.png'/><material name='m' texture='t'/>\n"
                 "</asset><worldbody><body name='b'><geom size='1' material='m'/></body>\n"
                 "</worldbody></mujoco>\n");
  CheckSpec("mjforge: 1\nname: crate\nbodies: [{name: b, mjcf: a.xml}]\n", "model/bad-texture");
  const auto file = Run({"validate", "a.xml", "-q"});
  CHECK(file.status == 1);
  CHECK(file.err.starts_with("a.xml:2:8: error: with texture 't' the pictures have more than "));
}

TEST_CASE_METHOD(BadInputTest,
                 "what is no text is named in one line, and an archive leads to its batch") {
  REQUIRE(
      Run({"generate", "hammer", "-n", "3", "--validate", "none", "-q", "-o", "x.tar"}).status ==
      0);
  CHECK(Run({"inspect", "x.tar"}).out == Run({"inspect", "x.manifest.jsonl"}).out);
  folder().Write("p.png", "\x89PNG\r\n\x1a\n and so on");
  std::filesystem::rename(folder() / "x.tar", folder() / "lone.tar");
  for (const char* command : {"inspect", "check", "generate", "preview"}) {
    const auto archive = Run({command, "lone.tar"});
    CHECK(archive.status == 1);
    CHECK(archive.err ==
          "mjforge: error: 'lone.tar' is a tar archive, not YAML text [yaml/not-text]\n"
          "  hint: 'mjforge inspect NAME.manifest.jsonl' shows what is in an archive of ours\n");
    CHECK(Run({command, "p.png"}).err ==
          "mjforge: error: 'p.png' is a picture (PNG), not YAML text [yaml/not-text]\n");
  }
  CHECK(Run({"validate", "lone.tar", "-q"}).err ==
        "mjforge: error: 'lone.tar' is a tar archive, not MJCF [mujoco/not-mjcf]\n");
}

TEST_CASE_METHOD(BadInputTest, "copies of assets have names that every system takes") {
  const std::string cube =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  folder().Write("a\\b.obj", cube);
  folder().Write("a:b.obj", cube + "# other\n");
  folder().Write("a\nb.obj", cube + "# another\n");
  folder().Write("s.yaml",
                 "mjforge: 1\nname: crate\nparts:\n"
                 "  - {name: a, type: mesh, file: 'a\\b.obj'}\n"
                 "  - {name: b, type: mesh, file: 'a:b.obj', pos: [2, 0, 0]}\n"
                 "  - {name: c, type: mesh, file: \"a\\nb.obj\", pos: [4, 0, 0]}\n");
  const auto result = Run({"generate", "s.yaml", "-q", "-o", "out"});
  CHECK(result.err.empty());
  for (const char* name : {"a_b.obj", "a_b_2.obj", "a_b_3.obj"})
    CHECK(std::filesystem::exists(folder() / "out/assets" / name));
  CHECK(Run({"validate", "out/crate_000000.xml", "-q"}).status == 0);
}

TEST_CASE_METHOD(BadInputTest, "loading has the time limit, too") {
  std::string spec = "mjforge: 1\nname: crate\nparams:\n";
  for (int i = 0; i < 100'000; ++i) spec += "  p" + std::to_string(i) + ": 1 .. 2\n";
  folder().Write("s.yaml", spec + "parts: [{name: a, type: sphere, size: p0}]\n");
  for (const char* command : {"generate", "check"}) {
    const auto result = Run({command, "s.yaml", "--time-limit", "0.05"});
    CHECK(result.status == 1);
    CHECK(result.err ==
          "mjforge: error: loading 's.yaml' took more than 0.05 s of CPU time [batch/too-slow]\n"
          "  hint: raise --time-limit, or see what the spec and what it imports have so much of\n");
    CHECK(folder().Files() == std::vector<std::string>{"s.yaml"});
  }
  CHECK(Run({"generate", "s.yaml", "--time-limit", "0.05", "--findings", "json"})
            .err.starts_with(R"({"severity":"error","code":"batch/too-slow")"));
}

TEST_CASE_METHOD(BadInputTest, "files that each import the next one twice are read once") {
  for (int i = 0; i < 40; ++i) {
    const std::string next = std::to_string(i + 1) + ".yaml";
    folder().Write(std::to_string(i) + ".yaml",
                   "mjforge: 1\nimport: [" + next + ", " + next + "]\n");
  }
  folder().Write("40.yaml", "mjforge: 1\nmaterials: {red: {rgba: [1, 0, 0, 1]}}\n");
  folder().Write("s.yaml",
                 "mjforge: 1\nname: crate\nimport: [0.yaml, 0.yaml]\n"
                 "parts: [{name: a, type: sphere, size: 1, material: red}]\n");
  CHECK(Run({"check", "s.yaml", "-n", "1", "--time-limit", "5"}).status == 0);
}

TEST_CASE_METHOD(BadInputTest, "a picture that cannot be read is not called something else") {
  std::filesystem::create_directory(folder() / "wood.png");
  folder().Write("s.yaml",
                 "mjforge: 1\nname: crate\nmaterials: {m: {texture: {file: wood.png}}}\n"
                 "parts: [{name: a, type: sphere, size: 1, material: m}]\n");
  CHECK(Run({"check", "s.yaml", "-n", "1"}).err.find("cannot read 'wood.png': ") !=
        std::string::npos);
}

TEST_CASE_METHOD(BadInputTest, "a batch stops where a file cannot be read, and goes on with it") {
  folder().Write("s.yaml",
                 "mjforge: 1\nname: crate\nparts:\n"
                 "  - {name: a, type: sphere, size: 1}\n"
                 "  - {name: b, if: index > 2, type: mesh, file: m.obj}\n");
  std::filesystem::create_directory(folder() / "m.obj");
  for (const char* out : {"out", "x.tar"}) {
    const auto stopped = Run({"generate", "s.yaml", "-n", "6", "-j", "1", "-o", out});
    INFO(stopped.err);
    CHECK(stopped.status == 3);
    CHECK(CountOf(stopped.err, "cannot read mesh 'm.obj': it is a folder") == 1);
    CHECK(stopped.err.find(" ok, stopped (") != std::string::npos);
  }
  CHECK(std::filesystem::exists(folder() / "out/crate_000002.xml"));
  std::filesystem::remove(folder() / "m.obj");
  folder().Write("m.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                 "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  for (const char* out : {"out", "x.tar"}) {
    const auto whole = Run({"generate", "s.yaml", "-n", "6", "-j", "1", "-o", out, "--resume"});
    INFO(whole.err);
    CHECK(whole.status == 0);
  }
}

}  // namespace
}  // namespace mjforge
