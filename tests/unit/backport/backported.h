#pragma once

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/backport/backport.h"
#include "mjforge/engine/engine.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// A file that was backported to MuJoCo 2.2.2 or another release.
struct Backported {
  explicit Backported(const std::string& inner, int version = kPortable,
                      Use use = Use::kWholeModel) {
    const auto file = folder.Write("m.xml", "<mujoco>\n" + inner + "\n</mujoco>\n");
    diag::Sources sources;
    diag::Findings found;
    std::optional<xml::XmlElement> root = xml::ReadXml(file, sources, found);
    REQUIRE(root);
    changed = BackportMjcf(*root, version, use, sources, found);
    text = xml::FlattenInPlace(*root);
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

inline mjModel* Load(const std::string& text, engine::Loaded& loaded) {
  loaded = engine::Engine().LoadText(text);
  INFO(loaded.error);
  REQUIRE(loaded.model);
  return loaded.model.get();
}

}  // namespace mjforge::backport
