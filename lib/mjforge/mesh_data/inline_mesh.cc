// Checks of the numbers of meshes and skins whose data is in the MJCF file.
#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/mesh_data/formats.h"

namespace mjforge::mesh_data {
namespace {

// Returns the first word that is not a finite number; nullopt if there is none. Sets `count` to the
// number of words.
std::optional<std::string_view> FindBadNumber(std::string_view text, std::size_t& count) {
  const std::vector<std::string_view> words = expr::WordsOf(text);
  count = words.size();
  for (const std::string_view word : words) {
    const std::optional<double> number = expr::ParseNumber(word);
    if (!number || !IsFiniteFloat(*number)) return word;
  }
  return std::nullopt;
}

std::string FindFaceFault(std::string_view face, std::size_t vertices) {
  std::size_t at = 0;
  for (const std::string_view word : expr::WordsOf(face)) {
    const std::optional<double> index = ParseInteger(word);
    if (!index) return fmt::format("'{}' in its 'face' is not an index", word);
    if (*index < 0 || *index >= static_cast<double>(vertices))
      return fmt::format("face {} uses vertex {} of {}, counted from 0", at / 3, word, vertices);
    ++at;
  }
  return {};
}

}  // namespace

std::string FindFault(const InlineMesh& mesh) {
  const auto fault_of = [](std::string_view name, std::string_view text, std::size_t& count) {
    const auto word = FindBadNumber(text, count);
    return word ? fmt::format("'{}' in its '{}' is not a finite number", *word, name)
                : std::string();
  };
  std::size_t coordinates = 0;
  std::size_t ignored = 0;
  std::string fault = fault_of("vertex", mesh.vertex, coordinates);
  if (fault.empty()) fault = fault_of("normal", mesh.normal, ignored);
  if (fault.empty()) fault = fault_of("texcoord", mesh.texcoord, ignored);
  if (!fault.empty()) return fault;
  return FindFaceFault(mesh.face, mesh.vertex.empty() ? mesh.file_vertices : coordinates / 3);
}

}  // namespace mjforge::mesh_data
