# Three quarters of the time it takes to compile a file go into headers of other people. They are
# precompiled, once for the rooms, once for the program, once for the tests. clang-tidy cannot
# read what GCC precompiles, so `./dev lint` looks at a configuration without it. Only the debug
# preset, which compiles each file by itself, finds a file that does not include what it uses.
option(MJFORGE_PRECOMPILED "Precompile the largest headers" ${PROJECT_IS_TOP_LEVEL})
option(MJFORGE_UNITY "Compile a room's files several at a time" ${PROJECT_IS_TOP_LEVEL})

set(mjforge_precompiled_headers
  <algorithm> <array> <charconv> <cmath> <cstdint> <filesystem> <functional> <limits> <map>
  <memory> <numbers> <optional> <set> <span> <string> <string_view> <system_error>
  <unordered_map> <utility> <variant> <vector> <Eigen/Dense> <fmt/format.h>)

# A target without code of its own, for others to take the headers from.
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

# The headers of another target that has the same options.
function(mjforge_precompile_from target owner)
  if(MJFORGE_PRECOMPILED)
    target_precompile_headers(${target} REUSE_FROM ${owner})
    # GCC wants the same macros.
    target_compile_definitions(${target}
      PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  endif()
endfunction()

# Headers for the target itself: those above and others.
function(mjforge_precompile target)
  if(MJFORGE_PRECOMPILED)
    target_precompile_headers(${target} PRIVATE ${mjforge_precompiled_headers} ${ARGN})
    target_compile_definitions(${target}
      PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  endif()
endfunction()
