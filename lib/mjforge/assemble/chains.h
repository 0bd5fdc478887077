// Chains of equal links (`chain:` of a body): their properties, and the joints between links.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// A chain of links of equal length, in which each link hangs along -z from the end of the previous
/// link.
struct Chain {
  int links = 0;
  double pitch = 0;                  // length of a link, m
  bool is_ball = false;              // true: each link has a ball joint; false: two hinges
  std::optional<double> range = {};  // largest angle to either side, rad; nullopt: no limit
  std::vector<model::Attribute> attributes = {};  // MJCF attributes of the joints
};

/// A link of a chain: its chain, its number (from 0), and the index of the body of the previous
/// link, -1 for the first link. For a body that is not a link, `chain` is null.
struct Link {
  const Chain* chain = nullptr;
  int number = 0;
  int previous = -1;
};

/// Reads `chain:` of a body. Returns nullopt, and adds a finding, if a field is invalid.
std::optional<Chain> ReadChain(const FieldReader& body, const spec::Entry& entry);

/// Returns the joints between the link with the full name `link` and the previous link. `mark` is
/// the position of the body's entry in the text of the spec.
std::vector<model::Joint> JointsOfLink(const Chain& chain, const std::string& link,
                                       diag::SourceMark mark);

}  // namespace mjforge::assemble
