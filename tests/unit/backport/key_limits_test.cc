#include "mjforge/backport/key_limits.h"

#include <string>

#include "backported.h"

namespace mjforge::backport {
namespace {

std::string Key(std::size_t numbers) {
  std::string qpos;
  for (std::size_t i = 0; i < numbers; ++i) qpos += "0\n ";
  return "<keyframe>\n<key name=\"k\" time=\"1\" qpos=\"" + qpos + "\"/></keyframe>";
}

TEST_CASE("a key has at most 1000 numbers up to MuJoCo 3.2.4") {
  CHECK_FALSE(Backported(Key(1000)).changed);
  CHECK_FALSE(Backported(Key(1001), 325).changed);
  const Backported longer(Key(1001));
  CHECK(longer.changed);
  CHECK(longer.findings == Strings{"3:24 warning: 'qpos' of key 'k' is left out: it has 1001 "
                                   "numbers, and MuJoCo 2.2.2 rejects a key with more than 1000"});
  CHECK(longer.Says("time=\"1\""));
  CHECK_FALSE(longer.Says("qpos"));
}

TEST_CASE("a key is not reported if only bodies are used") {
  const Backported bodies(Key(1001), kPortable, Use::kBodies);
  CHECK(bodies.changed);
  CHECK(bodies.findings.empty());
}

}  // namespace
}  // namespace mjforge::backport
