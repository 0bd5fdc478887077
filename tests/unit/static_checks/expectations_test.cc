// Findings of expectations about gaps and containment.
#include "mjforge/assemble/assemble.h"
#include "mjforge/static_checks/static_checks.h"

#include <catch2/catch.hpp>
#include <string>

namespace mjforge::static_checks {
namespace {

// Returns the findings of a spec with this body, whose first line is line 3 because of the header.
std::string FindingsOf(const std::string& body) {
  diag::Sources sources;
  diag::Findings findings;
  const auto spec = spec::LoadSpecText("thing.yaml", "mjforge: 1\nname: thing\n" + body, ".", {},
                                       sources, findings);
  if (spec != nullptr) {
    auto values = sample::Sample(*spec, {.seed = 1}, sample::kRootStream, {}, findings);
    REQUIRE(values);
    const auto object = assemble::Assembler().Assemble(*values, {}, findings);
    if (object) CheckExpectations(*object, findings);
  }
  std::string text;
  for (const diag::Finding& finding : findings) {
    if (finding.severity == diag::Severity::kWarning) continue;
    text += std::to_string(finding.mark.line) + " " + finding.message;
    if (!finding.hint.empty()) text += " (" + finding.hint + ")";
    text += "\n";
  }
  return text;
}

// A box of 20 cm on the floor, a lid of 1 cm on it that turns about its edge, and a ball that
// slides.
std::string OfBox(const std::string& expectations) {
  return FindingsOf(
      "joints: none\n"
      "params: {gap: 2mm, n: 2}\n"
      "parts: [{name: crate, type: box, size: [10cm, 10cm, 10cm], pos: [0, 0, 10cm]}]\n"
      "bodies:\n"
      "- {name: lid, pos: [-10cm, 0, 20cm + gap], joints: [{name: hinge, axis: [0, -1, 0], "
      "range: [0, 180deg]}], parts: [{name: plate, type: box, size: [10cm, 10cm, 5mm], pos: [10cm, "
      "0, 5mm]}, {name: knob, type: sphere, size: 1cm, pos: [10cm, 0, 2cm]}]}\n"
      "- {name: ball, pos: [0, 0, 10cm], joints: [{name: slide, type: slide, axis: [1, 0, 0], "
      "range: [-50cm, 50cm]}], parts: [{name: ball, type: sphere, size: 5cm}]}\n"
      "expect:\n" +
      expectations);
}

TEST_CASE("what is as expected gives no finding") {
  CHECK(OfBox("- mass > 1g\n"
              "- bounds.z < 24cm && bounds.x < 20.1cm\n"
              "- that: lid.mass < mass\n"
              "- {gap: [lid, crate], min: 2mm, max: 2mm}\n"
              "- {gap: [knob, crate], min: 1.2cm, max: 1.2cm}\n"
              "- {touch: [knob, lid]}\n"
              "- {touch: [knob, plate]}\n"
              "- {touch: [ball, crate]}\n"
              "- {apart: [ball, thing], at: {slide: 20cm}}\n"
              "- {apart: [lid, crate], at: {hinge: 90deg}}\n"
              "- {inside: [ball, thing]}\n"
              "- {inside: [ball, crate], at: {slide: 5cm}}\n"
              "- {for: {i: n}, if: i > 0, gap: [lid, crate], max: i * 2mm}\n") == "");
}

TEST_CASE("what is not as expected is told with the numbers found and asked") {
  CHECK(OfBox("- mass < 2kg\n") == "10 'mass < 2kg' does not hold: mass = 8.927787566\n");
  CHECK(OfBox("- {that: bounds.x > 1, doc: It must be wide.}\n") ==
        "10 'bounds.x > 1' does not hold: bounds.x = 0.2 (It must be wide.)\n");
  CHECK(OfBox("- {gap: [lid, crate], min: 3mm, doc: Or it rubs.}\n") ==
        "10 'lid' and 'crate' must be at least 3 mm apart, but are 2 mm apart (parts 'plate' and "
        "'crate') (Or it rubs.)\n");
  CHECK(OfBox("- {gap: [plate, crate], max: 1.5mm}\n") ==
        "10 'plate' and 'crate' must be at most 1.5 mm apart, but are 2 mm apart\n");
  CHECK(OfBox("- {gap: [ball, crate], max: -15mm, at: {slide: 14cm}}\n") ==
        "10 'ball' and 'crate' must be at most -15 mm apart, but are 10 mm in each other, at slide "
        "= 0.14\n");
  CHECK(OfBox("- {touch: [lid, thing]}\n") ==
        "10 'lid' and 'thing' must touch, but are 2 mm apart (parts 'plate' and 'crate')\n");
  CHECK(OfBox("- {apart: [ball, crate], at: {slide: 14cm}}\n") ==
        "10 'ball' and 'crate' must not be in each other, but are 10 mm in each other, at slide = "
        "0.14\n");
  CHECK(OfBox("- {gap: [ball, crate], min: -5mm, at: {slide: 14cm}}\n") ==
        "10 'ball' and 'crate' must be at least -5 mm apart, but are 10 mm in each other, at slide "
        "= 0.14\n");
  CHECK(OfBox("- {inside: [ball, crate], at: {slide: 6cm}}\n") ==
        "10 'ball' must be inside 'crate', but is 10 mm outside, at slide = 0.06\n");
  CHECK(OfBox("- {inside: [lid, thing]}\n") ==
        "10 'lid' must be inside 'thing', but is 32 mm outside (part 'knob')\n");
  // All at once.
  CHECK(OfBox("- mass < 2kg\n- {touch: [lid, thing]}\n- bounds.x > 1\n").find("\n11 ") !=
        std::string::npos);
  CHECK(OfBox("- {gap: [plate, crate], min: bounds.x, max: 1mm}\n") ==
        "10 'plate' and 'crate' must be at least 200 mm apart, but are 2 mm apart\n"
        "10 'plate' and 'crate' must be at most 1 mm apart, but are 2 mm apart\n");
  // Only the first failure of a repeated condition is reported.
  CHECK(OfBox("- {for: {i: 5}, that: i < 2}\n") == "10 'i < 2' does not hold: i = 2\n");
}

TEST_CASE("joints that are not named stand where they start") {
  const std::string ajar =
      "joints: none\nparts: [{name: crate, type: box, size: [1cm, 1cm, 1cm]}]\n"
      "bodies: [{name: ball, joints: [{name: slide, type: slide, axis: [0, 0, 1], range: [0, 1], "
      "ref: "
      "0.1}], parts: [{name: ball, type: sphere, size: 1cm, pos: [0, 0, 2cm]}]}]\n";
  CHECK(FindingsOf(ajar + "expect: [{touch: [ball, crate]}]\n").empty());
  CHECK(FindingsOf(ajar + "pose: {slide: 15cm}\nexpect: [{gap: [ball, crate], min: 5cm, max: "
                          "5cm}]\n")
            .empty());
  CHECK(FindingsOf(ajar + "pose: {slide: 15cm}\nexpect: [{touch: [ball, crate], at: {slide: 0.1}}]"
                          "\n")
            .empty());
}

TEST_CASE("parts that only show count where nothing collides") {
  const std::string parts =
      "parts: [{name: core, type: sphere, size: 1cm}, {name: skin, type: sphere, size: 2cm, role: "
      "visual}]\nbodies: [{name: flag, pos: [0, 0, 5cm], parts: [{name: cloth, type: sphere, size: "
      "1cm, role: visual}, {name: pole, type: sphere, size: 1mm, role: collision}]}]\n";
  CHECK(FindingsOf(parts +
                   "expect: [{gap: [flag, thing], min: 39mm, max: 39mm}, {gap: [cloth, skin], "
                   "min: 2cm, max: 2cm}]\n")
            .empty());
}

TEST_CASE("what an expectation cannot mean is an error at its place") {
  CHECK(OfBox("- {touch: [lidd, crate]}\n") ==
        "10 the object has no body and no part 'lidd' (did you mean 'lid'?)\n");
  CHECK(OfBox("- {touch: [lid, crate], at: {hinges: 1}}\n") ==
        "10 at: the object has no joint 'hinges' (did you mean 'hinge'?)\n");
  CHECK(
      OfBox("- {touch: [lid, crate], at: {hinge: 90}}\n") ==
      "10 position of joint 'hinge' is 90, outside its range 0 .. 3.141592654 (angles are in rad: "
      "write 90deg)\n");
  CHECK(OfBox("- {touch: [lid, lid]}\n") == "10 the two names are the same\n");
  CHECK(OfBox("- {touch: [lid]}\n") ==
        "10 expected the names of two bodies or parts: touch: [NAME, NAME]\n");
  CHECK(OfBox("- {touch: [lid, crate], gap: [lid, crate], min: 1}\n") ==
        "10 'gap' together with 'touch': an entry expects one thing\n"
        "10 'min' only has a meaning beside 'gap'\n");
  CHECK(OfBox("- {gap: [lid, crate]}\n") ==
        "10 'gap' without 'min' or 'max' (write {gap: [a, b], min: 0.2mm})\n");
  CHECK(OfBox("- {doc: nothing}\n") ==
        "10 nothing is expected here: 'that', 'gap', 'touch', 'apart' or 'inside' is missing\n");
  CHECK(OfBox("- {that: mass > 1g, at: {hinge: 1}}\n") ==
        "10 'at' has no meaning for a condition, which is on the object at rest\n");
  CHECK(OfBox("- {gap: [lid, crate], min: 1mm .. 2mm}\n") ==
        "10 what is expected cannot be drawn (draw it as a parameter and use that parameter's "
        "name)\n");
  CHECK(OfBox("- {gap: [lid, crate], min: 1kg}\n") == "10 min is in m, but this is in kg\n");
  CHECK(OfBox("- mass < 2m\n") ==
        "10 'mass' is in kg, but '2m' is in m (both sides of '<' must be in one unit)\n");
  CHECK(OfBox("- mass\n") != "");
  CHECK(OfBox("- [lid]\n") != "");
}

TEST_CASE("a parameter hides the object's mass") {
  CHECK(FindingsOf("params: {mass: 3kg}\nparts: [{name: a, type: sphere, size: 1cm, mass: mass}]\n"
                   "expect: [mass == 3kg]\n")
            .empty());
}

}  // namespace
}  // namespace mjforge::static_checks
