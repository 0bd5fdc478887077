#pragma once

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/engine/engine.h"

namespace mjforge::engine {

/// A file as MuJoCo 2.2.2, or another release, is given it.
struct Adapted {
  explicit Adapted(const std::string& inner, int version = kPortable, Use use = Use::kWholeModel) {
    const auto file = folder.Write("m.xml", "<mujoco>\n" + inner + "\n</mujoco>\n");
    diag::Sources sources;
    diag::Findings found;
    std::optional<XmlElement> root = ReadXml(file, sources, found);
    REQUIRE(root);
    changed = AdaptMjcf(*root, version, use, sources, found);
    text = FlattenInPlace(*root);
    for (const diag::Finding& finding : found) {
      findings.push_back(fmt::format(
          "{}:{} {}: {}", finding.mark.line, finding.mark.column,
          finding.severity == diag::Severity::kError ? "error" : "warning", finding.message));
    }
  }

  bool Says(const std::string& part) const { return text.find(part) != std::string::npos; }

  harness::TemporaryFolder folder;
  bool changed = false;
  std::string text;
  std::vector<std::string> findings;
};

using Strings = std::vector<std::string>;

inline mjModel* Load(const std::string& text, Loaded& loaded) {
  loaded = Engine().LoadText(text);
  INFO(loaded.error);
  REQUIRE(loaded.model);
  return loaded.model.get();
}

}  // namespace mjforge::engine
