// A JSON parser whose numbers are correctly rounded.

#pragma once

#include <string_view>

#include <rapidjson/document.h>

namespace mjforge::manifest {

/// Parses a JSON text. Returns false if the text is not JSON or contains a number that is too
/// large. Numbers are correctly rounded; RapidJSON's own differ by up to three units in the last
/// place.
bool ParseExactly(std::string_view text, rapidjson::Document& document);

}  // namespace mjforge::manifest
