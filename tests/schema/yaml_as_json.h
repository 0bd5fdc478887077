#pragma once

#include <string>

#include <nlohmann/json.hpp>

/// A YAML file as an editor's schema check sees it: YAML 1.2 core types, quoted
/// scalars are strings. Throws what yaml-cpp throws.
nlohmann::json YamlAsJson(const std::string& file);
