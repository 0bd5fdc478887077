#include "attaching.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "mjforge/expr/expr.h"

namespace mjforge::attach {
namespace {

std::string Without(std::string text, const std::string& folder) {
  for (std::size_t at = 0; (at = text.find(folder)) != std::string::npos;) {
    text.erase(at, folder.size());
  }
  return text;
}

}  // namespace

Attaching::Attaching(const std::string& arm) {
  if (!arm.empty()) Write("arm.xml", arm);
}

const model::Attachment* Attaching::Try(const std::string& body, const std::string& file) {
  findings_.clear();
  const model::Attachment* attachment = reader_.Attach(folder_ / file, body, kMark, findings_);
  CHECK((attachment == nullptr) == findings_.HasErrors());
  for (const diag::Finding& finding : findings_) CHECK(finding.mark == kMark);
  return attachment;
}

const model::Attachment& Attaching::Get(const std::string& body, const std::string& file) {
  const model::Attachment* attachment = Try(body, file);
  for (const std::string& line : Report()) UNSCOPED_INFO(line);
  REQUIRE(attachment != nullptr);
  return *attachment;
}

std::vector<std::string> Attaching::Report() const {
  std::vector<std::string> lines;
  const std::string folder = folder_.path().string() + "/";
  for (const diag::Finding& finding : findings_) {
    const bool error = finding.severity == diag::Severity::kError;
    std::string line = fmt::format("{} {}: {}", error ? "error" : "warning",
                                   diag::CodeName(finding.code), finding.message);
    if (!finding.hint.empty()) line += " (" + finding.hint + ")";
    for (const diag::Note& note : finding.notes) {
      line += fmt::format(" [{}:{}:{} {}]", note.mark ? sources_.Name(note.mark.file) : "",
                          note.mark.line, note.mark.column, note.message);
    }
    lines.push_back(Without(line, folder));
  }
  return lines;
}

std::string Attaching::OnlyFinding() const {
  std::string all;
  for (const std::string& line : Report()) all += (all.empty() ? "" : "\n") + line;
  return all;
}

std::string Mjcf(const std::string& bodies, const std::string& sections) {
  return "<mujoco>\n" + sections + "<worldbody>\n" + bodies + "</worldbody>\n</mujoco>\n";
}

std::string Said(const std::vector<model::Attribute>& attributes, std::string_view name) {
  for (const model::Attribute& attribute : attributes) {
    if (attribute.name != name) continue;
    std::string said = attribute.text;
    for (const double number : attribute.numbers) {
      if (!said.empty()) said += ' ';
      expr::AppendNumber(said, number);
    }
    return said;
  }
  return "-";
}

std::string Said(const std::vector<model::Attribute>& attributes) {
  std::string all;
  for (const model::Attribute& attribute : attributes) {
    all += fmt::format("{}{}={}", all.empty() ? "" : " ", attribute.name,
                       Said(attributes, attribute.name));
  }
  return all;
}

}  // namespace mjforge::attach
