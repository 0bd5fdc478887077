// Makes this MuJoCo compile MJCF by rules of later releases, if they differ from the rules of this
// MuJoCo.
#pragma once

#include <functional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/engine/engine.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// Places of the first elements to which the MuJoCo of this build applies another rule than later
/// releases. A place is an empty mark if there is no such element.
struct RuleDifferences {
  diag::SourceMark fitted;   // geom with a shape that is fitted to a mesh
  diag::SourceMark mass;     // body whose mass comes from meshes or discarded geoms
  diag::SourceMark visible;  // visual geom that is kept because an element refers to it

  explicit operator bool() const { return fitted || mass || visible; }
};

/// Changes the tree so that this MuJoCo compiles it as later releases do: shapes fitted to meshes
/// (FitGeoms), masses of meshes (AddMeshInertia), and geoms that `discardvisual` keeps
/// (KeepReferencedGeoms). `load` loads an MJCF text as if it were the content of the file.
RuleDifferences ApplyLaterRules(xml::XmlElement& root,
                                const std::function<engine::Loaded(const std::string&)>& load);

}  // namespace mjforge::backport
