#include <catch2/catch.hpp>

#include "loading.h"

namespace {

// The keys of a joint, which begin at column 13 of line 4.
Strings ReportJoint(const std::string& keys) {
  return Load("mjforge: 1\nname: t\njoints:\n- {name: j, " + keys +
              "}\nparts: [{name: a, type: sphere, size: 1cm}]\n")
      .Report();
}

}  // namespace

TEST_CASE("a thread and a coupling say what they need", "[couplings]") {
  CHECK(ReportJoint("screw: {turns: 2}") ==
        Strings{"4:20 spec/missing-key: 'screw' without 'lead' (How far a full turn moves the body "
                "along the axis; negative for a left-handed thread.)"});
  CHECK(ReportJoint("couple: {joint: k}") ==
        Strings{"4:13 spec/missing-key: 'couple' without 'ratio', 'lead' or 'polycoef' (`ratio` is "
                "how far this joint moves for each m or rad of the other one)"});
  CHECK(
      ReportJoint("couple: {ratio: 1}") ==
      Strings{"4:21 spec/missing-key: 'couple' without 'joint' (The joint to follow, a hinge or a "
              "slide.)"});
  CHECK(
      ReportJoint("screw: 2mm") ==
      Strings{
          "4:20 spec/wrong-type: expected a mapping with the keys of 'screw', got a single value"});
  CHECK(ReportJoint("screw: {lead: 2mm, pitch: 2mm}") ==
        Strings{"4:32 spec/unknown-key: unknown key 'pitch' in a screw"});
}

TEST_CASE("keys that a thread or a coupling decides are conflicts", "[couplings]") {
  CHECK(ReportJoint("screw: {lead: 2mm}, range: [0, 1]") ==
        Strings{"4:33 spec/conflict: 'range' together with 'screw': a thread decides it"});
  CHECK(
      ReportJoint("couple: {joint: k, ratio: 2, polycoef: [0, 2]}") ==
      Strings{"4:42 spec/conflict: 'polycoef' together with 'ratio': a ratio is given in only one "
              "way"});
  CHECK(ReportJoint("type: ball, couple: {joint: k, ratio: 2}") ==
        Strings{"4:25 spec/conflict: 'couple' has no meaning for a ball joint (only a hinge or a "
                "slide follows another joint)"});
  CHECK(ReportJoint("couple: {joint: k, lead: 2mm}") ==
        Strings{"4:32 spec/conflict: 'lead' has no meaning for a hinge (`lead` is how far a slide "
                "moves for each turn of a hinge; `ratio` is for any two joints)"});
}

TEST_CASE("the lead of a thread is a length", "[couplings]") {
  CHECK(ReportJoint("screw: {lead: 2deg}").size() == 1);
  CHECK(ReportJoint("type: slide, couple: {joint: k, lead: 2mm}").empty());
}

TEST_CASE("defaults say how a coupled joint moves, and couple none", "[couplings]") {
  const std::string spec =
      "mjforge: 1\nname: t\ndefaults: {joint: {type: slide}}\nparts: [{name: a, type: sphere, "
      "size: "
      "1cm}]\njoints: [{name: j, type: hinge}, {name: k, couple: {joint: j, lead: 2mm}}]\n";
  CHECK(Load(spec).Report().empty());
  CHECK(Load("mjforge: 1\nname: t\ndefaults: {joint: {couple: {joint: j, ratio: 1}}}\n"
             "parts: [{name: a, type: sphere, size: 1cm}]\n")
            .Report() == Strings{"3:20 spec/conflict: 'couple' cannot be a default"});
}
