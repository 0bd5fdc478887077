// A tree of YAML nodes in which each node has its own position in the text.

#pragma once

// The tree is made from yaml-cpp's events, because yaml-cpp's own nodes are not suitable: an alias
// has the mark of its anchor, an empty value has the mark of the next token, duplicate keys are
// accepted, and an alias inside its own anchor makes a cycle.

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
  diag::SourceMark mark;        // position of the node; an empty value has its key's mark
  std::string text;             // text of a kScalar
  bool quoted = false;          // kScalar: in quotes, so never a number
  bool flow = false;            // kScalar: an item of a list in brackets
  std::vector<YamlNode> items;  // items of a kList
  std::vector<Pair> pairs;      // pairs of a kMap in file order; keys are unique

  /// Returns a node without content.
  static YamlNode Empty(Kind kind, diag::SourceMark mark);
  static YamlNode Scalar(std::string text, diag::SourceMark mark);
  static YamlNode List(std::vector<YamlNode> items, diag::SourceMark mark);

  /// Return the pair, or the value, of a key of a mapping; null if the key is missing.
  const Pair* FindPair(std::string_view key) const;
  const YamlNode* Find(std::string_view key) const;
};

struct YamlNode::Pair {
  std::string key;
  diag::SourceMark mark;  // position of the key
  YamlNode value;
};

/// Maximum size of a YAML text in bytes. Larger specs must be shortened by `for:`.
inline constexpr std::size_t kMaxYamlBytes = 8u << 20;

/// Parses text number `file` of `sources`. Returns nullopt, and adds findings, if the text is
/// empty, binary, too long, not exactly one YAML document, nested too deeply, or expands too many
/// aliases. Also reports repeated keys and tags, but continues after them.
std::optional<YamlNode> ParseYaml(std::uint32_t file, const diag::Sources& sources,
                                  diag::Findings& findings);

/// Returns the kind of a node for messages: "a list", "a mapping", "nothing".
std::string_view KindName(const YamlNode& node);

/// Returns true if the node is the unquoted word `true` or `false`.
bool IsBooleanWord(const YamlNode& node);

/// Returns true if the node is a number in quotes, which is text.
bool IsQuotedNumber(const YamlNode& node);

/// Returns the node as one line of YAML in flow style.
std::string FlowText(const YamlNode& node);

}  // namespace mjforge::spec
