# Files and folders of `cmake --install`. The component `program` is for users, `library` for
# programs that link the rooms. Rooms install their own libraries and headers (cmake/Room.cmake).
include(CMakePackageConfigHelpers)

set(mjforge_data_dir ${CMAKE_INSTALL_DATADIR}/mjforge)
set(mjforge_specs_dir ${mjforge_data_dir}/specs)
set(mjforge_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mjforge)

if(MJFORGE_MUJOCO)
  # The dynamic loader does not search this folder.
  get_filename_component(mujoco_folder ${mujoco_LIBRARY} DIRECTORY)
  set_property(TARGET mjforge PROPERTY INSTALL_RPATH ${mujoco_folder})
  if(MJFORGE_PYTHON)
    set_property(TARGET mjforge_python APPEND PROPERTY INSTALL_RPATH ${mujoco_folder})
  endif()
endif()

install(DIRECTORY specs schemas DESTINATION ${mjforge_data_dir} COMPONENT program)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT program)

# mjforge::mjforge links all rooms, because the last rooms link all others.
add_library(mjforge_library INTERFACE)
add_library(mjforge::mjforge ALIAS mjforge_library)
set_target_properties(mjforge_library PROPERTIES EXPORT_NAME mjforge)
target_link_libraries(mjforge_library INTERFACE mjforge::batch mjforge::customize mjforge::picture mjforge::report)

install(TARGETS mjforge_library EXPORT mjforge_targets)
install(EXPORT mjforge_targets NAMESPACE mjforge:: FILE mjforgeTargets.cmake
        DESTINATION ${mjforge_package_dir} COMPONENT library)
configure_package_config_file(cmake/mjforgeConfig.cmake.in mjforgeConfig.cmake
  INSTALL_DESTINATION ${mjforge_package_dir} PATH_VARS mjforge_specs_dir)
write_basic_package_version_file(mjforgeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mjforgeConfig.cmake
              ${PROJECT_BINARY_DIR}/mjforgeConfigVersion.cmake cmake/Dependencies.cmake
        DESTINATION ${mjforge_package_dir} COMPONENT library)
install(DIRECTORY cmake/find DESTINATION ${mjforge_package_dir} COMPONENT library)
