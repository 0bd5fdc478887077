#include "harness/source_folder.h"

namespace mjforge::harness {

std::filesystem::path SourceFolder() { return MJFORGE_SOURCE_DIR; }

}  // namespace mjforge::harness
