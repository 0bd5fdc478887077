// Applies the rules of later MuJoCo releases in the order in which they depend on each other.
#include "mjforge/backport/later_rules.h"

#include "mjforge/backport/fitted_geoms.h"
#include "mjforge/backport/mesh_inertia.h"
#include "mjforge/backport/visual_geoms.h"

namespace mjforge::backport {

RuleDifferences ApplyLaterRules(xml::XmlElement& root,
                                const std::function<engine::Loaded(const std::string&)>& load) {
  RuleDifferences rules;
  rules.fitted = FitGeoms(root, load);
  rules.mass = AddMeshInertia(root, load);  // before the next step, which removes geoms with mass
  rules.visible = KeepReferencedGeoms(root);
  return rules;
}

}  // namespace mjforge::backport
