// `mjforge schema`: prints the JSON Schema of specs, manifests or placements.
#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string_view>

#include "commands.h"
#include "completion.h"
#include "mjforge/forge/forge.h"

namespace mjforge::app {
namespace {

constexpr std::array<std::string_view, 3> kSchemas = {"object", "manifest", "placement"};

}  // namespace

Action AddSchema(CLI::App& command) {
  auto which = std::make_shared<std::string>("object");
  command.add_option("WHICH", *which, "object (for specs, default), manifest, placement")
      ->option_text(" ")
      ->check(IsOneOf(kSchemas));
  return [which](Console&) {
    if (*which == "placement") return PrintBytes(manifest::PlacementSchema());
    return PrintBytes(*which == "object" ? spec::JsonSchema() : manifest::ManifestSchema());
  };
}

}  // namespace mjforge::app
