// Chains: reader of `chain:`, and the joints between its links.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Links of equal length, each along -z of the link before.
struct Chain {
  int links = 0;
  double pitch = 0;                  // length of a link, m
  bool is_ball = false;              // each link has a ball joint; otherwise two hinges
  std::optional<double> range = {};  // rad; see spec::kChainElement
  std::vector<model::Attribute> attributes = {};  // MJCF attributes of the joints
};

/// A link of a chain, and the body before the link; `chain` is null for a body that is no link.
struct Link {
  const Chain* chain = nullptr;
  int number = 0;
  int previous = -1;
};

/// Reads `chain:` of a body; nullopt after a finding.
std::optional<Chain> ReadChain(const FieldReader& body, const spec::Entry& entry);

/// Returns the joints between the link with the full name `link` and the link before. `mark` is the
/// place of the entry.
std::vector<model::Joint> JointsOfLink(const Chain& chain, const std::string& link,
                                       diag::SourceMark mark);

}  // namespace mjforge::assemble
