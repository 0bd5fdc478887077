# Compiler options of our own code; they are not exported.
add_library(mjforge_options INTERFACE)
target_compile_options(mjforge_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion)
# From MuJoCo 3.4 on, counts have 64 bits and numbers of elements are int. Conversions are checked
# with Debian's MuJoCo only. Only targets that include MuJoCo's headers have these options, so that
# the compiler's cache is valid for all others.
if(mujoco_VERSION VERSION_GREATER_EQUAL 3)
  set_property(TARGET mujoco::mujoco APPEND PROPERTY
    INTERFACE_COMPILE_OPTIONS -Wno-conversion -Wno-narrowing)
endif()
# Equal computations in different functions must be rounded equally, also on processors with fused
# multiply-add.
target_compile_options(mjforge_options INTERFACE -ffp-contract=off)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
  # Eigen calls fused multiply-add if the macro is defined. The notes about the calling convention of
  # GCC 9 concern std::pair<double, double>.
  target_compile_options(mjforge_options INTERFACE -U__ARM_FEATURE_FMA -Wno-psabi)
endif()
# Allows inlining within the shared library of the Python package, like in a program.
target_compile_options(mjforge_options INTERFACE -fno-semantic-interposition)
# GCC 12 has false warnings of overlaps in `"text" + std::string` (GCC bug 105651), and of array
# bounds if std::string comes from a precompiled header. AddressSanitizer finds the real errors.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(mjforge_options INTERFACE -Wno-restrict -Wno-array-bounds
    -Wno-stringop-overflow -Wno-stringop-overread)
endif()
# GCC collects garbage whenever its heap has doubled, which takes a tenth of the compile time. Below
# 1 GB it collects nothing.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(mjforge_options INTERFACE --param=ggc-min-heapsize=1000000)
endif()
# In a unity build, source files are included by another file. GCC then warns of types with members
# from anonymous namespaces.
if(MJFORGE_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(mjforge_options INTERFACE -Wno-subobject-linkage)
endif()

# Sanitizers and coverage apply to the rooms and the program only. Tests compile to the same objects
# in every configuration, so that the compiler's cache is valid.
option(MJFORGE_SANITIZE "Find memory errors and undefined behaviour" OFF)
option(MJFORGE_COVERAGE "Count the lines run" OFF)
add_library(mjforge_watched INTERFACE)
if(MJFORGE_SANITIZE)
  set(watchers -fsanitize=address,undefined)
  # Without the checks for null and misaligned pointers, which took a quarter of the compile time:
  # null pointers crash anyway, and x86-64 allows misaligned reads. Fuzzing has these checks.
  target_compile_options(mjforge_watched INTERFACE ${watchers} -fno-sanitize=null,alignment -Og -g1
    -UNDEBUG -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # -Og takes 0.8 of the compile time of -O1, but cannot inline all that xxHash asks for.
  target_compile_definitions(mjforge_watched INTERFACE XXH_NO_INLINE_HINTS=1)
  # At a fixed address: otherwise, each start of the program relocates 870,000 addresses, most of them in
  # the messages of UndefinedBehaviorSanitizer.
  add_link_options(${watchers} -no-pie)
endif()
if(MJFORGE_COVERAGE)
  target_compile_options(mjforge_watched INTERFACE --coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()

# For tests/fuzz, with clang: coverage for libFuzzer, and the same sanitizers.
option(MJFORGE_FUZZ "Build what tests/fuzz runs, and watch the rooms as it needs" OFF)
if(MJFORGE_FUZZ)
  set(fuzz_watchers -fsanitize=address,undefined)
  target_compile_options(mjforge_watched INTERFACE -fsanitize=fuzzer-no-link ${fuzz_watchers} -O1 -g1
    -UNDEBUG -fno-sanitize-recover=all -fno-omit-frame-pointer
    -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/tests/fuzz/ignored.txt)
  add_link_options(${fuzz_watchers})
endif()
