// Specs loaded from text for the tests of this folder.

#include "loading.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

using mjforge::sample::DrawKey;
namespace sample = mjforge::sample;
namespace spec = mjforge::spec;

Family Load(const std::string& params, const std::string& more) {
  std::string text = "mjforge: 1\nname: t\nparams: " + params + "\n" + more + "\n";
  if (more.find("parts:") == std::string::npos) {
    text += "parts: [{name: b, type: box, size: [1, 1, 1]}]\n";
  }
  Family family;
  family.spec = spec::LoadSpecText("t.yaml", text, ".", {}, family.sources, family.findings);
  if (family.spec == nullptr) {
    std::string message = "the test's spec is wrong:";
    for (const std::string& line : family.Report()) message += " " + line;
    throw std::logic_error(message);
  }
  family.findings.clear();  // drop warnings about unused parameters
  return family;
}

sample::Evaluator Family::Evaluator(DrawKey key, const sample::Sampler* sampler) {
  sample::Evaluator evaluator(*spec, key, sample::kRootStream, findings, sampler);
  evaluator.SampleParameters();
  return evaluator;
}

sample::ParameterValue Family::Parameter(std::string_view name, DrawKey key,
                                         const sample::Sampler* sampler) {
  const auto found = std::ranges::find(spec->parameters, name, &spec::Parameter::name);
  if (found == spec->parameters.end()) throw std::logic_error("no such parameter");
  return Evaluator(key, sampler)
      .Parameter(static_cast<std::size_t>(found - spec->parameters.begin()));
}

double Family::Number(std::string_view name, DrawKey key, const sample::Sampler* sampler) {
  return std::get<double>(Parameter(name, key, sampler));
}

const spec::Value& Family::PartValue(std::string_view key) const {
  for (const spec::Field& field : spec->parts.at(0).fields) {
    if (field.info->key == key) return field.value;
  }
  throw std::logic_error("no such key");
}

Strings Family::Report() const {
  Strings lines;
  for (const mjforge::diag::Finding& finding : findings) {
    std::string line = std::to_string(finding.mark.line) + ":" +
                       std::to_string(finding.mark.column) + " " +
                       std::string(mjforge::diag::CodeName(finding.code)) + ": " + finding.message;
    if (!finding.hint.empty()) line += " (" + finding.hint + ")";
    if (finding.seed) line += " " + std::to_string(*finding.seed);
    if (finding.index) line += "/" + std::to_string(*finding.index);
    lines.push_back(line);
    for (const mjforge::diag::Note& note : finding.notes) {
      lines.push_back("  " + std::to_string(note.mark.line) + ":" +
                      std::to_string(note.mark.column) + " " + note.message);
    }
  }
  return lines;
}

Strings ReportOf(const std::string& params, const std::string& more) {
  Family family = Load(params, more);
  sample::Sample(*family.spec, {.seed = 7, .index = 3}, sample::kRootStream, {}, family.findings);
  return family.Report();
}
