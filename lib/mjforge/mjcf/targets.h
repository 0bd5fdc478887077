#pragma once

// Who reads the files, and what that reader adds, needs and refuses.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mjforge::mjcf {

enum class Target {
  kMujoco,     // complete and flat; can be simulated on its own
  kScene,      // the same with floor, light and camera; the object rests on the floor
  kRobosuite,  // its MujocoXMLObject
  kRobocasa,   // its MJCFObject
  kMjx,        // MuJoCo XLA, only with shapes that can collide there
};

/// A name that the host gives to something that it adds.
struct HostName {
  std::string_view kind;  // body, joint, site
  std::string_view name;
};

/// An element, or an attribute of one, that the host does not accept. Empty words match any.
struct Refusal {
  std::string_view section;
  std::string_view element = {};
  std::string_view attribute = {};
  std::string_view word = {};  // the attribute's text
  bool whole = true;           // the element is dropped, otherwise only the attribute
};

/// One row of the table of targets.
struct TargetRules {
  Target target;
  std::string_view name;  // of --target
  std::string_view doc;

  // How geoms are written.
  int collision_group = 3;  // MuJoCo's viewer hides it
  int visual_group = 2;
  bool own_groups = true;    // a part's own `group` comes before these
  bool same_look = false;    // collision geoms look like the visual ones
  bool states_mass = false;  // never the density, which the host overwrites
  int sphere_sizes = 1;      // numbers in a sphere's size
  bool round_shapes = true;  // cylinders and ellipsoids collide with boxes and meshes
  bool margins = true;       // geoms may have a margin

  // What the file has around the object.
  bool scene = false;          // floor, light and camera
  bool always_assets = false;  // <asset>, even if it is empty
  bool outer_body = false;     // an unnamed body around the root, with sites at the bounds
  bool region_box = false;     // a geom `reg_bbox` around the object

  // What the host adds, so the file leaves it out.
  bool prefix = true;                   // `NAME_` before every name
  std::string_view root = {};           // name of the root body; empty: the object's
  bool free_joint = true;               // the root's
  std::string_view twin_suffix = {};    // the host makes geoms NAME + this
  std::string_view region_prefix = {};  // geoms with this prefix mean something to the host
  std::span<const HostName> host_names = {};

  // What is dropped, with a warning.
  bool sections = true;       // contact, sensor, ...: all of them
  bool picture_sides = true;  // textures made of several files
  std::span<const Refusal> refusals = {};

  /// Whether objects may have to change for this target.
  bool adapts() const { return target != Target::kMujoco && target != Target::kScene; }
};

/// In the order of the enumeration.
std::span<const TargetRules> Targets();
std::vector<std::string_view> TargetNames();
const TargetRules& RulesOf(Target target);
std::optional<Target> FindTarget(std::string_view name);

}  // namespace mjforge::mjcf
