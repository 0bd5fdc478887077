// Record parameters: several values that one draw selects together.

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/spec/context.h"

namespace mjforge::spec {

/// A parameter before its value is read. A record parameter is declared as several parameters, one
/// for each of its columns.
struct ParameterNode {
  std::string name;  // "leg", "style.leg"
  diag::SourceMark mark;
  YamlNode value;
  std::string source;       // value for display (Parameter::source); empty: as written
  std::string record = {};  // name of the record ("style"), only for its key column, the first one
  std::string unit = {};
  FieldKind kind = FieldKind::kAnything;        // kind of the cells, if from a CSV file
  std::shared_ptr<const RecordRows> rows = {};  // rows of the record; null: no record

  bool is_key() const { return !record.empty(); }
};

/// Returns the node of `value:` if a parameter has the long form with this key; otherwise `node`.
const YamlNode& WithoutLongForm(const YamlNode& node);

/// Returns a ParameterNode for each column of a record, the key first: `style: {choice: [{name:
/// modern, leg: 3cm}, ...]}`, `cup: {rows: cups.csv}`. Returns nullopt if the parameter is not a
/// record. Returns an empty list, after adding a finding, if the record is wrong.
std::optional<std::vector<ParameterNode>> ReadRecord(const YamlNode::Pair& parameter,
                                                     Context& context);

}  // namespace mjforge::spec
