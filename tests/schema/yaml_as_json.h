#ifndef MJFORGE_TESTS_SCHEMA_YAML_AS_JSON_H_
#define MJFORGE_TESTS_SCHEMA_YAML_AS_JSON_H_

#include <string>

#include <nlohmann/json.hpp>

/// A YAML file as an editor's schema check sees it: YAML 1.2 core types, quoted
/// scalars are strings. Throws what yaml-cpp throws.
nlohmann::json YamlAsJson(const std::string& file);

#endif  // MJFORGE_TESTS_SCHEMA_YAML_AS_JSON_H_
