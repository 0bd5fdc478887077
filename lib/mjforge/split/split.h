// Division of a scene into separate objects with their poses at the start.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::split {

/// An object of a scene, complete by itself: its bodies, and the assets and elements of sections
/// that belong to these bodies.
struct ScenePart {
  model::Object object;  // named after its root body in the scene; its root is at the origin
  model::Pose X_WO;      // pose of the root body in the scene at the start
  std::string at;        // region or site that the object was placed at; empty: not placed
  bool is_free = false;
};

struct SplitOptions {
  bool prefix = true;     // true: the names of an object's elements begin with its name and `_`
  std::string_view root;  // name of each root body; empty: the object's name
};

/// Returns the objects of a scene in the order of its bodies. An object consists of a root and its
/// descendants up to other roots. Roots are: children of the world, such as free bodies, except a
/// root of the scene without parts and joints; children of such a root; and placed bodies whose
/// ancestors do not move. Names in the scene must have no prefix (the scene's name). Elements that
/// do not belong to exactly one object are left out, with a warning. Returns nullopt, after adding
/// a finding, if the scene is one object, or if two elements of an object would have the same name.
std::optional<std::vector<ScenePart>> Split(const model::Object& scene, const SplitOptions& options,
                                            diag::Findings& findings);

}  // namespace mjforge::split
