// Tables of parameter values in CSV files.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {

struct TableColumn {
  std::string name;
  diag::SourceMark mark;  // position of the name in the header line
  bool is_text = false;
  std::string unit;             // SI unit of the column's dimension: m for mm
  std::vector<YamlNode> cells;  // cells below the header: numbers (12mm if not SI), or texts
};

/// Parses text number `file` of `sources` as CSV with a header line (RFC 4180). A column name may
/// be followed by a unit, `height [mm]`, or by `[text]`. A column with neither is numeric if all
/// its cells are numbers. Returns nullopt, and adds findings, if the text is not such a table.
std::optional<std::vector<TableColumn>> ReadTable(std::uint32_t file, const diag::Sources& sources,
                                                  diag::Findings& findings);

}  // namespace mjforge::spec
