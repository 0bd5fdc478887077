#include "manual_page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>

#include "make_options.h"
#include "mjforge/forge/forge.h"

namespace mjforge::app {
namespace {

// The end of mjforge.1, as docs/manual.md says it.
constexpr const char* kEnd = R"(.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
findings: a spec has errors, a variant failed, a replay differs
.TP
.B 2
wrong usage
.TP
.B 3
input or output failed, or memory is not enough
.TP
.B 70
a bug in mjforge
.TP
.B 130
interrupted; every file is complete, and
.B \-\-resume
continues
.PP
If several apply, the largest counts.
.SH ENVIRONMENT
.TP
.B MJFORGE_PATH
folders with specs, separated by colons, searched before the bundled ones
.TP
.B MUJOCO_GL
what draws pictures: egl, osmesa, or disable
.TP
.B NO_COLOR
no colours, as with
.B \-\-color never
)";

// Text that stands for itself in a man page.
std::string Plain(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    switch (c) {
      case '\\':
        plain += "\\e";
        break;
      case '-':
        plain += "\\-";
        break;
      case '\'':
        plain += "\\(aq";
        break;
      case '`':
        plain += "\\(ga";
        break;
      case '^':
        plain += "\\(ha";
        break;
      case '~':
        plain += "\\(ti";
        break;
      default:
        plain += c;
    }
  }
  return plain.starts_with('.') ? "\\&" + plain : plain;
}

std::string Bold(std::string_view text) { return "\\fB" + Plain(text) + "\\fR"; }
std::string Italic(std::string_view text) { return "\\fI" + Plain(text) + "\\fR"; }

std::string PageOf(const CLI::App& command) { return "mjforge-" + command.get_name(); }

// "-n, --count N [1]"
std::string OptionNames(const CLI::Option& option) {
  std::string names;
  const auto add = [&names](const std::string& name) {
    names += (names.empty() ? "" : ", ") + Bold(WithShortMakeOptions(name));
  };
  for (const std::string& name : option.get_snames()) add("-" + name);
  for (const std::string& name : option.get_lnames()) add("--" + name);
  if (names.empty()) names = Italic(option.get_single_name());
  const std::string& text = option.get_option_text();
  const std::size_t end = std::min(text.find(' '), text.size());
  if (end > 0) names += " " + Italic(text.substr(0, end)) + Plain(text.substr(end));
  return names;
}

// "[OPTIONS] SPEC..."
std::string Synopsis(CLI::App& command) {
  std::string text = fmt::format("[{}]", Italic("OPTIONS"));
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const bool repeats = option->get_items_expected_max() > 1;
    const std::string name = Italic(option->get_single_name()) + (repeats ? "..." : "");
    text += option->get_required() ? " " + name : fmt::format(" [{}]", name);
  }
  return text;
}

std::string PageStart(const std::string& page, std::string does) {
  std::string title = page;
  std::ranges::transform(title, title.begin(), [](char c) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  });
  if (!does.empty()) does[0] = static_cast<char>(does[0] | 0x20);  // in ASCII, a small letter
  return fmt::format(
      ".TH {} 1 \"\" \"mjforge {}\" \"Manual of mjforge\"\n"
      ".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
      Plain(title), forge::Version(), Plain(page), Plain(does));
}

// The chapter of arguments or of options.
std::string OptionChapter(CLI::App& command, bool positional, std::string_view title) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() == positional)
      text += fmt::format(".TP\n{}\n{}\n", OptionNames(*option), Plain(option->get_description()));
  }
  return text.empty() ? text : fmt::format(".SH {}\n{}", title, text);
}

// Of a footer "Examples:\n  LINE\n  LINE".
std::string ExampleChapter(const std::string& footer) {
  std::string text;
  for (std::size_t end = footer.find('\n'); end != footer.npos;) {
    const std::size_t begin = footer.find_first_not_of(' ', end + 1);
    end = footer.find('\n', begin);
    text += Plain(footer.substr(begin, end - begin)) + "\n";
  }
  return ".SH EXAMPLES\n.EX\n" + text + ".EE\n";
}

std::string CommandPage(CLI::App& command) {
  const std::string& does = command.get_description();
  return PageStart(PageOf(command), does) +
         fmt::format("{} {}\n", Bold("mjforge " + command.get_name()), Synopsis(command)) +
         fmt::format(".SH DESCRIPTION\n{}.\n", Plain(does)) +
         OptionChapter(command, true, "ARGUMENTS") + OptionChapter(command, false, "OPTIONS") +
         ExampleChapter(command.get_footer()) +
         ".SH SEE ALSO\n.BR mjforge (1),\nfor the other commands, exit status and environment\n";
}

std::string FirstPage(CLI::App& app) {
  const auto commands = app.get_subcommands({});
  std::string text = PageStart(app.get_name(), "randomized MuJoCo objects from YAML specs") +
                     fmt::format("{} {} ...\n.br\n{} {}\n", Bold("mjforge"), Italic("COMMAND"),
                                 Bold("mjforge help"), Italic("COMMAND")) +
                     fmt::format(".SH DESCRIPTION\n{}\n", Plain(app.get_description())) +
                     ".SH COMMANDS\n";
  for (const CLI::App* command : commands)
    text +=
        fmt::format(".TP\n{}\n{}\n", Bold(command->get_name()), Plain(command->get_description()));
  text += OptionChapter(app, false, "OPTIONS") + kEnd + ".SH SEE ALSO\n.nh\n";
  for (const CLI::App* command : commands)
    text += fmt::format(".BR {} (1){}\n", Plain(PageOf(*command)),
                        command == commands.back() ? "" : ",");
  return text;
}

}  // namespace

ExitStatus WriteManualPages(CLI::App& app, const std::string& folder) {
  ReportOptions report;
  Console console(report);
  const auto write = [&](const std::string& page, const std::string& text) {
    output::WriteFile(std::filesystem::path(folder) / (page + ".1"), text, false, console.findings);
  };
  write(app.get_name(), FirstPage(app));
  for (CLI::App* command : app.get_subcommands({})) write(PageOf(*command), CommandPage(*command));
  return console.Tell();
}

}  // namespace mjforge::app
