// Tests of the reader of `checks:`.

#include "mjforge/model/model.h"

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

const std::string kBallPart = "parts: [{name: a, type: sphere, size: 1}]\n";

TEST_CASE("an object without checks has those of the field table") {
  // A spec that states each default of the field table gives the same checks.
  std::string said = "checks:\n";
  for (const spec::FieldInfo& field : spec::kChecksElement.fields) {
    std::string text(field.default_text);
    if (text.empty() || text == "unlimited") continue;
    const std::size_t blank = text.find(' ');
    if (blank != std::string::npos) text = "[" + text.replace(blank, 1, ", ") + "]";
    said += "  " + std::string(field.key) + ": " + text + "\n";
  }
  const model::Checks checks = Assembling(said + kBallPart).object().checks;
  CHECK(checks == Assembling(kBallPart).object().checks);
  CHECK(checks == model::Checks());
}

TEST_CASE("thresholds are computed from parameters, in SI units") {
  const model::Checks checks = Assembling(
                                   "params: {size: 2cm, light: true}\n"
                                   "checks:\n"
                                   "  stable: light\n"
                                   "  tilt: 90deg\n"
                                   "  sink: size / 10\n"
                                   "  drift: \"light ? 5mm : 1\"\n"
                                   "  density: [size * 10kg / 1m ^ 4, 100]\n"
                                   "  silence: {physics/thin: it is paper}\n" +
                                   kBallPart)
                                   .object()
                                   .checks;
  CHECK(checks.stable);
  CHECK(checks.tilt == Approx(M_PI / 2));
  CHECK(checks.sink == Approx(0.002));
  CHECK(checks.drift == Approx(0.005));
  CHECK(checks.density == Eigen::Vector2d(0.2, 100));
  REQUIRE(checks.silenced.size() == 1);
  CHECK(checks.silenced[0].first == "physics/thin");
  CHECK(checks.silenced[0].second == "it is paper");
}

TEST_CASE("a range of densities that is upside down is an error") {
  CHECK(OnlyFinding("checks: {density: [100, 10]}\n" + kBallPart) ==
        "3:19 density of checks 'thing' has its higher end first");
}

}  // namespace
}  // namespace mjforge::assemble
