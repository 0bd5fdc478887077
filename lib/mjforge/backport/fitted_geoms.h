// Geoms that the compiler setting `fitaabb` fits to the bounding boxes of meshes.
#pragma once

#include <functional>
#include <string>

#include "mjforge/engine/engine.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// For each sphere, capsule, cylinder, ellipsoid and box that `fitaabb` fits to a mesh, replaces
/// the attribute `mesh` by the size, pos and quat that MuJoCo 3.3.7 and later compute: those of the
/// smallest shape whose axis-aligned bounding box contains the bounding box of the mesh. Older
/// releases fit a sphere, capsule or cylinder around all vertices, and rotate the centre of the box
/// wrongly; MuJoCo 2.2 also ignores the centre of mass of the mesh. `load` loads an MJCF text as if
/// it were the content of the file. Changes nothing if MuJoCo rejects the meshes, or is 3.3.7 or
/// later. Returns the place of the first changed geom; an empty mark if there is none.
diag::SourceMark FitGeoms(xml::XmlElement& root,
                          const std::function<engine::Loaded(const std::string&)>& load);

}  // namespace mjforge::backport
