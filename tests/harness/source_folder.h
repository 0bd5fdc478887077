#ifndef MJFORGE_TESTS_HARNESS_SOURCE_FOLDER_H_
#define MJFORGE_TESTS_HARNESS_SOURCE_FOLDER_H_

#include <filesystem>

namespace mjforge::harness {

/// The top folder of the checkout that these tests were built from.
std::filesystem::path SourceFolder();

}  // namespace mjforge::harness

#endif  // MJFORGE_TESTS_HARNESS_SOURCE_FOLDER_H_
