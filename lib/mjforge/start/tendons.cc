// Springs of tendons, whose rest length MuJoCo may take from the zero configuration.
#include "mjforge/start/rewriting.h"

namespace mjforge::start {

// Compares the tendon's path at qpos_spring before and after the move of zero. MuJoCo takes the
// rest length at qpos_spring, which depends on qpos0 only for ball and free joints.
bool ChangesSpring(const Configurations& configurations, const model::Element& tendon) {
  return tendon.tag == "spatial" && NumberOf(tendon, "stiffness", 0, 0) != 0 &&
         !(NumberOf(tendon, "springlength", 0, -1) >= 0) &&
         configurations.ChangesPath(tendon, configurations.Springs(/*balls_start=*/false),
                                    configurations.Springs(/*balls_start=*/true));
}

void RewriteTendons(const Configurations& configurations, model::Object& object) {
  for (model::Section& section : object.sections) {
    if (section.info->name != "tendon") continue;
    for (model::Element& tendon : section.elements) {
      if (!ChangesSpring(configurations, tendon)) continue;
      const double rest = configurations.Length(tendon, configurations.Springs(false));
      SetNumbers(tendon.attributes, "springlength", {rest});
    }
  }
}

}  // namespace mjforge::start
