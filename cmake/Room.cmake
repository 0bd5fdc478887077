# mjforge_room(NAME SOURCES ... ROOMS ... LIBRARIES ...)
#
# A room is one stage of the data flow, one static library. It sees the headers
# of the rooms in ROOMS and of no other: each room's include directory holds
# only that room, so an include against the flow does not compile.
# LIBRARIES stay private to the room; PUBLIC_LIBRARIES appear in its door.
# PUBLIC_HEADERS are the door and what it includes; only they are installed.
function(mjforge_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "" ""
    "SOURCES;ROOMS;LIBRARIES;PUBLIC_LIBRARIES;PUBLIC_HEADERS")
  set(include_dir ${PROJECT_BINARY_DIR}/rooms/${name})
  file(MAKE_DIRECTORY ${include_dir}/mjforge)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_dir}/mjforge/${name} SYMBOLIC)

  add_library(mjforge_${name} STATIC ${room_SOURCES})
  add_library(mjforge::${name} ALIAS mjforge_${name})
  set_target_properties(mjforge_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(mjforge_${name} PUBLIC cxx_std_20)
  target_include_directories(mjforge_${name} PUBLIC
    $<BUILD_INTERFACE:${include_dir}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM room_ROOMS PREPEND mjforge::)
  target_link_libraries(mjforge_${name}
    PUBLIC ${room_ROOMS} ${room_PUBLIC_LIBRARIES}
    PRIVATE ${room_LIBRARIES} $<BUILD_INTERFACE:mjforge_options> $<BUILD_INTERFACE:mjforge_watched>)

  mjforge_precompile_room(mjforge_${name})
  set_target_properties(mjforge_${name} PROPERTIES UNITY_BUILD ${MJFORGE_UNITY})

  install(TARGETS mjforge_${name} EXPORT mjforge_targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(FILES ${room_PUBLIC_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mjforge/${name})
endfunction()
