// Folder of the source tree, for tests that read files of the checkout.

#pragma once

#include <filesystem>

namespace mjforge::harness {

/// Returns the top folder of the checkout from which these tests were built.
std::filesystem::path SourceFolder();

}  // namespace mjforge::harness
