// Pairs of reference files and specs, with the settings that make the same object.

#include "cases.h"
#include "harness/source_folder.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"

namespace mjforge::parity {
namespace {

using nlohmann::json;
using Settings = std::vector<spec::Setting>;

constexpr std::string_view kRed = "[1, 0, 0, 1]";
constexpr std::string_view kGreen = "[0, 1, 0, 1]";
constexpr std::string_view kBlue = "[0, 0, 1, 1]";
constexpr std::string_view kCyan = "[0, 1, 1, 1]";
constexpr std::string_view kFrictionText = "[1, 0.005, 0.0001]";

// Collects settings of a spec from the values of a reference.
class Pins {
 public:
  explicit Pins(const json& reference) : reference_(reference) {}

  // Returns a derived (drawn) value in preference to a requested one.
  const json& Given(const std::string& name) const {
    const json& derived = reference_.at("derived");
    return derived.contains(name) ? derived.at(name) : reference_.at("params").at(name);
  }
  bool Has(const std::string& name) const { return !Given(name).is_null(); }

  void Set(std::string name, std::string_view value) {
    settings_.push_back({.name = std::move(name), .text = std::string(value)});
  }
  void SetFlag(std::string name, bool value) { Set(std::move(name), value ? "true" : "false"); }
  void SetNumber(std::string name, double value) {
    Set(std::move(name), expr::ExactNumberText(value));
  }

  // Sets a parameter to the reference's value. JSON is valid YAML.
  void Same(const std::string& name) {
    const json& value = Given(name);
    const bool single = value.is_array() && value.size() == 1;
    Set(name, single ? value.front().dump() : value.dump());
  }
  void Same(std::initializer_list<const char*> names) {
    for (const char* name : names) Same(name);
  }
  void SameOr(const std::string& name, std::string_view fallback) {
    if (Has(name)) {
      Same(name);
    } else {
      Set(name, fallback);
    }
  }

  Settings Take() { return std::move(settings_); }

 private:
  const json& reference_;
  Settings settings_;
};

Settings PrimitivePins(const json& reference) {
  Pins pins(reference);
  const bool is_cylinder = reference.at("class") == "CylinderObject";
  pins.Same("size");
  pins.SameOr("density", "1000");
  if (pins.Given("friction").is_number()) {
    pins.Set("friction", fmt::format("[{}, 0.005, 0.0001]", pins.Given("friction").dump()));
  } else {
    pins.SameOr("friction", is_cylinder ? "[1, 0.01, 0.001]" : kFrictionText);
  }
  pins.SameOr("solref", is_cylinder ? "[0.01, 0.5]" : "[0.02, 1]");
  pins.SameOr("solimp", "[0.9, 0.95, 0.001]");
  pins.SameOr("rgba", kRed);
  pins.Set("material", pins.Has("material") ? "patterned" : "plain");
  const auto role = pins.Given("obj_type").get<std::string>();
  pins.Set("obj_type", role == "all" ? "both" : role);
  pins.Set("joints", pins.Has("joints") ? "free" : "none");
  return pins.Take();
}

Settings HammerPins(const json& reference) {
  Pins pins(reference);
  pins.Same({"handle_shape", "handle_radius", "handle_length", "handle_density", "handle_friction",
             "head_halfsize", "head_density_ratio", "use_texture"});
  pins.SameOr("rgba_handle", kRed);
  pins.SameOr("rgba_head", kCyan);
  pins.SameOr("rgba_face", kBlue);
  pins.SameOr("rgba_claw", kGreen);
  return pins.Take();
}

Settings PotPins(const json& reference) {
  Pins pins(reference);
  pins.Same({"body_half_size", "handle_radius", "handle_length", "handle_width", "handle_friction",
             "density", "use_texture", "solid_handle", "thickness"});
  pins.Set("solref", "[0.02, 1]");
  pins.SameOr("rgba_body", kRed);
  pins.SameOr("rgba_handle_0", kGreen);
  pins.SameOr("rgba_handle_1", kBlue);
  return pins.Take();
}

Settings BinPins(const json& reference) {
  Pins pins(reference);
  pins.Set("solref", "[0.02, 1]");
  pins.Same({"bin_size", "wall_thickness", "transparent_walls", "density", "use_texture", "rgba"});
  pins.SameOr("friction", kFrictionText);
  return pins.Take();
}

Settings LidPins(const json& reference) {
  Pins pins(reference);
  pins.Same({"lid_size", "handle_size", "transparent", "density", "use_texture", "rgba"});
  pins.SameOr("friction", kFrictionText);
  return pins.Take();
}

// Sets gap, damping and friction to 0, because the reference has none.
Settings HingedBoxPins(const json& reference) {
  Pins pins(reference);
  pins.Same({"box1_size", "box2_size", "use_texture"});
  pins.Set("gap", "0");
  pins.Set("max_angle", "1.57");
  pins.Set("damping", "0");
  pins.Set("frictionloss", "0");
  pins.Set("rgba_box1", kRed);
  pins.Set("rgba_box2", kBlue);
  return pins.Take();
}

// Converts two parameters with other meanings. robosuite's `height` is half the height, and its
// boxes end at inner_radius * cos(pi / ngeoms) from the axis, so that a peg of inner_radius does
// not fit; our inner_radius is the radius of a peg that fits.
Settings HollowCylinderPins(const json& reference) {
  Pins pins(reference);
  pins.Same({"outer_radius", "ngeoms", "density", "solref", "solimp", "make_half"});
  pins.SetNumber("height", 2 * pins.Given("height").get<double>());
  pins.SetNumber("inner_radius",
                 pins.Given("inner_radius").get<double>() *
                     std::cos(std::numbers::pi / pins.Given("ngeoms").get<double>()));
  pins.SameOr("friction", kFrictionText);
  pins.SameOr("rgba", "[0.5, 0.5, 0.5, 1]");
  pins.SetFlag("use_texture", pins.Has("material"));
  return pins.Take();
}

Settings HookPins(const json& reference) {
  Pins pins(reference);
  pins.Same({"frame_length", "frame_height", "frame_thickness", "density", "solref", "solimp",
             "use_texture", "rgba"});
  pins.SameOr("friction", kFrictionText);
  pins.SetFlag("hook", pins.Has("hook_height"));
  if (pins.Has("hook_height")) pins.Same("hook_height");
  pins.SetFlag("grip", pins.Has("grip_size"));
  if (pins.Has("grip_size")) pins.Same({"grip_location", "grip_size"});
  pins.SetFlag("tip", pins.Has("tip_size"));
  if (pins.Has("tip_size")) pins.Same("tip_size");
  return pins.Take();
}

Settings StandPins(const json& reference) {
  Pins pins(reference);
  pins.Same({"size", "mount_location", "mount_width", "wall_thickness", "base_thickness",
             "add_hole_vis", "density", "solref", "solimp", "use_texture", "rgba"});
  pins.SameOr("friction", kFrictionText);
  return pins.Take();
}

constexpr Case kCases[] = {
    {"ball_explicit", "primitives/ball", PrimitivePins},
    {"ball_visual_only", "primitives/ball", PrimitivePins},
    {"bin_default", "robosuite/bin", BinPins},
    {"bin_rect_opaque", "robosuite/bin", BinPins},
    {"box_collision_only", "primitives/box", PrimitivePins},
    {"box_contact_params", "primitives/box", PrimitivePins},
    {"box_explicit", "primitives/box", PrimitivePins},
    {"box_sampled_default", "primitives/box", PrimitivePins},
    {"box_textured", "primitives/box", PrimitivePins},
    {"capsule_explicit", "primitives/capsule", PrimitivePins},
    {"cbody_chain_three_levels", "cbody_chain_three_levels.yaml"},
    {"cbody_corner_nested", "cbody_corner_nested.yaml"},
    {"cbody_corner_total_size", "cbody_corner_total_size.yaml"},
    {"cbody_hollow_ends", "cbody_hollow_ends.yaml"},
    {"cbody_negative_offsets", "cbody_negative_offsets.yaml"},
    {"cbody_of_composites", "cbody_of_composites.yaml"},
    {"cbody_rotated_parents", "cbody_rotated_parents.yaml"},
    {"composite_center_box_cylinder", "composite_center_box_cylinder.yaml"},
    {"composite_corner_mixed_types", "composite_corner_mixed_types.yaml"},
    {"composite_per_geom_values", "composite_per_geom_values.yaml"},
    {"cylinder_explicit", "primitives/cylinder", PrimitivePins},
    {"cylinder_slide_hinge", "cylinder_slide_hinge.yaml"},
    {"hammer_box_rgba_custom", "robosuite/hammer", HammerPins},
    {"hammer_box_textured_sampled", "robosuite/hammer", HammerPins},
    {"hammer_cylinder_rgba", "robosuite/hammer", HammerPins},
    {"hammer_cylinder_textured", "robosuite/hammer", HammerPins},
    {"hinged_default", "robosuite/hinged_box", HingedBoxPins},
    {"hinged_rect_rgba", "robosuite/hinged_box", HingedBoxPins},
    {"hollow_cylinder_half_n8", "robosuite/hollow_cylinder", HollowCylinderPins},
    {"hollow_cylinder_material", "robosuite/hollow_cylinder", HollowCylinderPins},
    {"hollow_cylinder_n50", "robosuite/hollow_cylinder", HollowCylinderPins},
    {"hollow_cylinder_n5_odd", "robosuite/hollow_cylinder", HollowCylinderPins},
    {"hollow_cylinder_n8", "robosuite/hollow_cylinder", HollowCylinderPins},
    {"hook_all_rgba", "robosuite/hook_frame", HookPins},
    {"hook_plain", "robosuite/hook_frame", HookPins},
    {"hook_with_grip", "robosuite/hook_frame", HookPins},
    {"hook_with_hook", "robosuite/hook_frame", HookPins},
    {"hook_with_tip", "robosuite/hook_frame", HookPins},
    {"lid_default", "robosuite/lid", LidPins},
    {"lid_opaque_texture", "robosuite/lid", LidPins},
    {"pot_default", "robosuite/pot_with_handles", PotPins},
    {"pot_rectangular", "robosuite/pot_with_handles", PotPins},
    {"pot_rgba", "robosuite/pot_with_handles", PotPins},
    {"pot_solid_handles", "robosuite/pot_with_handles", PotPins},
    {"stand_default", "robosuite/stand_with_mount", StandPins},
    {"stand_hole_vis", "robosuite/stand_with_mount", StandPins},
    {"stand_mount_offset", "robosuite/stand_with_mount", StandPins},
};

}  // namespace

std::span<const Case> Cases() { return kCases; }

std::string SpecPath(const Case& one) {
  if (!one.spec.ends_with(".yaml")) return std::string(one.spec);
  return (harness::SourceFolder() / "tests/parity/specs" / one.spec).string();
}

}  // namespace mjforge::parity
