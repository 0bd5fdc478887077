#pragma once

// The pieces of a file, in the order WriteMjcf puts them together.

#include <string_view>

#include "mjforge/mjcf/element_writer.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::mjcf {

/// How geoms are written for a target.
struct GeomGroups {
  // The groups they are shown and filtered by, as attributes.
  std::string_view collision;
  std::string_view visual;
  int sphere_sizes = 1;  // numbers in a sphere's size: 1, or 3 equal ones
};
const GeomGroups& GroupsOf(Target target);

/// Textures, materials and meshes, without the element around them; adds the files they name to the
/// document's. `as_files`: none of them is inline.
void WriteAssets(const model::Object& object, bool as_files, ElementWriter& writer,
                 MjcfDocument& document);

/// The tree of bodies. `lift`, m, is added to the height of root bodies.
void WriteBodies(const model::Object& object, const GeomGroups& groups, double lift,
                 ElementWriter& writer);

/// An element with its attributes and everything in it.
void WriteElement(const model::Element& element, ElementWriter& writer);
/// Settings of the whole model (option, size, visual, statistic, custom).
void WriteSettings(const model::Object& object, ElementWriter& writer);
/// Sections that refer to bodies (contact, equality, tendon, actuator, sensor), and the keyframe.
void WriteSections(const model::Object& object, double lift, ElementWriter& writer);

/// The keyframe of the positions that joints start from, if any has one.
void WriteKeyframe(const model::Object& object, double lift, ElementWriter& writer);

/// How far a scene lifts the object so that it rests on the floor at z = 0, m.
double LiftOntoFloor(const model::Object& object);
/// Room for the contacts and constraints of a large object, if MuJoCo's default sizes might not be
/// enough.
void WriteSizes(const model::Object& object, bool scene, ElementWriter& writer);
void WriteSceneAssets(ElementWriter& writer);
/// Floor, light and camera.
void WriteSceneWorld(const model::Object& object, ElementWriter& writer);

}  // namespace mjforge::mjcf
