// Geoms that do not collide, and the compiler setting `discardvisual`, which removes them.
#pragma once

#include <string>

#include "mjforge/backport/default_classes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// Returns true if the text of a number means zero.
bool IsZero(const std::string& text);
/// Returns true if `contype` and `conaffinity` of the geom, including those from default classes,
/// are both 0.
bool IsVisual(const DefaultClasses& elements, const ClassedElement& geom);

/// If `discardvisual` is set, keeps visual geoms to which contact pairs, tendons, sensors or tuples
/// refer, as MuJoCo 3.1.2 and later do: removes all other visual geoms from the tree, and sets
/// `discardvisual` to false. Older releases would remove all visual geoms, and reject the file.
/// Changes nothing if nothing refers to a visual geom. Returns the place of the first geom that is
/// kept; no place if there is none.
diag::SourceMark KeepReferencedGeoms(xml::XmlElement& root);

}  // namespace mjforge::backport
