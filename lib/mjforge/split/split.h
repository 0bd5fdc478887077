// Division of a scene into its objects, each with its pose at the start.
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
  bool prefix = true;     // the names of an object's elements begin with `name_`
  std::string_view root;  // name of each root body; empty: the object's name
};

/// Returns the objects of a scene in the order of its bodies. An object begins at each free body,
/// at each body that was placed and does not move and, if the root of the scene has no parts, at
/// each child of the root. Names in the scene must have no prefix. Elements that belong to no
/// single object are left out, with a warning. Returns nullopt, after adding a finding, if the
/// scene is one object, or if two elements of an object would have the same name.
std::optional<std::vector<ScenePart>> Split(const model::Object& scene, const SplitOptions& options,
                                            diag::Findings& findings);

}  // namespace mjforge::split
