// Objects of small specs, for tests.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "mjforge/assemble/assemble.h"

namespace mjforge::harness {

/// Returns the object of a spec with this text after its first two lines, without prefixes. The
/// test fails, with the findings, if the spec is broken.
inline model::Object ObjectOf(const std::string& body, const std::string& name = "thing") {
  diag::Sources sources;
  diag::Findings findings;
  const auto spec = spec::LoadSpecText(name + ".yaml", "mjforge: 1\nname: " + name + "\n" + body,
                                       ".", {}, sources, findings);
  for (const diag::Finding& finding : findings) UNSCOPED_INFO(finding.message);
  REQUIRE(spec != nullptr);
  auto values = sample::Sample(*spec, {.seed = 1}, sample::kRootStream, {}, findings);
  REQUIRE(values);
  auto object = assemble::Assembler().Assemble(*values, {.name = {}, .prefix = false}, findings);
  for (const diag::Finding& finding : findings) UNSCOPED_INFO(finding.message);
  REQUIRE(object);
  return *std::move(object);
}

}  // namespace mjforge::harness
