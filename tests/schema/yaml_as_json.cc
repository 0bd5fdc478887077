#include "yaml_as_json.h"

#include <cstdlib>
#include <regex>

#include <yaml-cpp/yaml.h>

namespace {

nlohmann::json Scalar(const YAML::Node& node) {
  static const std::regex kNumber(R"([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)");
  static const std::regex kInteger(R"([-+]?\d+)");
  const std::string& text = node.Scalar();
  if (node.Tag() == "!") return text;
  if (text == "true" || text == "false") return text == "true";
  if (text == "null" || text == "~") return nullptr;
  if (std::regex_match(text, kInteger)) return std::stoll(text);
  if (std::regex_match(text, kNumber))
    return nlohmann::json::parse(nlohmann::json(std::stod(text)).dump());
  return text;
}

nlohmann::json Convert(const YAML::Node& node) {
  if (node.IsScalar()) return Scalar(node);
  if (node.IsSequence()) {
    nlohmann::json list = nlohmann::json::array();
    for (const YAML::Node& item : node) list.push_back(Convert(item));
    return list;
  }
  if (node.IsMap()) {
    nlohmann::json map = nlohmann::json::object();
    for (const auto& pair : node) map[pair.first.Scalar()] = Convert(pair.second);
    return map;
  }
  return nullptr;
}

}  // namespace

nlohmann::json YamlAsJson(const std::string& file) { return Convert(YAML::LoadFile(file)); }
