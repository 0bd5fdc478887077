# Flags for our own code only; they are not exported.
add_library(mjforge_options INTERFACE)
target_compile_options(mjforge_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion)
# GCC 12 sees overlaps in every `"text" + std::string` (its bug 105651), and ends of arrays where
# std::string comes from a precompiled header. AddressSanitizer sees the real ones.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(mjforge_options INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()

# Lines are counted in the rooms and the program, not in the tests.
option(MJFORGE_COVERAGE "Count which lines run" OFF)
add_library(mjforge_counted INTERFACE)
if(MJFORGE_COVERAGE)
  target_compile_options(mjforge_counted INTERFACE --coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()
