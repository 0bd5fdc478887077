#ifndef MJFORGE_APP_INSPECT_H_
#define MJFORGE_APP_INSPECT_H_

#include <string>

#include "mjforge/forge/forge.h"

namespace mjforge::app {

/// The variant's object is there.
std::string InspectTables(const forge::Recipe& recipe, const forge::Variant& variant);
std::string InspectJson(const forge::Recipe& recipe, const forge::Variant& variant);

std::string InspectTables(const validate::CompiledModel& model);
std::string InspectJson(const validate::CompiledModel& model);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_INSPECT_H_
