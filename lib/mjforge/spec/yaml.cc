// Parsing of YAML text into a tree with positions in the text, from the events of yaml-cpp.

#include "mjforge/spec/yaml.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/expr/expr.h"
#include "mjforge/spec/yaml_errors.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using diag::SourceMark;

// Maximum count of nodes that all aliases together may copy. The limit allows shared vectors, but
// stops a "billion laughs" attack.
constexpr std::size_t kMaxAliasNodes = 100'000;

std::size_t CountNodes(const YamlNode& node, std::size_t limit) {
  std::size_t count = 1;
  for (const YamlNode& item : node.items) {
    if (count > limit) return count;
    count += CountNodes(item, limit);
  }
  for (const auto& pair : node.pairs) {
    if (count > limit) return count;
    count += CountNodes(pair.value, limit);
  }
  return count;
}

// Exception that stops yaml-cpp's parser after a finding was added.
struct Stop {};

class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(std::uint32_t file, diag::Findings& findings) : file_(file), findings_(findings) {}

  YamlNode TakeRoot() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const bool has_key = !open_.empty() && open_.back().pair;
    const SourceMark at = has_key ? open_.back().pair->mark : At(mark);
    Finish(YamlNode::Empty(YamlNode::Kind::kNull, at), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) {
      Fail(Code::kYamlAlias, mark, "alias is inside its own anchor");
    }
    alias_nodes_ += CountNodes(found->second, kMaxAliasNodes);
    if (alias_nodes_ > kMaxAliasNodes) {
      Fail(Code::kYamlAlias, mark, fmt::format("aliases repeat more than {} nodes", kMaxAliasNodes),
           "write the values out, or use `for:` and `defaults:`");
    }
    YamlNode copy = found->second;
    copy.mark = At(mark);
    Finish(std::move(copy), 0);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    CheckTag(mark, tag, value);
    // Reads `!hollow` as the plain word `hollow`, because CheckTag() already reported the tag.
    const bool is_word = value.empty() && tag.size() > 1 && tag.front() == '!';
    YamlNode node = YamlNode::Scalar(is_word ? tag.substr(1) : value, At(mark));
    node.quoted = tag == "!";
    node.flow = !open_.empty() && open_.back().flow;
    if (!node.quoted && (value == "~" || value == "null")) node.kind = YamlNode::Kind::kNull;
    Finish(std::move(node), anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    CheckTag(mark, tag, {});
    Open(YamlNode::Kind::kList, mark, anchor, style == YAML::EmitterStyle::Flow);
  }
  void OnSequenceEnd() override { Close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    CheckTag(mark, tag, {});
    Open(YamlNode::Kind::kMap, mark, anchor, false);
  }
  void OnMapEnd() override { Close(); }

  SourceMark At(const YAML::Mark& mark) const {
    return {file_, static_cast<std::uint32_t>(mark.line + 1),
            static_cast<std::uint32_t>(mark.column + 1)};
  }

 private:
  struct OpenNode {
    YamlNode node;
    YAML::anchor_t anchor = 0;
    bool flow = false;                        // true for a list in brackets
    std::optional<YamlNode::Pair> pair = {};  // a key that was read, before its value is read
    bool keep = true;  // false: the key is repeated, and its value is dropped
    std::map<std::string, SourceMark, std::less<>> keys = {};
  };

  [[noreturn]] void Fail(Code code, const YAML::Mark& mark, std::string message,
                         std::string hint = {}) {
    findings_.Add(code, At(mark), std::move(message), std::move(hint));
    throw Stop{};
  }

  void CheckTag(const YAML::Mark& mark, const std::string& tag, const std::string& value) {
    if (tag.empty() || tag == "?" || tag == "!") return;
    const bool negation = tag.front() == '!' && !tag.starts_with("tag:");
    findings_.Add(Code::kYamlTag, At(mark), fmt::format("tag '{}' has no meaning here", tag),
                  negation ? fmt::format("to negate, write `not {}{}{}` or quote the expression",
                                         tag.substr(1), value.empty() ? "" : " ", value)
                           : std::string());
  }

  void Open(YamlNode::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor, bool flow) {
    if (ExpectsKey()) Fail(Code::kYamlSyntax, mark, "a key must be a plain word");
    open_.push_back({.node = YamlNode::Empty(kind, At(mark)), .anchor = anchor, .flow = flow});
  }

  void Close() {
    OpenNode done = std::move(open_.back());
    open_.pop_back();
    Finish(std::move(done.node), done.anchor);
  }

  bool ExpectsKey() const {
    return !open_.empty() && open_.back().node.kind == YamlNode::Kind::kMap && !open_.back().pair;
  }

  void Finish(YamlNode node, YAML::anchor_t anchor) {
    if (anchor != 0) anchors_[anchor] = node;
    if (open_.empty()) {
      root_ = std::move(node);
    } else if (open_.back().node.kind == YamlNode::Kind::kList) {
      open_.back().node.items.push_back(std::move(node));
    } else if (!open_.back().pair) {
      TakeKey(std::move(node));
    } else {
      OpenNode& map = open_.back();
      map.pair->value = std::move(node);
      if (map.keep) map.node.pairs.push_back(*std::move(map.pair));
      map.pair.reset();
    }
  }

  void TakeKey(YamlNode key) {
    OpenNode& map = open_.back();
    const auto [first, is_new] = map.keys.emplace(key.text, key.mark);
    if (!is_new) {
      findings_
          .Add(Code::kYamlDuplicateKey, key.mark, fmt::format("key '{}' appears twice", key.text))
          .notes.push_back({first->second, "first here"});
    }
    map.keep = is_new;
    map.pair = YamlNode::Pair{std::move(key.text), key.mark, {}};
  }

  std::uint32_t file_;
  diag::Findings& findings_;
  YamlNode root_;
  std::vector<OpenNode> open_;
  std::map<YAML::anchor_t, YamlNode> anchors_;
  std::size_t alias_nodes_ = 0;
};

// Returns the position of the byte at `offset`.
SourceMark MarkAt(std::uint32_t file, std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_start = before.rfind('\n') + 1;  // 0 if there is no line end
  return {file, static_cast<std::uint32_t>(std::ranges::count(before, '\n') + 1),
          static_cast<std::uint32_t>(offset - line_start + 1)};
}

// Returns the position of the first byte that is NUL or not UTF-8; nullopt if there is none.
std::optional<SourceMark> FirstBadByte(std::uint32_t file, std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const diag::Utf8Char character = diag::DecodeUtf8(text.substr(i));
    if (!character.valid || text[i] == '\0') return MarkAt(file, text, i);
    i += character.length;
  }
  return std::nullopt;
}

// Returns the position of the first bracket that is nested deeper than kMaxDepth; nullopt if there
// is none. The limit of yaml-cpp does not count brackets that are never closed.
std::optional<SourceMark> FirstTooDeep(std::uint32_t file, std::string_view text) {
  constexpr int kMaxDepth = 200;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '[' || text[i] == '{') ++depth;
    if (text[i] == ']' || text[i] == '}') --depth;
    if (depth > kMaxDepth) return MarkAt(file, text, i);
  }
  return std::nullopt;
}

bool IsParseable(std::uint32_t file, const diag::Sources& sources, diag::Findings& findings) {
  const std::string& text = sources.Text(file);
  if (const std::string_view kind = bytes::KindOf(text); !kind.empty()) {
    // The finding has no position, because a position would quote a line of the binary file.
    findings.Add(Code::kYamlNotText, {},
                 fmt::format("'{}' is {}, not YAML text", sources.Name(file), kind),
                 kind.find("archive") == kind.npos
                     ? ""
                     : "'mjforge inspect NAME.manifest.jsonl' shows what is in an archive of ours");
    return false;
  }
  if (text.size() > kMaxYamlBytes) {
    findings.Add(Code::kYamlTooLarge, SourceMark{file, 1, 1},
                 fmt::format("file has more than {} bytes", kMaxYamlBytes),
                 "repeat parts with `for:`");
    return false;
  }
  if (const auto bad = FirstBadByte(file, text)) {
    findings.Add(Code::kYamlNotText, *bad, "not UTF-8 text",
                 "a spec is a YAML file in UTF-8; is this another kind of file?");
    return false;
  }
  if (const auto deep = FirstTooDeep(file, text)) {
    findings.Add(Code::kYamlTooDeep, *deep, "nested too deeply");
    return false;
  }
  return true;
}

// Gives the text to the builder. If the text has no document, the builder's root remains kNull.
bool RunParser(std::uint32_t file, const diag::Sources& sources, TreeBuilder& builder,
               diag::Findings& findings) {
  std::istringstream stream(sources.Text(file));
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) return true;  // the file is empty
    TreeBuilder second(file, findings);
    if (parser.HandleNextDocument(second)) {
      findings.Add(Code::kYamlSyntax, SourceMark{file, 1, 1}, "file holds more than one document",
                   "write one spec per file");
      return false;
    }
    return true;
  } catch (const Stop&) {
  } catch (const YAML::DeepRecursion& error) {
    findings.Add(Code::kYamlTooDeep, builder.At(error.mark), "nested too deeply");
  } catch (const YAML::Exception& error) {
    const SourceMark mark = builder.At(error.mark);
    SyntaxError found = ExplainSyntax(error.msg, sources.Line(mark), mark.column);
    findings.Add(Code::kYamlSyntax, mark, std::move(found.message), std::move(found.hint));
  }
  return false;
}

}  // namespace

YamlNode YamlNode::Empty(Kind kind, SourceMark mark) {
  YamlNode node;
  node.kind = kind;
  node.mark = mark;
  return node;
}

YamlNode YamlNode::Scalar(std::string text, SourceMark mark) {
  YamlNode node = Empty(Kind::kScalar, mark);
  node.text = std::move(text);
  return node;
}

YamlNode YamlNode::List(std::vector<YamlNode> items, SourceMark mark) {
  YamlNode node = Empty(Kind::kList, mark);
  node.items = std::move(items);
  return node;
}

const YamlNode::Pair* YamlNode::FindPair(std::string_view key) const {
  return diag::Find(pairs, key, &Pair::key);
}

const YamlNode* YamlNode::Find(std::string_view key) const {
  const Pair* pair = FindPair(key);
  return pair != nullptr ? &pair->value : nullptr;
}

std::optional<YamlNode> ParseYaml(std::uint32_t file, const diag::Sources& sources,
                                  diag::Findings& findings) {
  if (!IsParseable(file, sources, findings)) return std::nullopt;
  TreeBuilder builder(file, findings);
  if (!RunParser(file, sources, builder, findings)) return std::nullopt;
  YamlNode root = builder.TakeRoot();
  if (root.kind == YamlNode::Kind::kNull) {
    findings.Add(Code::kYamlEmpty, SourceMark{file, 1, 1}, "file is empty",
                 "start with `mjforge: 1` and a `name:`");
    return std::nullopt;
  }
  return root;
}

bool IsBooleanWord(const YamlNode& node) {
  return !node.quoted && (node.text == "true" || node.text == "false");
}

bool IsQuotedNumber(const YamlNode& node) { return node.quoted && expr::ParseNumber(node.text); }

std::string_view KindName(const YamlNode& node) {
  // In the order of YamlNode::Kind.
  constexpr std::string_view kNames[] = {"nothing", "a single value", "a list", "a mapping"};
  return kNames[static_cast<std::size_t>(node.kind)];
}

}  // namespace mjforge::spec
