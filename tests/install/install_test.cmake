# Installs the project, moves the installed files, builds a program that links them, and runs this
# program and the command in an empty folder. CMakeLists.txt sets the variables.

# run(COMMAND...): leaves standard output in `output`; ends the test if it fails.
function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${work_folder}/empty
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE words)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}: status ${status}\n${output}${words}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_file path)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "${path} is missing")
  endif()
endfunction()

file(REMOVE_RECURSE ${work_folder})
file(MAKE_DIRECTORY ${work_folder}/empty)

# Moved, because installed files must not depend on the folders of the build or of the installation.
run(${CMAKE_COMMAND} --install ${build_folder} --prefix ${work_folder}/first)
file(RENAME ${work_folder}/first ${work_folder}/prefix)
set(program ${work_folder}/prefix/bin/mjforge)
# A private MuJoCo is excluded, because its path is part of the program.
if(build_type STREQUAL Release AND NOT mujoco)
  file(READ ${program} bytes HEX)
  string(HEX ${source_folder} folder_bytes)
  string(FIND "${bytes}" ${folder_bytes} place)
  if(NOT place EQUAL -1)
    message(FATAL_ERROR "the installed program names ${source_folder}")
  endif()
endif()
foreach(file specs/tools/hammer.yaml schemas/object.schema.json
  schemas/manifest.schema.json schemas/placement.schema.json)
  expect_file(${work_folder}/prefix/share/mjforge/${file})
endforeach()
foreach(file LICENSE README.md CHANGELOG.md manual.md errors.md architecture.md make.md
    examples/make/Makefile)
  expect_file(${work_folder}/prefix/share/doc/mjforge/${file})
endforeach()
foreach(file man/man1/mjforge.1 man/man1/mjforge-generate.1 bash-completion/completions/mjforge
    zsh/site-functions/_mjforge fish/vendor_completions.d/mjforge.fish)
  expect_file(${work_folder}/prefix/share/${file})
endforeach()

# Uses only the files of the project shown in docs/install.md.
file(READ ${source_folder}/docs/install.md page)
foreach(file CMakeLists.txt main.cc)
  string(REGEX MATCH "\n```[a-z]+\n[#/]+ file: (${file}\n.*)" rest "${page}")
  if(NOT rest)
    message(FATAL_ERROR "install.md shows no ${file}")
  endif()
  string(REGEX REPLACE "^${file}\n" "" code "${CMAKE_MATCH_1}")
  string(FIND "${code}" "\n```" end)
  string(SUBSTRING "${code}" 0 ${end} code)
  file(WRITE ${work_folder}/hammer/${file} "${code}\n")
endforeach()
run(${CMAKE_COMMAND} -S ${work_folder}/hammer -B ${work_folder}/hammer/build
  -G ${generator} -D CMAKE_PREFIX_PATH=${work_folder}/prefix -D CMAKE_CXX_COMPILER=${compiler}
  -D CMAKE_BUILD_TYPE=${build_type} -D CMAKE_CXX_FLAGS=${flags} -D MJFORGE_MUJOCO=${mujoco})
run(${CMAKE_COMMAND} --build ${work_folder}/hammer/build)
run(${work_folder}/hammer/build/hammer)
set(of_library "${output}")
run(${program} generate hammer --seed 7 --first 41 -n 1 -o -)
if(NOT output MATCHES "<mujoco model=\"hammer\">" OR NOT output STREQUAL of_library)
  message(FATAL_ERROR "library and program differ:\n${of_library}\n${output}")
endif()

run(${program} generate hammer -n 2 --seed 7 -o hammers)
foreach(file hammer_000000.xml hammer_000001.xml manifest.jsonl)
  expect_file(${work_folder}/empty/hammers/${file})
endforeach()
run(${program} catalogue)
if(NOT output MATCHES "tools/hammer")
  message(FATAL_ERROR "the installed catalogue has no hammer:\n${output}")
endif()
run(${program} --version)
if(NOT output MATCHES "^mjforge ${version}\n")
  message(FATAL_ERROR "not version ${version}:\n${output}")
endif()
file(REMOVE_RECURSE ${work_folder})
