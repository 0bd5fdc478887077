// A JSON parser whose numbers are correctly rounded.

#pragma once

#include <cstddef>
#include <string>

#include <rapidjson/document.h>

namespace mjforge::manifest {

/// Size in bytes of the stack buffer for the values of a record; longer records also use the heap.
inline constexpr std::size_t kParserBytes = std::size_t{16} << 10;

/// Parses a JSON text. Returns false if the text is not JSON, is nested more than
/// diag::kMaxJsonDepth deep or contains a number that is too large. Rounds numbers correctly,
/// unlike RapidJSON's own parser, which errs by up to three units in the last place. The document's
/// texts are parts of `text`, which is changed and must outlive the document.
bool ParseExactly(std::string& text, rapidjson::Document& document);

}  // namespace mjforge::manifest
