// Masses and inertias of bodies made of meshes, by the rules of MuJoCo 3.
#pragma once

#include <functional>
#include <string>

#include "mjforge/engine/engine.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// True if this build can apply the attribute `inertia` of meshes: MuJoCo 2.2 to 2.3 by
/// AddMeshInertia(), and 3.3 and later because they have the attribute themselves.
inline constexpr bool kComputesMeshInertia = mjVERSION_HEADER < 300 || mjVERSION_HEADER >= 330;

/// Adds an `<inertial>` element, with the values of MuJoCo 3, to each body whose mass comes from
/// meshes. MuJoCo 3 adds up the volumes of the pyramids from the centre of mass to each face,
/// whatever the orientation of the face, and counts the masses of geoms that `discardvisual`
/// removes. Older releases use the volume of the box with the same inertia, and reject meshes with
/// inconsistently oriented faces. Applies and removes the attribute `inertia` of meshes (MuJoCo
/// 3.2.5). `load` loads an MJCF text as if it were the content of the file. If MuJoCo rejects the
/// file even without this attribute, only removes the attribute, because an error about the
/// attribute would hide the reason. Changes nothing in MuJoCo 3. Returns the place of the first
/// changed body; no place if there is none.
diag::SourceMark AddMeshInertia(xml::XmlElement& root,
                                const std::function<engine::Loaded(const std::string&)>& load);

}  // namespace mjforge::backport
