#ifndef MJFORGE_APP_PREVIEW_CAPTIONS_H_
#define MJFORGE_APP_PREVIEW_CAPTIONS_H_

#include <span>
#include <string>
#include <vector>

#include "mjforge/manifest/manifest.h"

namespace mjforge::app {

/// The lines below each variant of a contact sheet: its index, and the
/// parameters in which these variants differ most, in the spec's order.
std::vector<std::vector<std::string>> Captions(std::span<const manifest::Record> records);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_PREVIEW_CAPTIONS_H_
