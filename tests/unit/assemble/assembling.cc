// Assembly of specs in tests, and temporary folders.

#include "assembling.h"

#include <algorithm>
#include <fstream>
#include <random>

#include <catch2/catch.hpp>

namespace mjforge::assemble {

Assembling::Assembling(const std::string& body, std::uint64_t seed, std::uint64_t index,
                       const std::filesystem::path& folder, const Assembler::Options& options,
                       model::Placer* placer) {
  spec_ = spec::LoadSpecText("thing.yaml", "mjforge: 1\nname: thing\n" + body, folder, {}, sources_,
                             findings_);
  if (spec_ == nullptr) return;
  findings_.clear();  // warnings: not all cases use all parameters
  std::optional<sample::Evaluator> values =
      sample::Sample(*spec_, {.seed = seed, .index = index}, sample::kRootStream, {}, findings_);
  if (!values) return;
  Assembler assembler(nullptr, placer);
  object_ = assembler.Assemble(*values, options, findings_);
}

const model::Object& Assembling::object() const {
  for (const std::string& finding : findings()) UNSCOPED_INFO(finding);
  REQUIRE(object_);
  return *object_;
}

const model::Part& Assembling::part(const std::string& name) const {
  const auto found = std::ranges::find(body().parts, name, &model::Part::name);
  UNSCOPED_INFO("part " << name);
  REQUIRE(found != body().parts.end());
  return *found;
}

std::vector<std::string> Assembling::findings() const {
  std::vector<std::string> lines;
  for (const diag::Finding& finding : findings_) {
    std::string line = std::to_string(finding.mark.line) + ":" +
                       std::to_string(finding.mark.column) + " " + finding.message;
    if (!finding.hint.empty()) line += " (" + finding.hint + ")";
    lines.push_back(line);
  }
  return lines;
}

std::string OnlyFinding(const std::string& body) {
  const Assembling assembling(body);
  CHECK(assembling.failed());
  std::string all;
  for (const std::string& line : assembling.findings()) all += (all.empty() ? "" : "\n") + line;
  return all;
}

TemporaryFolder::TemporaryFolder()
    : path_(std::filesystem::temp_directory_path() /
            ("mjforge_model_" + std::to_string(std::random_device()()))) {
  std::filesystem::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() { std::filesystem::remove_all(path_); }

void TemporaryFolder::Write(const std::string& name, const std::string& content) const {
  std::filesystem::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name, std::ios::binary) << content;
}

}  // namespace mjforge::assemble
