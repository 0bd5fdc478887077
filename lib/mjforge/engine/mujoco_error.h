// Parses error messages of MuJoCo, and describes the XML element on a line.
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>

namespace mjforge::engine {

/// Parts of an error message of MuJoCo.
struct Refusal {
  std::string reason;  // on one line, without MuJoCo's "Error: " and a final full stop
  int line = 0;        // line of the XML; 0 if unknown
};
/// Splits an error message of MuJoCo into reason and line. If the message has no line but names a
/// sensor, as in MuJoCo 2.2, returns the line of the sensor with this name in the MJCF text `xml`.
Refusal ParseRefusal(std::string_view message, std::string_view xml = {});

/// Returns a text with each run of white space replaced by a blank, and without full stops at its
/// end.
std::string OneLine(std::string_view text);

/// Calls `run`, and returns the message of the exception that it throws; nullopt if it throws none.
/// Lets std::bad_alloc pass, because a lack of memory is no error of the model.
template <typename Run>
std::optional<std::string> FailureOf(const Run& run) {
  try {
    run();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  }
  return std::nullopt;
}

/// Describes the element that starts on a line of an XML text: "geom 'head'", or "the geom on line
/// 7" if it has no name, or "the model" if no element starts there.
std::string ElementOnLine(std::string_view xml, int line);

}  // namespace mjforge::engine
