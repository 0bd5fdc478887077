// Targets: the host programs that read generated MJCF files, and the requirements of each host.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mjforge::mjcf {

/// Program for which a file is written.
enum class Target {
  kMujoco,     // complete and flat; can be simulated on its own
  kScene,      // like kMujoco with floor, light and camera; the object rests on the floor
  kRobosuite,  // robosuite's MujocoXMLObject
  kRobocasa,   // robocasa's MJCFObject
  kMjx,        // MuJoCo XLA, only with shapes that can collide there
};

/// Name of an element that the host adds itself.
struct HostName {
  std::string_view kind;  // body, joint, site
  std::string_view name;
};

/// An element or attribute that the host does not accept. An empty `element` matches all elements
/// of the section. An empty `attribute` matches the whole element. An empty `text` matches all
/// values of the attribute except 0 and "disable".
struct UnsupportedFeature {
  std::string_view section;
  std::string_view element = {};
  std::string_view attribute = {};
  std::string_view text = {};  // unsupported value of the attribute
  bool drops_element = true;   // false: drops only the attribute
};

/// Row of the table of targets.
struct TargetRules {
  Target target;
  std::string_view name;  // value of the option --target
  std::string_view doc;

  // Requirements on geoms.
  int collision_group = 3;  // MuJoCo's viewer hides this group
  int visual_group = 2;
  bool keeps_groups = true;             // a part's own `group` takes precedence
  bool shows_collision_copies = false;  // the host shows copies of collision geoms
  bool writes_mass = false;             // geoms have a mass, because the host overwrites densities
  int sphere_sizes = 1;                 // count of the numbers in a sphere's size
  bool supports_round_shapes = true;    // cylinders and ellipsoids collide with boxes and meshes
  bool supports_margins = true;         // geoms may have a margin

  // Elements that the file has in addition to the object.
  bool has_scene = false;          // floor, light and camera
  bool always_has_assets = false;  // <asset>, even if it is empty
  bool has_outer_body = false;     // unnamed parent of the root, with sites at the bounds
  bool has_region_geoms = false;   // geom `reg_bbox` around the object, `reg_NAME` for regions

  // Names in the file, and names and elements that the host adds itself.
  bool has_prefix = true;                    // every name in the file begins with `NAME_`
  std::string_view root = {};                // name of the root body; empty: the object's name
  bool has_free_joint = true;                // the file has the free joint of the root
  std::string_view visual_copy_suffix = {};  // end of names of visual copies that the host adds
  std::string_view region_prefix = {};       // prefix of geoms that the host reads as regions
  std::span<const HostName> host_names = {};

  // Name of the MJCF file, if each object of a scene (--each) gets a folder of its own.
  std::string_view file_in_folder = {};

  bool repeats_start = false;  // the file has a keyframe even if the start is qpos0

  // Elements that the host supports. Unsupported elements are dropped with a warning.
  bool supports_sections = true;       // sections such as contact and sensor
  bool supports_texture_sides = true;  // textures composed of several files
  std::span<const UnsupportedFeature> unsupported = {};

  /// Returns true if shapes, geoms, names or bodies may have to change for this target.
  bool adapts() const { return target != Target::kMujoco && target != Target::kScene; }
};

/// Returns the rules of all targets, in the order of the enum Target.
std::span<const TargetRules> Targets();
std::vector<std::string_view> TargetNames();
const TargetRules& RulesOf(Target target);
std::optional<Target> FindTarget(std::string_view name);

}  // namespace mjforge::mjcf
