// Structures of small MJCF texts.
#pragma once

#include <string>

#include <catch2/catch.hpp>

#include "mjforge/engine/engine.h"
#include "mjforge/structure/structure.h"

namespace mjforge::structure {

/// Returns the structure of a model whose body `tool` has this content.
inline Structure Of(const std::string& content, const std::string& name = "tool",
                    const std::string& vertices = "0 0 0 1 0 0 0 1 0 0 0 1") {
  static engine::Engine engine;
  const engine::Loaded loaded = engine.LoadText(
      "<mujoco><compiler angle=\"radian\"/><asset><material name=\"red\"/><material name=\"blue\"/>"
      "<mesh name=\"wedge\" vertex=\"" +
      vertices +
      "\"/><mesh name=\"other\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\"/></asset><worldbody>"
      "<body name=\"" +
      name + "\">" + content + "</body></worldbody></mujoco>");
  INFO(loaded.error);
  REQUIRE(loaded.model);
  return StructureOf(*loaded.model, name);
}

}  // namespace mjforge::structure
