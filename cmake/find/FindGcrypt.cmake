# Defines the target Gcrypt::Gcrypt.
find_path(Gcrypt_INCLUDE_DIR gcrypt.h)
find_library(Gcrypt_LIBRARY gcrypt)
mark_as_advanced(Gcrypt_INCLUDE_DIR Gcrypt_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Gcrypt REQUIRED_VARS Gcrypt_LIBRARY Gcrypt_INCLUDE_DIR)
if(Gcrypt_FOUND AND NOT TARGET Gcrypt::Gcrypt)
  add_library(Gcrypt::Gcrypt UNKNOWN IMPORTED)
  set_target_properties(Gcrypt::Gcrypt PROPERTIES
    IMPORTED_LOCATION ${Gcrypt_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${Gcrypt_INCLUDE_DIR})
endif()
