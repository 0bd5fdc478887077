# LibArchive::LibArchive: of the static library, where there is one, what is used. The shared one
# brings libxml2 and ICU (36 MB) into each process, for formats that nothing here reads or writes.
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
    # What nothing refers to names libraries that are not there; zlib is, because others load it.
    find_package(ZLIB REQUIRED)
    set_target_properties(LibArchive::LibArchive PROPERTIES
      INTERFACE_LINK_LIBRARIES "${libarchive_zstd_LIBRARY};ZLIB::ZLIB;-Wl,--gc-sections")
  endif()
endif()
