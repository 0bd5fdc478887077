# Precompiled headers: the headers of other libraries take three quarters of the compile time. They
# are compiled once for the rooms and the program, and once for the tests. clang-tidy cannot
# read GCC's precompiled headers, so `./dev lint` has a configuration without them. Missing includes
# are only found by the debug preset, which compiles each file by itself.
option(MJFORGE_PRECOMPILED "Precompile the largest headers" ${PROJECT_IS_TOP_LEVEL})
option(MJFORGE_UNITY "Compile a room's files several at a time" ${PROJECT_IS_TOP_LEVEL})
# Files that are compiled together share the instances of templates: groups of 16 take 0.6 to 0.8 of
# the time of CMake's groups of 8, and about 1 GB of memory.
if(MJFORGE_UNITY AND NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
endif()

set(mjforge_precompiled_headers
  <algorithm> <array> <charconv> <cmath> <cstdint> <filesystem> <functional> <limits> <map>
  <memory> <numbers> <optional> <set> <span> <string> <string_view> <system_error>
  <unordered_map> <utility> <variant> <vector> <Eigen/Dense> <fmt/format.h>)

# This target has no code; other targets reuse its precompiled headers.
if(MJFORGE_PRECOMPILED)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cc CONTENT "")
  add_library(mjforge_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cc)
  target_compile_features(mjforge_precompiled PUBLIC cxx_std_20)
  target_link_libraries(mjforge_precompiled
    PRIVATE Eigen3::Eigen fmt::fmt mjforge_options mjforge_watched)
  set_target_properties(mjforge_precompiled PROPERTIES
    POSITION_INDEPENDENT_CODE ${MJFORGE_PYTHON})
  target_precompile_headers(mjforge_precompiled PRIVATE ${mjforge_precompiled_headers})
endif()

# Reuses the precompiled headers of a target with the same options.
function(mjforge_precompile_from target owner)
  if(MJFORGE_PRECOMPILED)
    target_precompile_headers(${target} REUSE_FROM ${owner})
    # GCC requires the same macros.
    target_compile_definitions(${target}
      PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  endif()
endfunction()

# Precompiles the headers above and ARGN for one target.
function(mjforge_precompile target)
  if(MJFORGE_PRECOMPILED)
    target_precompile_headers(${target} PRIVATE ${mjforge_precompiled_headers} ${ARGN})
    target_compile_definitions(${target}
      PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  endif()
endfunction()
