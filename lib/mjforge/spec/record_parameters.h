#pragma once

// Private to the room: parameters that one draw decides together.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/spec/context.h"

namespace mjforge::spec {

/// What is read for a parameter; a record is several, one for each of its columns.
struct ParameterNode {
  std::string name;  // "leg", "style.leg"
  diag::SourceMark mark;
  YamlNode node;
  std::string source;       // Parameter::source, if not as the user wrote it
  std::string record = {};  // "style", of its first column, the key
  std::string unit = {};
  FieldKind kind = FieldKind::kAnything;        // of the options
  std::shared_ptr<const RecordRows> rows = {};  // of a record's columns, the key included

  bool is_key() const { return !record.empty(); }
};

/// The columns of a record, the key first: `style: {choice: [{name: modern, leg: 3cm}, ...]}`,
/// `cup: {rows: cups.csv}`. Nothing if the parameter is not one; none of them after a finding.
std::optional<std::vector<ParameterNode>> ReadRecord(const YamlNode::Pair& parameter,
                                                     Context& context);

}  // namespace mjforge::spec
