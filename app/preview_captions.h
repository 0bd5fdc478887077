#pragma once

#include <span>
#include <string>
#include <vector>

#include "mjforge/manifest/manifest.h"
#include "mjforge/spec/spec.h"

namespace mjforge::app {

/// The lines below each variant of a contact sheet: its index, and the parameters in which these
/// variants visibly differ most: words first, then sizes. Only drawn parameters, or any if the spec
/// draws none.
std::vector<std::vector<std::string>> Captions(std::span<const manifest::Record> records,
                                               const spec::ObjectSpec& spec);

}  // namespace mjforge::app
