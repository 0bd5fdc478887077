// Conversion of YAML nodes to YAML flow text.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {
namespace {

// Returns true if the text needs quotes in YAML brackets because it would have another meaning
// without them.
bool NeedsQuotes(std::string_view text) {
  return text.empty() || text.find_first_of(",[]{}") != std::string_view::npos ||
         std::string_view("&*!|>'\"%@`#-?: ").find(text.front()) != std::string_view::npos ||
         text.find(": ") != std::string_view::npos || text.find(" #") != std::string_view::npos ||
         text.ends_with(':') || text.ends_with(' ');
}

std::string FlowScalar(const YamlNode& node) {
  const bool special = NeedsQuotes(node.text) && !expr::ParseNumber(node.text);
  if (!node.quoted && !special) return node.text;
  std::string out = "'";
  for (const char c : node.text) out.append(c == '\'' ? 2 : 1, c);
  out += '\'';
  return out;
}

}  // namespace

std::string FlowText(const YamlNode& node) {
  std::string out;
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      return "null";
    case YamlNode::Kind::kScalar:
      return FlowScalar(node);
    case YamlNode::Kind::kList:
      for (const YamlNode& item : node.items) {
        out += out.empty() ? "" : ", ";
        out += FlowText(item);
      }
      return fmt::format("[{}]", out);
    case YamlNode::Kind::kMap:
      for (const auto& pair : node.pairs) {
        out += out.empty() ? "" : ", ";
        out += pair.key + ": " + FlowText(pair.value);
      }
      return fmt::format("{{{}}}", out);
  }
  return out;
}

}  // namespace mjforge::spec
