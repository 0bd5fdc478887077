# mujoco::mujoco. Debian's own package file also asks for OpenGL's and Qhull's
# headers, which only a viewer and MuJoCo itself need.
find_path(mujoco_INCLUDE_DIR mujoco/mujoco.h)
find_library(mujoco_LIBRARY mujoco)
mark_as_advanced(mujoco_INCLUDE_DIR mujoco_LIBRARY)
if(mujoco_INCLUDE_DIR)
  file(STRINGS ${mujoco_INCLUDE_DIR}/mujoco/mujoco.h mujoco_VERSION
       REGEX "#define mjVERSION_HEADER +[0-9]+")
  # 222 says 2.2.2.
  string(REGEX REPLACE ".* ([0-9]+)([0-9])([0-9])$" "\\1.\\2.\\3" mujoco_VERSION
         "${mujoco_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(mujoco
  REQUIRED_VARS mujoco_LIBRARY mujoco_INCLUDE_DIR VERSION_VAR mujoco_VERSION HANDLE_VERSION_RANGE)
if(mujoco_FOUND AND NOT TARGET mujoco::mujoco)
  add_library(mujoco::mujoco UNKNOWN IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES
    IMPORTED_LOCATION ${mujoco_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${mujoco_INCLUDE_DIR})
endif()
