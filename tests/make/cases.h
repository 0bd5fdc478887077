#pragma once

#include <array>
#include <set>
#include <string>

namespace mjforge::make {

/// A file of the example and what of it is made from this file, directly or through others.
struct Dependents {
  std::string file;
  std::set<std::string> targets;
};

inline const std::set<std::string> kTrays = {"rack.xml", "tray.xml", "trays/manifest.jsonl"};
inline const std::set<std::string> kDrawers = {"drawer.xml", "drawers.manifest.jsonl",
                                               "drawers.tar"};

inline const std::array<Dependents, 7> kDependents = {{
    {"materials.yaml", kTrays},   // imported
    {"specs/tray.yaml", kTrays},  // a spec that another one nests
    {"specs/rack.yaml", {"rack.xml"}},
    {"specs/drawer.yaml", kDrawers},
    {"parts/handle.xml", kDrawers},  // attached
    {"parts/steel.xml", kDrawers},   // included by that
    {"parts/grip.obj", kDrawers},    // a mesh of that
}};

}  // namespace mjforge::make
