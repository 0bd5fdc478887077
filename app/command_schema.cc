// `mjforge schema`: JSON Schemas of specs and manifests.
#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string_view>

#include "commands.h"
#include "completion.h"
#include "mjforge/forge/forge.h"

namespace mjforge::app {
namespace {

constexpr std::array<std::string_view, 2> kSchemas = {"object", "manifest"};

}  // namespace

Action AddSchema(CLI::App& command) {
  auto which = std::make_shared<std::string>("object");
  command.add_option("WHICH", *which, "object (for specs, the default) or manifest")
      ->option_text(" ")
      ->check(IsOneOf(kSchemas));
  return [which](Console&) {
    return PrintBytes(*which == "object" ? spec::JsonSchema() : manifest::ManifestSchema());
  };
}

}  // namespace mjforge::app
