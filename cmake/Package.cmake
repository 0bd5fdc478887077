# Debian package of the component `program`, made by `cpack`. It does not contain the library and
# its headers, because programs that link the rooms must be built with the same compiler and
# options, and because the interface changes with every version until 1.0.
set(CPACK_GENERATOR DEB)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};${PROJECT_NAME};program;/")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_PACKAGE_NAME mjforge)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "randomized MuJoCo objects from declarative YAML specs")
# Debian's tools read the packager's name from these variables.
if("$ENV{DEBEMAIL}" STREQUAL "")
  set(CPACK_PACKAGE_CONTACT "The maintainers of mjforge <maintainers@mjforge.example>")
else()
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"A spec describes a family of objects: mugs with walls of 3 to 5 mm, hammers
with handles of 10 to 25 cm. mjforge writes any number of its members as MJCF
files for MuJoCo. Each is loaded in MuJoCo before its file appears, and each
can be made again from the spec, the seed and its index.
.
With the program come more than fifty specs, their schema and the manual.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded or started at run time: OpenGL without a window for pictures, MuJoCo's viewer for `view`.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1 | libosmesa6")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS libmujoco-samples)
# This script adds the files that only Debian requires.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/DebianFiles.cmake)
include(CPack)
