#pragma once

#include <filesystem>

namespace mjforge::harness {

/// The top folder of the checkout that these tests were built from.
std::filesystem::path SourceFolder();

}  // namespace mjforge::harness
