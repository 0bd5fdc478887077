# mjforge_room(NAME SOURCES ... ROOMS ... LIBRARIES ...)
#
# Adds a room: one stage of the data flow, in one static library. A room can include the headers of
# the rooms in ROOMS and of the rooms that their doors include. Other includes do not compile,
# because the include directory of a room contains only that room. tests/house/doors_test.cc defines
# which of these headers a room may include directly.
# LIBRARIES are private to the room; PUBLIC_LIBRARIES appear in its door.
# PUBLIC_HEADERS are the door and its includes; only they are installed.
function(mjforge_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "" ""
    "SOURCES;ROOMS;LIBRARIES;PUBLIC_LIBRARIES;PUBLIC_HEADERS")
  set(include_dir ${PROJECT_BINARY_DIR}/rooms/${name})
  file(MAKE_DIRECTORY ${include_dir}/mjforge)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_dir}/mjforge/${name} SYMBOLIC)

  add_library(mjforge_${name} STATIC ${room_SOURCES})
  set_property(GLOBAL APPEND PROPERTY mjforge_rooms mjforge_${name})
  add_library(mjforge::${name} ALIAS mjforge_${name})
  set_target_properties(mjforge_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(mjforge_${name} PUBLIC cxx_std_20)
  target_include_directories(mjforge_${name} PUBLIC
    $<BUILD_INTERFACE:${include_dir}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM room_ROOMS PREPEND mjforge::)
  # Our options come first, so that the options of libraries can override them.
  target_link_libraries(mjforge_${name}
    PRIVATE $<BUILD_INTERFACE:mjforge_options> $<BUILD_INTERFACE:mjforge_watched>)
  target_link_libraries(mjforge_${name}
    PUBLIC ${room_ROOMS} ${room_PUBLIC_LIBRARIES} PRIVATE ${room_LIBRARIES})

  mjforge_precompile_from(mjforge_${name} mjforge_precompiled)
  set_target_properties(mjforge_${name} PROPERTIES UNITY_BUILD ${MJFORGE_UNITY}
    POSITION_INDEPENDENT_CODE ${MJFORGE_PYTHON})  # for the shared library of the Python package

  install(TARGETS mjforge_${name} EXPORT mjforge_targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
  install(FILES ${room_PUBLIC_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mjforge/${name}
          COMPONENT library)
endfunction()

# mjforge_embed(VARIABLE NAMESPACE ... FILES ...)
#
# Embeds files of the room in the program (cmake/EmbedTexts.cmake). Sets VARIABLE to the generated
# source file, which belongs in the room's SOURCES.
function(mjforge_embed variable)
  cmake_parse_arguments(PARSE_ARGV 1 embed "" "NAMESPACE" "FILES")
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded.cc)
  list(TRANSFORM embed_FILES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${output} -D NAMESPACE=${embed_NAMESPACE}
      "-DFILES=${embed_FILES}" -P ${PROJECT_SOURCE_DIR}/cmake/EmbedTexts.cmake
    DEPENDS ${embed_FILES} ${PROJECT_SOURCE_DIR}/cmake/EmbedTexts.cmake
    VERBATIM)
  # Not part of a unity build, so that clang-tidy does not need the generated file.
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(${variable} ${output} PARENT_SCOPE)
endfunction()
