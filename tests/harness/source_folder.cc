// Folder of the source tree, as a constant of the build.

#include "harness/source_folder.h"

namespace mjforge::harness {

std::filesystem::path SourceFolder() { return MJFORGE_SOURCE_DIR; }

}  // namespace mjforge::harness
