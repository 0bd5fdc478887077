#include "docs/page.h"

#include <cctype>
#include <fstream>
#include <regex>
#include <span>
#include <sstream>

#include "harness/temporary_folder.h"

namespace mjforge::docs {
namespace {

constexpr std::string_view kFileComment = "# file: ";
constexpr std::string_view kPrompt = "$ ";
constexpr std::string_view kHeading = "## ";

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool FitsLines(std::span<const std::string> output, std::span<const std::string> expected) {
  if (expected.empty()) return output.empty();
  if (expected.front() == "...") {
    for (std::size_t skipped = 0; skipped <= output.size(); ++skipped) {
      if (FitsLines(output.subspan(skipped), expected.subspan(1))) return true;
    }
    return false;
  }
  return !output.empty() && output.front() == expected.front() &&
         FitsLines(output.subspan(1), expected.subspan(1));
}

// Takes the lines of one page in turn.
class Reader {
 public:
  std::vector<Step> Read(const std::string& text) {
    for (const std::string& line : Lines(text)) {
      ++line_;
      if (line.starts_with("```")) {
        Fence(line);
      } else if (block_.empty() && line.starts_with(kHeading)) {
        chapter_ = line.substr(kHeading.size());
      } else if (block_ == "```console") {
        ConsoleLine(line);
      } else {
        FileLine(line);
      }
      previous_ = line;
    }
    return std::move(steps_);
  }

 private:
  void ConsoleLine(const std::string& line) {
    if (line.starts_with(kPrompt)) {
      Add(Step::Kind::kCommand, line.substr(kPrompt.size()));
    } else if (!steps_.empty() && steps_.back().kind == Step::Kind::kCommand) {
      steps_.back().text += line + "\n";
    }
  }

  void Fence(const std::string& line) {
    block_ = block_.empty() ? line : "";
    const std::size_t name = block_.find(' ');
    is_file_ = name != std::string::npos;
    if (is_file_) Add(Step::Kind::kFile, block_.substr(name + 1));
  }

  void FileLine(const std::string& line) {
    if (previous_ == "```yaml" && line.starts_with(kFileComment)) {
      Add(Step::Kind::kFile, line.substr(kFileComment.size()));
      is_file_ = true;
    }
    if (is_file_) steps_.back().text += line + "\n";
  }

  void Add(Step::Kind kind, std::string name) {
    steps_.push_back(
        {.kind = kind, .line = line_, .name = std::move(name), .text = {}, .chapter = chapter_});
  }

  std::vector<Step> steps_;
  int line_ = 0;
  std::string chapter_;
  std::string block_;  // the fence that opened it
  std::string previous_;
  bool is_file_ = false;
};

}  // namespace

std::vector<Step> ReadSteps(const std::filesystem::path& page) {
  return Reader().Read(harness::ReadFile(page));
}

void ReplaceOutputs(const std::filesystem::path& page, const std::map<int, std::string>& outputs) {
  const std::string text = harness::ReadFile(page);
  std::ofstream file(page, std::ios::binary);
  int number = 0;
  bool skip = false;
  for (const std::string& line : Lines(text)) {
    ++number;
    if (line.starts_with(kPrompt) || line.starts_with("```")) skip = false;
    if (!skip) file << line << '\n';
    const auto output = outputs.find(number);
    if (output == outputs.end()) continue;
    file << output->second;
    skip = true;
  }
}

std::vector<std::string> ReadLinks(const std::filesystem::path& page) {
  static const std::regex kLink("\\]\\(([^)\\s]+)\\)|<a href=\"([^\"]+)\"|<img src=\"([^\"]+)\"");
  const std::string text = harness::ReadFile(page);
  std::vector<std::string> links;
  for (std::sregex_iterator link(text.begin(), text.end(), kLink), end; link != end; ++link) {
    for (std::size_t group = 1; group < link->size(); ++group) {
      if ((*link)[group].matched) links.push_back((*link)[group]);
    }
  }
  return links;
}

std::vector<std::string> ReadAnchors(const std::filesystem::path& page) {
  std::vector<std::string> anchors;
  bool in_block = false;
  for (const std::string& line : Lines(harness::ReadFile(page))) {
    if (line.starts_with("```")) in_block = !in_block;
    if (in_block || !line.starts_with("#")) continue;
    std::string anchor;
    for (const char c : line.substr(line.find_first_not_of("# "))) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') {
        anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      } else if (c == ' ') {
        anchor += '-';
      }
    }
    anchors.push_back(anchor);
  }
  return anchors;
}

bool Fits(const std::string& output, const std::string& expected) {
  return FitsLines(Lines(output), Lines(expected));
}

}  // namespace mjforge::docs
