#include <catch2/catch.hpp>

#include "mjforge/mjcf/element_writer.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {
namespace {

TEST_CASE("a form fills its slots with the numbers that the tape has now, and the index") {
  tape::Tape tape;
  double& size = tape.Keep(0.5);
  double& noise = tape.Keep(1.0);
  double& lift = tape.Keep(2.0);
  MjcfDocument document;
  document.text = "<!-- index=7 -->";
  document.slots.push_back({11, 12, Slot::Spelling::kIndex});
  ElementWriter writer(document);
  writer.Line("");
  document.size_position = document.text.size();
  writer.Open("geom");
  writer.Number("size", Traced<double>(0.5, tape, size));
  writer.Append(3);
  document.world_position = document.text.size();
  writer.Number("mass", Traced<double>(0.5, tape, size));
  writer.Point("pos",
               Traced<Eigen::Vector3d>(tape::Gather<Eigen::Vector3d>(
                   std::array<Traced<double>, 3>{0.0, Traced<double>(1, tape, noise), 2.0})));
  writer.Close();
  document.lift = Traced<double>(2, tape, lift);
  const std::string before = document.text;
  Form form(document);

  size = 0.125;
  noise = 1e-17;
  lift = 3;
  REQUIRE(tape.Run());
  MjcfDocument filled;
  filled.text = "anything";
  form.Fill(12345, filled);
  CHECK(filled.text ==
        "<!-- index=12345 -->\n<geom size=\"0.125\"3 mass=\"0.125\" pos=\"0 0 2\"/>\n");
  CHECK(filled.size_position == document.size_position + 4);
  CHECK(filled.text.substr(filled.world_position, 5) == " mass");
  CHECK(static_cast<double>(filled.lift) == 3);
  CHECK(filled.lift.tape() == nullptr);
  CHECK(filled.slots.empty());
  CHECK(before == document.text);
}

TEST_CASE("what stands in front of the first slot does not move") {
  MjcfDocument document;
  document.text = "<a/>1";
  document.size_position = 0;
  document.world_position = std::string::npos;
  document.slots.push_back({4, 5, Slot::Spelling::kIndex});
  MjcfDocument filled;
  Form(document).Fill(20, filled);
  CHECK(filled.text == "<a/>20");
  CHECK(filled.size_position == 0);
  CHECK(filled.world_position == std::string::npos);
}

}  // namespace
}  // namespace mjforge::mjcf
