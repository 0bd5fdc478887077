// Reader of `functions:`, named expressions with arguments.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "mjforge/spec/context.h"
#include "mjforge/spec/topological_order.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using expr::SpecFunction;

constexpr std::size_t kMaxArguments = 16;
constexpr int kMaxChain = 64;

// Splits "bulge(z)" into the function's name and its arguments. Returns nullopt for text of another
// form.
std::optional<SpecFunction> ReadHead(std::string_view text) {
  const std::size_t open = text.find('(');
  if (open == text.npos || !text.ends_with(')')) return std::nullopt;
  SpecFunction function{
      .name = std::string(Trim(text.substr(0, open))), .arguments = {}, .body = {}};
  text = text.substr(open + 1, text.size() - open - 2);
  for (const std::string_view argument : Split(text, ","))
    function.arguments.emplace_back(Trim(argument));
  const bool has_names =
      expr::IsName(function.name) && std::ranges::all_of(function.arguments, expr::IsName);
  return has_names ? std::optional(std::move(function)) : std::nullopt;
}

bool CheckNames(const SpecFunction& function, diag::SourceMark mark, Context& context) {
  const auto fail = [&](Code code, std::string message) {
    context.findings.Add(code, mark, std::move(message));
    return false;
  };
  if (!CheckNotReserved("a function", function.name, mark, context.findings)) return false;
  if (context.spec.names.FindFunction(function.name) != nullptr)
    return fail(Code::kSpecDuplicateName,
                fmt::format("two functions are named '{}'", function.name));
  if (function.arguments.size() > kMaxArguments) {
    return fail(Code::kSpecBadValue,
                fmt::format("a function has at most {} arguments", kMaxArguments));
  }
  std::set<std::string_view> seen;
  for (const std::string& argument : function.arguments) {
    if (!CheckNotReserved("an argument", argument, mark, context.findings)) return false;
    if (!seen.insert(argument).second) {
      return fail(Code::kSpecDuplicateName,
                  fmt::format("two arguments of '{}' are named '{}'", function.name, argument));
    }
  }
  return true;
}

// Returns, for each function, the indices of the functions that it calls directly.
Dependencies UsesOf(const std::vector<const SpecFunction*>& all) {
  Dependencies uses;
  for (const SpecFunction* function : all) {
    std::vector<std::size_t>& used = uses.emplace_back();
    for (const std::string& other : expr::NamesUsedIn(function->body)) {
      const auto found = std::ranges::find(all, other, &SpecFunction::name);
      if (found != all.end()) used.push_back(static_cast<std::size_t>(found - all.begin()));
    }
  }
  return uses;
}

// Returns the position of a function's name in the spec's text.
diag::SourceMark MarkOf(const SpecFunction& function, const Context& context) {
  const auto& all = context.spec.functions;
  return std::ranges::find(all, function.name, [](const auto& one) { return one.first; })->second;
}

// Reports functions that call each other in a circle, or in a chain that is too long. Replaces the
// bodies of the reported functions by a constant, so that the expansion of calls ends.
void LimitCallDepth(Context& context) {
  expr::SymbolTable& names = context.spec.names;
  const auto all = diag::Mapped<const SpecFunction*>(
      names.functions(), [](const auto& entry) { return &entry.second; });
  const Dependencies uses = UsesOf(all);
  std::set<std::size_t> broken;
  const auto order = TopologicalOrder(uses, [&](const std::vector<std::size_t>& path) {
    const auto name = [&](std::size_t i) { return std::string_view(all[i]->name); };
    broken.insert(path.begin(), path.end());
    context.findings.Add(
        Code::kSpecCycle, MarkOf(*all[path[0]], context),
        fmt::format("functions call each other: {}", diag::Joined(path, " -> ", name)));
  });
  std::vector<int> chain(all.size(), 0);
  for (const std::size_t at : order) {
    for (const std::size_t used : uses[at]) chain[at] = std::max(chain[at], chain[used] + 1);
    if (chain[at] < kMaxChain || broken.contains(at)) continue;
    context.findings.Add(Code::kSpecBadValue, MarkOf(*all[at], context),
                         fmt::format("'{}' calls functions in a chain of {}; the limit is {}",
                                     all[at]->name, chain[at], kMaxChain - 1));
    broken.insert(at);
    chain[at] = 0;
  }
  for (const std::size_t at : broken) {
    SpecFunction harmless = *all[at];
    harmless.body = "1";
    names.Define(harmless);
  }
}

}  // namespace

bool CheckNotReserved(std::string_view what, std::string_view name, diag::SourceMark mark,
                      diag::Findings& findings) {
  if (name != "index" && !expr::IsReserved(name)) return true;
  findings.Add(
      Code::kSpecBadName, mark,
      fmt::format("'{}' is a word of the expression language; {} needs another name", name, what));
  return false;
}

void ReadFunctions(const YamlNode& functions, Context& context) {
  if (!IsMap(functions, "functions, as in `area(a, b): a * b`", context)) return;
  for (const YamlNode::Pair& pair : functions.pairs) {
    std::optional<SpecFunction> function = ReadHead(pair.key);
    if (!function) {
      context.findings.Add(
          Code::kSpecBadName, pair.mark,
          fmt::format("'{}' is not a function's name with its arguments", pair.key),
          "write `name(a, b): expression`; what has no arguments is a parameter");
      continue;
    }
    if (!CheckNames(*function, pair.mark, context)) continue;
    if (pair.value.kind != YamlNode::Kind::kScalar) {
      context.findings.Add(Code::kSpecWrongType, pair.value.mark,
                           fmt::format("expected an expression, got {}", KindName(pair.value)),
                           "a function draws nothing: draw a parameter, and use it here");
      continue;
    }
    function->body = pair.value.text;
    function->mark = pair.value.mark;
    context.spec.functions.emplace_back(function->name, pair.mark);
    context.spec.names.Define(*std::move(function));
  }
  LimitCallDepth(context);
}

void CheckFunctions(Context& context) {
  expr::SymbolTable& names = context.spec.names;
  for (const auto& [name, mark] : context.spec.functions) {
    const SpecFunction& function = *names.FindFunction(name);
    const auto hidden = std::ranges::find_if(
        function.arguments, [&](const std::string& argument) { return names.Find(argument); });
    if (hidden != function.arguments.end()) {
      context.findings.Add(Code::kSpecDuplicateName, mark,
                           fmt::format("argument '{}' hides a parameter", *hidden));
      continue;
    }
    for (const std::string& argument : function.arguments)
      names.Declare(argument, expr::Type::kNumber);
    context.values.CheckBody(function);
    for (const std::string& argument : function.arguments) names.Forget(argument);
  }
}

std::vector<std::string> WithNamesInFunctions(std::vector<std::string> names,
                                              const expr::SymbolTable& known) {
  std::set<std::string, std::less<>> seen(names.begin(), names.end());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const SpecFunction* function = known.FindFunction(names[i]);
    if (function == nullptr) continue;
    for (std::string& name : expr::NamesUsedIn(function->body)) {
      const bool is_argument =
          std::ranges::find(function->arguments, name) != function->arguments.end();
      if (!is_argument && seen.insert(name).second) names.push_back(std::move(name));
    }
  }
  return names;
}

}  // namespace mjforge::spec
