#pragma once

// A YAML text as a tree in which every node knows its own place. Made from yaml-cpp's events, not
// its nodes: in those an alias has its anchor's mark, an empty value has the next token's mark,
// duplicate keys are accepted, and an anchor inside itself is a cycle.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::spec {

struct YamlNode {
  enum class Kind { kNull, kScalar, kList, kMap };
  struct Pair;

  Kind kind = Kind::kNull;
  diag::SourceMark mark;        // of an empty value: its key's
  std::string text;             // kScalar
  bool quoted = false;          // kScalar: not plain, so never a number
  bool flow = false;            // kScalar: an item of a [list, in brackets]
  std::vector<YamlNode> items;  // kList
  std::vector<Pair> pairs;      // kMap, in file order, keys unique

  static YamlNode Scalar(std::string text, diag::SourceMark mark);
  static YamlNode List(std::vector<YamlNode> items, diag::SourceMark mark);

  /// The pair of a key of a mapping, or its value; null if there is none.
  const Pair* FindPair(std::string_view key) const;
  const YamlNode* Find(std::string_view key) const;
};

struct YamlNode::Pair {
  std::string key;
  diag::SourceMark mark;  // of the key
  YamlNode value;
};

/// Texts longer than this are refused; even a spec of a hundred thousand parts is far shorter.
inline constexpr std::size_t kMaxYamlBytes = 8u << 20;

/// Parses the text of a source. Nothing, and one finding or more, if it is not
/// one YAML document, is empty, binary, too large, nested too deeply (500), or
/// repeats keys or aliases without end.
std::optional<YamlNode> ParseYaml(std::uint32_t file, const diag::Sources& sources,
                                  diag::Findings& findings);

/// What a node is, for messages: "a list", "text", "nothing".
std::string_view KindName(const YamlNode& node);

/// The node as one line of YAML flow text.
std::string FlowText(const YamlNode& node);

}  // namespace mjforge::spec
