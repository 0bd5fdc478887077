// Conversion of YAML nodes to YAML flow text, and of texts to quoted scalars.

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/spec/spec.h"
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
  return node.quoted || special ? SingleQuoted(node.text) : node.text;
}

}  // namespace

std::string SingleQuoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out.append(c == '\'' ? 2 : 1, c);
  return out + '\'';
}

std::string FlowText(const YamlNode& node) {
  const auto member = [](const YamlNode::Pair& pair) {
    return pair.key + ": " + FlowText(pair.value);
  };
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      return "null";
    case YamlNode::Kind::kScalar:
      return FlowScalar(node);
    case YamlNode::Kind::kList:
      return fmt::format("[{}]", diag::Joined(node.items, ", ", FlowText));
    case YamlNode::Kind::kMap:
      return fmt::format("{{{}}}", diag::Joined(node.pairs, ", ", member));
  }
  return {};
}

}  // namespace mjforge::spec
