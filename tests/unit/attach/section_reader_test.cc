#include "mjforge/attach/section_reader.h"

#include <string>
#include <vector>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "attaching.h"

namespace mjforge::attach {
namespace {

// top > base > arm (hinge swing), beside them far.
const std::string kBodies =
    "<body name=\"top\"><geom name=\"lid\" size=\"1\"/><site name=\"hook\"/>\n"
    "<body name=\"base\"><joint name=\"lift\" type=\"slide\"/><geom name=\"block\" size=\"1\"/>"
    "<site name=\"eye\" pos=\"0 0 1\"/>\n"
    "<body name=\"arm\"><joint name=\"swing\" axis=\"0 1 0\"/><geom name=\"rod\" size=\"1\"/>"
    "<site name=\"tip\" pos=\"1 0 0\"/></body></body></body>\n"
    "<body name=\"far\"><geom name=\"rock\" size=\"1\"/><site name=\"peak\"/></body>\n";

/// The elements of a section, each as "tag 'name' attributes; child attributes".
std::vector<std::string> SaidIn(const model::Attachment& attachment, std::string_view name) {
  std::vector<std::string> lines;
  for (const model::Section& section : attachment.sections) {
    if (section.info->name != name) continue;
    for (const model::Element& element : section.elements) {
      std::string line =
          std::string(element.tag) + " '" + element.name + "' " + Said(element.attributes);
      for (const model::Element& child : element.children) {
        line += "; " + std::string(child.tag) + " " + Said(child.attributes);
      }
      lines.push_back(line);
    }
  }
  return lines;
}

std::string File(const std::string& sections) {
  return "<mujoco>\n<compiler angle=\"radian\"/>\n<worldbody>\n" + kBodies + "</worldbody>\n" +
         sections + "</mujoco>\n";
}

using Lines = std::vector<std::string>;

TEST_CASE("contacts between what is taken are taken") {
  Attaching files(
      File("<contact>\n<pair name=\"p\" geom1=\"rod\" geom2=\"block\" condim=\"4\"/>\n"
           "<exclude body1=\"arm\" body2=\"top\"/>\n"
           "<exclude name=\"out\" body1=\"arm\" body2=\"far\"/>\n"
           "<exclude name=\"world\" body1=\"world\" body2=\"far\"/>\n</contact>\n"));
  const model::Attachment& top = files.Get();
  CHECK(SaidIn(top, "contact") ==
        Lines{"pair 'p' geom1=block geom2=rod condim=4 friction=1 1 0.005 0.0001 0.0001 "
              "solref=0.02 1 solimp=0.9 0.95 0.001 0.5 2 margin=0 gap=0",
              "exclude '' body1=top body2=arm"});
  CHECK(top.sections[0].elements[0].attributes[0].refers == "geom");
  CHECK(top.sections[0].elements[0].mark.line == 10);
  CHECK(files.OnlyFinding() ==
        "warning attach/not-carried: exclude 'out' of 'arm.xml' is not carried over: it refers to "
        "body 'far', which is not attached [arm.xml:12:1 here]");
  CHECK(files.Get("far").sections.empty());
  REQUIRE(files.Report().size() == 2);  // `out`, seen from the other end, is the second
  CHECK(files.Report()[0] ==
        "warning attach/not-carried: exclude 'world' of 'arm.xml' is not carried over: it refers "
        "to the world, which is not attached [arm.xml:13:1 here]");
}

TEST_CASE("equalities are taken with what MuJoCo makes of them") {
  Attaching files(
      File("<default><equality solref=\"0.05 1\"/></default>\n<equality>\n"
           "<connect name=\"c\" body1=\"base\" body2=\"arm\" anchor=\"1 2 3\" active=\"false\"/>\n"
           "<weld name=\"w\" body1=\"top\" body2=\"arm\"/>\n"
           "<joint name=\"j\" joint1=\"swing\" joint2=\"lift\" polycoef=\"0 2 0 0 0\"/>\n"
           "<joint name=\"k\" joint1=\"swing\"/>\n"
           "<connect name=\"pinned\" body1=\"arm\" anchor=\"0 0 0\"/>\n</equality>\n"));
  CHECK(SaidIn(files.Get(), "equality") ==
        Lines{"connect 'c' body1=base body2=arm anchor=1 2 3 active=false solref=0.05 1",
              "weld 'w' body1=top body2=arm anchor=0 0 0 relpose=0 0 0 1 0 0 0 solref=0.05 1",
              "joint 'j' joint1=swing joint2=lift polycoef=0 2 0 0 0 solref=0.05 1",
              "joint 'k' joint1=swing polycoef=0 1 0 0 0 solref=0.05 1"});
  CHECK(files.OnlyFinding() ==
        "warning attach/not-carried: connect 'pinned' of 'arm.xml' is not carried over: it refers "
        "to the world, which is not attached [arm.xml:15:1 here]");
}

TEST_CASE("tendons are taken with what they pass, and their material") {
  Attaching files(
      File("<asset><material name=\"string\" rgba=\"1 0 0 1\"/></asset>\n<tendon>\n"
           "<spatial name=\"wire\" limited=\"true\" range=\"0 3\" material=\"string\" "
           "width=\"0.01\" user=\"0 1\"><site site=\"eye\"/><geom geom=\"rod\" sidesite=\"tip\"/>"
           "<site site=\"tip\"/><pulley divisor=\"2\"/><site site=\"tip\"/><site site=\"hook\"/>"
           "</spatial>\n<fixed springlength=\"0.5\"><joint joint=\"swing\" coef=\"2\"/></fixed>\n"
           "<spatial name=\"out\"><site site=\"tip\"/><site site=\"peak\"/></spatial>\n"
           "</tendon>\n<actuator><motor name=\"pull\" tendon=\"out\"/></actuator>\n"));
  const model::Attachment& top = files.Get();
  const Lines tendons = SaidIn(top, "tendon");
  REQUIRE(tendons.size() == 2);
  CHECK(tendons[0].starts_with("spatial 'wire' limited=true range=0 3 springlength="));
  CHECK(
      tendons[0].ends_with(" user=0 1 width=0.01 material=string; site site=eye; "
                           "geom geom=rod sidesite=tip; site site=tip; pulley divisor=2; "
                           "site site=tip; site site=hook"));
  if (mjVERSION_HEADER < 300) {  // later ones count a fixed tendon's length from the joints' zero
    CHECK(tendons[1] == "fixed '' limited=false springlength=0.5; joint joint=swing coef=2");
  }
  CHECK(Names(top.materials) == "string");
  CHECK(files.Report() ==
        Lines{"warning attach/not-carried: spatial 'out' of 'arm.xml' is not carried over: it "
              "refers to site 'peak', which is not attached [arm.xml:13:1 here]",
              "warning attach/not-carried: motor 'pull' of 'arm.xml' is not carried over: it "
              "refers to spatial 'out', which is not attached [arm.xml:15:11 here]"});
}

TEST_CASE("actuators of all kinds are written out in full") {
  Attaching files(
      File("<default><general gear=\"2\"/></default>\n<actuator>\n"
           "<position name=\"servo\" joint=\"swing\" kp=\"20\" ctrllimited=\"true\" "
           "ctrlrange=\"-1 1\"/>\n"
           "<general name=\"jet\" site=\"tip\" refsite=\"eye\" gear=\"1 0 0\"/>\n"
           "<general name=\"crank\" cranksite=\"tip\" slidersite=\"eye\" cranklength=\"3\"/>\n"
           "<muscle name=\"m\" joint=\"swing\" lengthrange=\"1 2\" force=\"10\"/>\n"
           "</actuator>\n"));
  CHECK(SaidIn(files.Get(), "actuator") ==
        Lines{"general 'servo' joint=swing ctrllimited=true ctrlrange=-1 1 forcelimited=false "
              "actlimited=false gear=2 0 0 0 0 0 dyntype=none gaintype=fixed biastype=affine "
              "dynprm=1 gainprm=20 biasprm=0 -20",
              "general 'jet' site=tip refsite=eye ctrllimited=false forcelimited=false "
              "actlimited=false dyntype=none gaintype=fixed biastype=none dynprm=1 gainprm=1 "
              "biasprm=0",
              "general 'crank' cranksite=tip slidersite=eye cranklength=3 ctrllimited=false "
              "forcelimited=false actlimited=false gear=2 0 0 0 0 0 dyntype=none gaintype=fixed "
              "biastype=none dynprm=1 gainprm=1 biasprm=0",
              "general 'm' joint=swing ctrllimited=false forcelimited=false actlimited=false "
              "lengthrange=1 2 gear=2 0 0 0 0 0 dyntype=muscle gaintype=muscle biastype=muscle "
              "dynprm=0.01 0.04 gainprm=0.75 1.05 10 200 0.5 1.6 1.5 1.3 1.2 biasprm=0.75 1.05 10 "
              "200 0.5 1.6 1.5 1.3 1.2"});
}

TEST_CASE("sensors say what they measure, by type; a clock refers to nothing") {
  Attaching files(
      File("<sensor>\n<jointpos name=\"angle\" joint=\"swing\" cutoff=\"3\" noise=\"0.1\"/>\n"
           "<framepos objtype=\"xbody\" objname=\"arm\" reftype=\"site\" refname=\"eye\"/>\n"
           "<user name=\"u\" objtype=\"geom\" objname=\"rod\" datatype=\"real\" needstage=\"acc\" "
           "dim=\"2\" user=\"1\"/>\n<clock name=\"now\"/>\n"
           "<framepos name=\"out\" objtype=\"body\" objname=\"arm\" reftype=\"body\" "
           "refname=\"far\"/>\n</sensor>\n"));
  const model::Attachment& top = files.Get();
  CHECK(SaidIn(top, "sensor") ==
        Lines{"jointpos 'angle' joint=swing cutoff=3 noise=0.1",
              "framepos '' objtype=xbody objname=arm reftype=site refname=eye",
              "user 'u' objtype=geom objname=rod datatype=real needstage=acc dim=2 user=1",
              "clock 'now'"});
  CHECK(top.sections[0].elements[1].attributes[1].refers == "@objtype");
  CHECK(files.OnlyFinding() ==
        "warning attach/not-carried: framepos 'out' of 'arm.xml' is not carried over: it refers to "
        "body 'far', which is not attached [arm.xml:14:1 here]");
}

TEST_CASE("a sensor of the world is reported") {
  Attaching files(File("<sensor><subtreecom name=\"all\" body=\"world\"/></sensor>\n"));
  CHECK(files.Get().sections.empty());
  CHECK(
      files.OnlyFinding() ==
      "warning attach/not-carried: subtreecom 'all' of 'arm.xml' is not carried over: it refers to "
      "the world, which is not attached [arm.xml:9:9 here]");
}

TEST_CASE("sections come in MJCF's order, and what concerns others is left out in silence") {
  Attaching files(
      File("<sensor><jointpos name=\"s\" joint=\"swing\"/></sensor>\n"
           "<actuator><motor name=\"a\" joint=\"swing\"/></actuator>\n"
           "<tendon><fixed name=\"t\"><joint joint=\"swing\" coef=\"1\"/></fixed></tendon>\n"
           "<equality><joint name=\"e\" joint1=\"swing\"/></equality>\n"
           "<contact><exclude name=\"x\" body1=\"arm\" body2=\"base\"/></contact>\n"));
  std::string names;
  for (const model::Section& section : files.Get().sections) {
    names += std::string(section.info->name) + " ";
  }
  CHECK(names == "contact equality tendon actuator sensor ");
  CHECK(files.Get("far").sections.empty());
  CHECK(files.Report().empty());
}

}  // namespace
}  // namespace mjforge::attach
