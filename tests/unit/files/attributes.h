// Attributes of meshes and textures in tests.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/model/object.h"

namespace mjforge::files {

inline model::Attribute Word(std::string_view name, std::string text) {
  return {.name = name, .numbers = {}, .text = std::move(text)};
}

inline model::Attribute Numbers(std::string_view name, std::vector<double> numbers) {
  return {.name = name, .numbers = sample::Numbers(numbers.begin(), numbers.end()), .text = {}};
}

}  // namespace mjforge::files
