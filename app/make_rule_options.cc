// Options -MD, -MF, -MT and -MP, and the Make rule that they write.
#include "make_rule_options.h"

#include <CLI/CLI.hpp>
#include <array>

#include "completion.h"
#include "console.h"

namespace mjforge::app {
namespace {

using Kind = output::Destination::Kind;

constexpr std::array<std::string_view, 4> kNames = {"-MD", "-MF", "-MT", "-MP"};

// Returns the target of the rule: the output file or, for a folder or a series of files, the
// manifest, which is written last.
std::filesystem::path TargetOf(const output::Destination& destination) {
  const bool is_file = destination.kind == Kind::kFile || destination.kind == Kind::kArchive ||
                       (destination.kind == Kind::kFamily && !destination.IsSplit());
  return is_file ? destination.path : destination.Manifest({});
}

std::filesystem::path DependencyFile(const output::Destination& destination) {
  std::filesystem::path file = TargetOf(destination);
  if (file.extension() == ".zst") file.replace_extension();
  return file.replace_extension(".d");
}

std::filesystem::path RuleFile(const MakeOptions& options, const output::Destination& destination) {
  return options.file.empty() ? DependencyFile(destination) : std::filesystem::path(options.file);
}

// Returns the normalized path of a file, because Make compares the texts of paths.
std::string NameForMake(const std::filesystem::path& file, bool absolute) {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  if (error) return file.string();
  const std::filesystem::path whole = (here / file).lexically_normal();
  const std::filesystem::path relative = whole.lexically_relative(here);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return (absolute || !below ? whole : relative).string();
}

constexpr std::size_t kRuleStart = std::size_t{64} << 10;  // limit of the targets' line, bytes

// Returns true if a file with this start is empty or has the form that MakeRule() writes: rules
// with a file on each line. Ignores the end of the start, which may be cut within a line.
bool IsRule(std::string_view start) {
  if (!start.empty() && start.find('\n') == start.npos) return false;
  bool continues = false;  // the line before ends with a backslash
  while (start.find('\n') != start.npos) {
    const std::string_view line = diag::CutAt('\n', start);
    const bool is_rule = line.empty() || line.ends_with(':') || line.ends_with(": \\");
    if (continues ? !line.starts_with("  ") : !is_rule) return false;
    continues = line.ends_with(" \\");
  }
  return true;
}

}  // namespace

void AddMakeOptions(CLI::App& command, MakeOptions& options) {
  command.add_flag("--MD", options.dependencies, "Write a Make rule: what OUT is made from");
  command.add_option("--MF", options.file, "The rule's file [OUT with .d]")
      ->option_text("FILE")
      ->check(Offers("."));
  command.add_option("--MT", options.targets, "The rule's target [OUT]")
      ->option_text("TARGET")
      ->allow_extra_args(false)
      ->check(Offers("."));
  command.add_flag("--MP", options.phony, "Add an empty rule for each file");
}

std::vector<std::string> WithLongMakeOptions(std::vector<std::string> words) {
  for (std::string& word : words) {
    if (word == "--") break;
    for (const std::string_view name : kNames) {
      if (!word.starts_with(name)) continue;
      const bool takes_value = name == "-MF" || name == "-MT";
      if (word.size() > name.size() && !takes_value) continue;
      if (word.size() > name.size() && word[name.size()] != '=') word.insert(name.size(), "=");
      word.insert(0, "-");
      break;
    }
  }
  return words;
}

std::string WithShortMakeOptions(std::string text) {
  for (const std::string_view name : kNames) {
    const std::string wide = "-" + std::string(name);
    for (std::size_t at = text.find(wide); at != text.npos; at = text.find(wide, at)) {
      // Keeps the descriptions in their column, because the short name is one character shorter.
      text.replace(at, wide.size(), name);
      const std::size_t gap = text.find("  ", at);
      const std::size_t end = text.find('\n', at);
      if (gap < end) text.insert(gap, " ");
    }
  }
  return text;
}

bool MayWriteDependencies(const MakeOptions& options, const output::Destination& destination,
                          bool force, diag::Findings& findings) {
  return options.file == "-" ||
         output::MayReplace(RuleFile(options, destination), force, kRuleStart, IsRule, findings);
}

bool WriteDependencies(const MakeOptions& options, const output::Destination& destination,
                       const std::set<std::string>& files, bool absolute, bool force,
                       diag::Findings& findings) {
  // Asks again, because the file may be one that was just made.
  if (!MayWriteDependencies(options, destination, force, findings)) return false;
  std::set<std::string> names;
  for (const std::string& name : files) names.insert(NameForMake(name, absolute));
  std::set<std::string> all = names;
  if (options.targets.empty()) all.insert(TargetOf(destination).string());
  for (const std::string& name : all) {
    if (output::FitsMake(name)) continue;
    findings.Add(
        diag::Code::kOutputCannotWrite, {},
        fmt::format("-MD: '{}': a rule for Make cannot have this name", diag::SafeText(name)),
        "rename it: Make has no escapes for ; = | \\# and line ends");
    return false;
  }
  std::vector<std::string> targets = options.targets;
  if (targets.empty())
    targets.push_back(output::EscapeForMake(TargetOf(destination).string(), true));
  const std::string rule = output::MakeRule(targets, names, options.phony);
  if (options.file == "-") return PrintBytes(rule) == ExitStatus::kDone;
  return output::WriteSingleFile(RuleFile(options, destination), rule, findings);
}

}  // namespace mjforge::app
