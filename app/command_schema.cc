#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "mjforge/forge/forge.h"
#include "usage.h"

namespace mjforge::app {

Action AddSchema(CLI::App& command) {
  auto which = std::make_shared<std::string>("object");
  command.add_option("WHICH", *which, "object (for specs, the default) or manifest")
      ->option_text(" ");
  return [which](Console&) {
    if (*which == "object") return Print(spec::JsonSchema());
    if (*which == "manifest") return Print(manifest::ManifestSchema());
    return WrongUsage("'" + *which + "' is not one of object, manifest", "schema");
  };
}

}  // namespace mjforge::app
