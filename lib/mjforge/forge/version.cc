// Versions of mjforge and of the libraries that affect its output.

#include "mjforge/forge/forge.h"

namespace mjforge::forge {

std::string_view Version() { return MJFORGE_VERSION; }

std::vector<Library> Libraries() {
  return {{"MuJoCo", validate::MujocoVersion()},
          {"yaml-cpp", MJFORGE_YAML_CPP_VERSION},
          {"Boost", MJFORGE_BOOST_VERSION},
          {"Eigen", MJFORGE_EIGEN_VERSION}};
}

}  // namespace mjforge::forge
