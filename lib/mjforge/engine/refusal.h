#pragma once

// MuJoCo's error texts, taken apart.

#include <string>
#include <string_view>

namespace mjforge::engine {

struct Refusal {
  std::string reason;  // one line, without MuJoCo's "Error: " and final stop
  int line = 0;        // of the XML; 0: unknown
};
Refusal ParseRefusal(std::string_view message);

/// A text on one line, for notes.
std::string OneLine(std::string_view text);

/// "geom 'head'" for the element that starts on a line of an XML text, "the
/// geom on line 7" if it has no name, "the model" if there is none.
std::string ElementOnLine(std::string_view xml, int line);

}  // namespace mjforge::engine
