// Writers of the sections of an MJCF file, called by WriteMjcf in the order of the file.
#pragma once

#include "mjforge/mjcf/element_writer.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::mjcf {

/// Writes textures, materials and meshes without the <asset> element around them. Adds to the
/// document the files that these elements name. If `as_files` is true, writes references to
/// generated files in place of inline data.
void WriteAssets(const model::Object& object, bool as_files, ElementWriter& writer,
                 MjcfDocument& document);

/// Returns the attribute that puts a geom into `group` (0 to 3): ` group="3"`.
std::string_view GroupAttribute(int group);
/// Writes the tree of bodies. `lift`, m, is added to the height of children of the world.
void WriteBodies(const model::Object& object, const TargetRules& rules, double lift,
                 ElementWriter& writer);

/// Writes an element with its attributes and children.
void WriteElement(const model::Element& element, ElementWriter& writer);
/// Writes settings of the whole model (option, size, visual, statistic, custom).
void WriteSettings(const model::Object& object, ElementWriter& writer);
/// Writes sections that may refer to elements of the bodies (contact, equality, tendon, actuator,
/// sensor), and the keyframe. `lift`, m, is added to the height of free bodies in the keyframe.
void WriteSections(const model::Object& object, double lift, ElementWriter& writer);

/// Writes a keyframe with the start state, unless the start state is MuJoCo's default. `lift`, m,
/// is added to the height of free bodies.
void WriteKeyframe(const model::Object& object, double lift, ElementWriter& writer);

/// Returns the height, m, by which the object must be raised to rest on the floor at z = 0;
/// negative if the object must be lowered.
double LiftOntoFloor(const model::Object& object);
/// Writes a <size> element with room for the contacts and constraints of a large object if the
/// default sizes of MuJoCo 2.2 might not be enough. `scene` is true if the file has a floor.
void WriteSizes(const model::Object& object, bool scene, ElementWriter& writer);
/// Writes texture and material of the scene's floor.
void WriteSceneAssets(ElementWriter& writer);
/// Writes floor, light and camera of a scene around the object.
void WriteSceneWorld(const model::Object& object, ElementWriter& writer);

}  // namespace mjforge::mjcf
