#pragma once

// Private to the room: tables of values in CSV files.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {

struct TableColumn {
  std::string name;
  diag::SourceMark mark;  // in the header
  bool is_text = false;
  std::string unit;             // that of mjforge for what the header's measures: m for mm
  std::vector<YamlNode> cells;  // numbers with the header's unit, or texts
};

/// Reads the text of a source as RFC 4180 has it: one header, cells in quotes where they hold
/// commas or line ends. A header may have a unit, `height [mm]`, or say `[text]`; a column whose
/// cells are all numbers is one of numbers. Nothing, and findings, if it has another form.
std::optional<std::vector<TableColumn>> ReadTable(std::uint32_t file, const diag::Sources& sources,
                                                  diag::Findings& findings);

}  // namespace mjforge::spec
