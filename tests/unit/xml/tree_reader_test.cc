#include "mjforge/xml/tree_reader.h"

#include <optional>
#include <string>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"

namespace mjforge::xml {
namespace {

std::string Including(const std::string& file) {
  return "<mujoco>\n<include file=\"" + file + "\"/>\n</mujoco>\n";
}

/// Files in a folder of their own.
struct Files {
  explicit Files(const std::string& arm) { folder.Write("arm.xml", arm); }

  std::optional<XmlElement> Read(const std::string& name) {
    findings.clear();
    return ReadXml(folder / name, sources, findings);
  }
  /// The error of a file with only one: "attach/bad-include: message (hint) [arm.xml:3:5 here]".
  std::string Error(const std::string& name) {
    CHECK_FALSE(Read(name));
    REQUIRE(findings.size() == 1);
    const diag::Finding& finding = *findings.begin();
    std::string text = fmt::format("{}: {}", diag::CodeName(finding.code), finding.message);
    if (!finding.hint.empty()) text += " (" + finding.hint + ")";
    for (const diag::Note& note : finding.notes) {
      text += fmt::format(" [{}:{}:{} {}]", sources.Name(note.mark.file), note.mark.line,
                          note.mark.column, note.message);
    }
    const std::string path = folder.path().string() + "/";
    for (std::size_t at = 0; (at = text.find(path)) != std::string::npos;) {
      text.erase(at, path.size());
    }
    return text;
  }

  harness::TemporaryFolder folder;
  diag::Sources sources;
  diag::Findings findings;
};

TEST_CASE("includes are put in place, at any depth, relative to the first file") {
  Files files(
      "<mujoco>\n<include file=\"parts/settings.xml\"/>\n<worldbody>\n"
      "<body name=\"b\"><INCLUDE file=\"parts/geoms.xml\"/></body>\n"
      "</worldbody>\n</mujoco>\n");
  files.folder.Write("parts/settings.xml",
                     "<mujoco><default><geom condim=\"6\"/></default>"
                     "<include file=\"parts/more.xml\"/></mujoco>");
  files.folder.Write("parts/more.xml", "<any><compiler angle=\"radian\"/></any>");
  files.folder.Write("parts/geoms.xml",
                     "<mujocoinclude>\n<geom name=\"g\" type=\"box\" size=\"1 1 1\"/>\n"
                     "<geom name=\"h\" size=\"1\"/>\n</mujocoinclude>");
  const std::optional<XmlElement> root = files.Read("arm.xml");
  REQUIRE(root);
  REQUIRE(root->children.size() == 3);
  CHECK(root->children[0].children[0].tag == "geom");
  CHECK(root->children[1].tag == "compiler");
  const XmlElement& body = root->children[2].children[0];
  REQUIRE(body.children.size() == 2);
  CHECK(body.children[1].Description() == "geom 'h'");
  CHECK(body.children[1].mark.line == 3);
}

TEST_CASE("an include that is missing, broken or empty is an error at its place") {
  Files files(Including("gone.xml"));
  CHECK(files.Error("arm.xml") ==
        "attach/bad-include: 'arm.xml' includes 'gone.xml', which cannot be read: No such file or "
        "directory [arm.xml:2:1 here]");
  files.folder.Write("b.xml", Including("broken.xml"));
  files.folder.Write("broken.xml", "<mujoco>\n<body>\n</mujoco>");
  CHECK(files.Error("b.xml") ==
        "attach/bad-include: 'b.xml' includes 'broken.xml', which is not an XML file: start-end "
        "tags mismatch [b.xml:2:1 here] [broken.xml:3:3 broken here]");
  files.folder.Write("e.xml", Including("empty.xml"));
  files.folder.Write("empty.xml", "<mujoco/>");
  CHECK(files.Error("e.xml") ==
        "attach/bad-include: 'e.xml' includes 'empty.xml', which contains no elements [e.xml:2:1 "
        "here]");
  files.folder.Write("n.xml", "<mujoco><include/></mujoco>");
  CHECK(files.Error("n.xml") ==
        "attach/bad-include: 'n.xml' has an include without a file [n.xml:1:9 here]");
  files.folder.Write("c.xml", "<mujoco><include file=\"arm.xml\"><body/></include></mujoco>");
  CHECK(files.Error("c.xml") ==
        "attach/bad-include: 'c.xml' has an include of 'arm.xml' that contains elements [c.xml:1:9 "
        "here]");
}

TEST_CASE("a cycle of includes and a second one of a file are errors") {
  Files files(Including("b.xml"));
  files.folder.Write("b.xml", Including("arm.xml"));
  CHECK(files.Error("arm.xml") ==
        "attach/bad-include: 'b.xml' includes 'arm.xml', which is already open: a cycle [b.xml:2:1 "
        "here]");
  files.folder.Write("twice.xml",
                     "<mujoco>\n<include file=\"c.xml\"/>\n<include file=\"./c.xml\"/>\n</mujoco>");
  files.folder.Write("c.xml", "<mujoco><worldbody/></mujoco>");
  CHECK(files.Error("twice.xml") ==
        "attach/bad-include: 'twice.xml' includes './c.xml' a second time (MuJoCo includes each "
        "file only once; give the copy another name) [twice.xml:3:1 here] [twice.xml:2:1 first "
        "here]");
}

}  // namespace
}  // namespace mjforge::xml
