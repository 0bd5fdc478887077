# Defines the target ctemplate::ctemplate.
find_path(ctemplate_INCLUDE_DIR ctemplate/template.h)
find_library(ctemplate_LIBRARY ctemplate)
mark_as_advanced(ctemplate_INCLUDE_DIR ctemplate_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ctemplate REQUIRED_VARS ctemplate_LIBRARY ctemplate_INCLUDE_DIR)
if(ctemplate_FOUND AND NOT TARGET ctemplate::ctemplate)
  find_package(Threads REQUIRED)
  add_library(ctemplate::ctemplate UNKNOWN IMPORTED)
  set_target_properties(ctemplate::ctemplate PROPERTIES
    IMPORTED_LOCATION ${ctemplate_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${ctemplate_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES Threads::Threads)
endif()
