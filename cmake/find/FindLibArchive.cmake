# Defines the target LibArchive::LibArchive: the used parts of the static library, if it exists. The
# shared library loads libxml2 and ICU (36 MB) into each process, for formats that are not used
# here.
find_path(libarchive_INCLUDE_DIR archive.h)
find_library(libarchive_LIBRARY NAMES libarchive.a archive)
find_library(libarchive_zstd_LIBRARY zstd)
mark_as_advanced(libarchive_INCLUDE_DIR libarchive_LIBRARY libarchive_zstd_LIBRARY)
if(libarchive_INCLUDE_DIR)
  file(STRINGS ${libarchive_INCLUDE_DIR}/archive.h LibArchive_VERSION
       REGEX "#define[ \t]+ARCHIVE_VERSION_ONLY_STRING")
  string(REGEX REPLACE ".*\"([0-9.]+).*" "\\1" LibArchive_VERSION "${LibArchive_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LibArchive
  REQUIRED_VARS libarchive_LIBRARY libarchive_zstd_LIBRARY libarchive_INCLUDE_DIR
  VERSION_VAR LibArchive_VERSION)
if(LibArchive_FOUND AND NOT TARGET LibArchive::LibArchive)
  add_library(LibArchive::LibArchive UNKNOWN IMPORTED)
  set_target_properties(LibArchive::LibArchive PROPERTIES
    IMPORTED_LOCATION ${libarchive_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${libarchive_INCLUDE_DIR})
  if(libarchive_LIBRARY MATCHES "\\.a$")
    # The linker drops unused parts, which need libraries that are not linked here.
    find_package(ZLIB REQUIRED)
    set_target_properties(LibArchive::LibArchive PROPERTIES
      INTERFACE_LINK_LIBRARIES "${libarchive_zstd_LIBRARY};ZLIB::ZLIB;-Wl,--gc-sections")
  endif()
endif()
