// Record parameters: several values that one draw selects together.

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/spec/context.h"

namespace mjforge::spec {

/// The YAML source of a parameter. A record parameter has one ParameterNode for each of its
/// columns.
struct ParameterNode {
  std::string name;  // "leg", "style.leg"
  diag::SourceMark mark;
  YamlNode node;
  std::string source;       // Parameter::source; empty: the text of the spec
  std::string record = {};  // name of the record ("style"), only for its key column, the first one
  std::string unit = {};
  FieldKind kind = FieldKind::kAnything;        // kind of the options
  std::shared_ptr<const RecordRows> rows = {};  // only for the columns of a record

  bool is_key() const { return !record.empty(); }
};

/// Returns a ParameterNode for each column of a record, the key first: `style: {choice: [{name:
/// modern, leg: 3cm}, ...]}`, `cup: {rows: cups.csv}`. Returns nullopt if the parameter is not a
/// record, and an empty list, after adding a finding, if the record is wrong.
std::optional<std::vector<ParameterNode>> ReadRecord(const YamlNode::Pair& parameter,
                                                     Context& context);

}  // namespace mjforge::spec
