# Defines the target mujoco::mujoco: MuJoCo of the system, or of the folder MJFORGE_MUJOCO. Debian's
# own CMake package also requires the headers of OpenGL and Qhull, which only viewers and MuJoCo
# itself need.
set(MJFORGE_MUJOCO "" CACHE PATH
  "A folder with include/mujoco and libmujoco.so* (an unpacked wheel's mujoco/, a release); empty: the system's")
if(MJFORGE_MUJOCO)
  find_path(mujoco_INCLUDE_DIR mujoco/mujoco.h PATHS ${MJFORGE_MUJOCO}/include
            NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
  # Wheels contain libmujoco.so.3.3.7 but no libmujoco.so.
  file(GLOB libraries ${MJFORGE_MUJOCO}/libmujoco.so* ${MJFORGE_MUJOCO}/lib/libmujoco.so*)
  if(libraries)
    list(GET libraries 0 library)
    set(mujoco_LIBRARY ${library} CACHE FILEPATH "libmujoco.so of MJFORGE_MUJOCO")
  endif()
else()
  find_path(mujoco_INCLUDE_DIR mujoco/mujoco.h)
  find_library(mujoco_LIBRARY mujoco)
endif()
mark_as_advanced(mujoco_INCLUDE_DIR mujoco_LIBRARY)
if(mujoco_INCLUDE_DIR)
  file(STRINGS ${mujoco_INCLUDE_DIR}/mujoco/mujoco.h mujoco_VERSION
       REGEX "#define mjVERSION_HEADER +[0-9]+")
  string(REGEX REPLACE ".* ([0-9]+)$" "\\1" mujoco_VERSION "${mujoco_VERSION}")
  # 222 means 2.2.2; from 3.5 on, 3005000 means 3.5.0.
  string(REGEX REPLACE "^(.)(.)(.)$" "\\1.\\2.\\3" mujoco_VERSION "${mujoco_VERSION}")
  string(REGEX REPLACE "^(.)(...)(...)$" "\\1.\\2.\\3" mujoco_VERSION "${mujoco_VERSION}")
  string(REGEX REPLACE "\\.0+([0-9])" ".\\1" mujoco_VERSION "${mujoco_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(mujoco
  REQUIRED_VARS mujoco_LIBRARY mujoco_INCLUDE_DIR VERSION_VAR mujoco_VERSION HANDLE_VERSION_RANGE)
if(mujoco_FOUND AND NOT TARGET mujoco::mujoco)
  add_library(mujoco::mujoco UNKNOWN IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES
    IMPORTED_LOCATION ${mujoco_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${mujoco_INCLUDE_DIR})
endif()
