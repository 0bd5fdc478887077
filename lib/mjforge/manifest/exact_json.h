#pragma once

#include <string_view>

#include <rapidjson/document.h>

namespace mjforge::manifest {

/// Parses a JSON text; false if it is none or a number in it is too large. Numbers are those that
/// their digits say, to the last bit: RapidJSON's own are up to three units off there.
bool ParseExactly(std::string_view text, rapidjson::Document& document);

}  // namespace mjforge::manifest
