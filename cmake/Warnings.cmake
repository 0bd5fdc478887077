# Flags for our own code only; they are not exported.
add_library(mjforge_options INTERFACE)
target_compile_options(mjforge_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion)
# Counts are 64 bits wide from MuJoCo 3.4 on, the numbers of elements still int: that conversions
# lose nothing is judged with Debian's. Whoever includes MuJoCo's headers gets these options behind
# those above; all else compiles as with Debian's, and the compiler's cache has it.
if(mujoco_VERSION VERSION_GREATER_EQUAL 3)
  set_property(TARGET mujoco::mujoco APPEND PROPERTY
    INTERFACE_COMPILE_OPTIONS -Wno-conversion -Wno-narrowing)
endif()
# A step is compiled where it is noted and where it is taken again. Both must round alike, on
# processors that can multiply and add at once, too.
target_compile_options(mjforge_options INTERFACE -ffp-contract=off)
# Within a shared library (app/python), calls may be inlined as in a program.
target_compile_options(mjforge_options INTERFACE -fno-semantic-interposition)
# GCC 12 sees overlaps in every `"text" + std::string` (its bug 105651), and ends of arrays where
# std::string comes from a precompiled header. AddressSanitizer sees the real ones.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(mjforge_options INTERFACE -Wno-restrict -Wno-array-bounds
    -Wno-stringop-overflow -Wno-stringop-overread)
endif()
# A file that is compiled with others is not the main one, in which this is allowed.
if(MJFORGE_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(mjforge_options INTERFACE -Wno-subobject-linkage)
endif()

# The rooms and the program alone are watched: tests compile to the same objects in every
# configuration, and the compiler's cache has them.
option(MJFORGE_SANITIZE "Find memory errors and undefined behaviour; count the lines run" OFF)
add_library(mjforge_watched INTERFACE)
if(MJFORGE_SANITIZE)
  set(watchers -fsanitize=address,undefined --coverage)
  # A null pointer ends the program where it is read, and this processor reads at any address: the
  # two checks of each pointer, which took a quarter of the time to compile, are left to fuzzing.
  target_compile_options(mjforge_watched INTERFACE ${watchers} -fno-sanitize=null,alignment -O1 -g1
    -UNDEBUG -fno-sanitize-recover=all -fno-omit-frame-pointer -fprofile-update=atomic)
  add_link_options(${watchers})
endif()

# For tests/fuzz, with clang: libFuzzer sees which lines an input runs, and the same errors are found.
option(MJFORGE_FUZZ "Build what tests/fuzz runs, and watch the rooms as it needs" OFF)
if(MJFORGE_FUZZ)
  set(fuzz_watchers -fsanitize=address,undefined)
  target_compile_options(mjforge_watched INTERFACE -fsanitize=fuzzer-no-link ${fuzz_watchers} -O1 -g1
    -UNDEBUG -fno-sanitize-recover=all -fno-omit-frame-pointer
    -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/tests/fuzz/ignored.txt)
  add_link_options(${fuzz_watchers})
endif()
