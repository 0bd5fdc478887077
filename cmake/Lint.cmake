# All sources of lib and app as one target, which is not built: clang-tidy reads its unity files.
# They contain files of several rooms, because headers take most of the time of clang-tidy. Files of
# a room that are compiled together are in the same group, and the room's other files are in other
# groups, because unnamed namespaces of these files may use the same names.

set(groups 6)
set(group 0)
get_property(rooms GLOBAL PROPERTY mjforge_rooms)
foreach(target IN LISTS rooms ITEMS mjforge mjforge_python)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  list(APPEND lint_libraries ${libraries})
  set(count 0)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder})
    get_property(is_embedded SOURCE ${source} TARGET_DIRECTORY ${target}
                 PROPERTY SKIP_UNITY_BUILD_INCLUSION)
    get_property(definitions SOURCE ${source} TARGET_DIRECTORY ${target}
                 PROPERTY COMPILE_DEFINITIONS)
    if(is_embedded OR definitions)
      continue()
    endif()
    list(APPEND lint_sources ${source})
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${group})
    math(EXPR count "(${count} + 1) % ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
    if(count EQUAL 0)
      math(EXPR group "(${group} + 1) % ${groups}")
    endif()
  endforeach()
  math(EXPR group "(${group} + 1) % ${groups}")
endforeach()

list(REMOVE_DUPLICATES lint_libraries)
add_library(mjforge_lint OBJECT EXCLUDE_FROM_ALL ${lint_sources})
target_link_libraries(mjforge_lint PRIVATE ${lint_libraries})
set_target_properties(mjforge_lint PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
