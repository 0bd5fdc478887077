// Geoms without collisions, which `discardvisual` removes.
#pragma once

#include <string>

#include "mjforge/backport/default_classes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// Returns true if the text of a number means zero.
bool IsZero(const std::string& text);
/// Returns true for geoms with a `contype` and `conaffinity` of 0.
bool IsVisual(const DefaultClasses& elements, const ClassedElement& geom);

/// Keeps visual geoms that contact pairs, tendons, sensors or tuples refer to, as MuJoCo 3.1.2 and
/// later do: removes the other visual geoms from the tree, and sets `discardvisual` to false. Older
/// releases remove all visual geoms, and reject the file. Changes nothing if nothing refers to a
/// visual geom. Returns the place of the first geom that is kept; no place if there is none.
diag::SourceMark KeepReferencedGeoms(xml::XmlElement& root);

}  // namespace mjforge::backport
