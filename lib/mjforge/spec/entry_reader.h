// Reader of list entries: `if`, `for`, `let`, names, fields, frames and nested specs.

#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "mjforge/spec/context.h"

namespace mjforge::spec {

class EntryReader {
 public:
  explicit EntryReader(Context& context) : context_(context) {}

  /// Reads a list of parts, sites, regions, cameras, lights or joints.
  std::vector<Entry> ReadList(const ElementInfo& element, const YamlNode& list);

  enum class Naming { kOptional, kRequired };
  /// Reads the loops, the name, the local values and the condition of an entry, in this order. Loop
  /// variables and local values stay declared until End(). `named` is the mapping that contains the
  /// name under the key `key`.
  Entry Begin(const ElementInfo& element, const YamlNode& map, const YamlNode& named,
              Naming naming = Naming::kOptional, std::string_view key = "name");
  void End(const Entry& entry);

  /// Reads the nested spec of an entry: `spec:` with its `params:` and `materials:`.
  void ReadNested(const YamlNode& map, const YamlNode& spec, Entry& entry);
  /// Reports the keys of `map` that are keys of `element` but not in `allowed`: they have no
  /// meaning for `what` ("a frame").
  void RejectKeys(const YamlNode& map, std::initializer_list<std::string_view> allowed,
                  const ElementInfo& element, std::string_view what);

 private:
  Entry ReadEntry(const ElementInfo& element, const YamlNode& text);
  /// Reads the entry's name, or reports that a required name is missing.
  void ReadName(const YamlNode& map, std::string_view key, bool required, Entry& entry);
  void ReadLocals(const YamlNode& locals, bool has_name, Entry& entry);
  void ReadPlain(const ElementInfo& element, const YamlNode& map, Entry& entry);
  void ReadFrame(const YamlNode& map, const YamlNode& frame, Entry& entry);
  void ReadWeld(const YamlNode& map, const YamlNode& spec, Entry& entry);
  void ReadOverride(const YamlNode::Pair& pair, Entry& entry);
  void ReadSubstitute(const YamlNode::Pair& pair, Entry& entry);
  /// Reports the literal name of a material if the spec has no such material.
  void CheckMaterial(const Value& value);

  Context& context_;
};

}  // namespace mjforge::spec
