#pragma once

#include <functional>
#include <string>

#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {

struct Loaded;

/// Gives bodies whose mass comes from meshes an `<inertial>` with what MuJoCo 3 computes. Releases
/// before take for the volume of a mesh that of the box with the same inertia, and refuse meshes
/// whose faces do not all look the same way; since 3.0 it is the sum of the pyramids from the
/// centre of mass to each face, whichever way that looks. `load` loads a text as if it were the
/// file. Where MuJoCo refuses that, the tree stays as it is, and it will say the same of the file.
void WeighMeshes(XmlElement& root, const std::function<Loaded(const std::string&)>& load);

}  // namespace mjforge::engine
