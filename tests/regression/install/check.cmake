# Installs pennon into an empty prefix and uses it from there, as another project and as a user:
# cmake -D BUILD_DIR=... -D SOURCE_DIR=... -D WORK_DIR=... -P check.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK_DIR})
set(prefix ${WORK_DIR}/prefix)

# Runs a command; stops the test where it fails or, after EXPECT, does not say this.
function(run)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "EXPECT" "COMMAND")
  execute_process(COMMAND ${ARG_COMMAND} WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE status
                  OUTPUT_VARIABLE said ERROR_VARIABLE said)
  list(JOIN ARG_COMMAND " " shown)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${shown}\nended with ${status}:\n${said}")
  endif()
  if(ARG_EXPECT AND NOT said MATCHES "${ARG_EXPECT}")
    message(FATAL_ERROR "${shown}\nshould say ${ARG_EXPECT}, but said:\n${said}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${WORK_DIR})
run(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})

set(second ${CMAKE_CURRENT_LIST_DIR}/second_project)
run(COMMAND ${CMAKE_COMMAND} -S ${second} -B ${WORK_DIR}/second -G Ninja -D CMAKE_PREFIX_PATH=${prefix}
            -D CMAKE_BUILD_TYPE=Debug)
run(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/second)
run(COMMAND ${WORK_DIR}/second/second_project)

# The headers come from the prefix, not from the checkout.
file(READ ${WORK_DIR}/second/build.ninja commands)
string(FIND "${commands}" "${prefix}/include/pennon" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the second project is not compiled with ${prefix}/include/pennon")
endif()
string(REPLACE "${WORK_DIR}" "" commands "${commands}")
string(REPLACE "${second}" "" commands "${commands}")
string(FIND "${commands}" "-I${SOURCE_DIR}" place)
string(FIND "${commands}" "-isystem ${SOURCE_DIR}" system_place)
if(NOT place EQUAL -1 OR NOT system_place EQUAL -1)
  message(FATAL_ERROR "the second project is compiled with headers of ${SOURCE_DIR}")
endif()

# The programs, through a symbolic link: pennon finds pennon-global beside itself.
file(CREATE_LINK ${prefix}/bin/pennon ${WORK_DIR}/pennon SYMBOLIC)
run(COMMAND ${WORK_DIR}/pennon --version EXPECT "^pennon [0-9]+\\.[0-9]+")
run(COMMAND ${WORK_DIR}/pennon lsa ${SOURCE_DIR}/data/cases/table1/C2D.toml --output lsa --json
    EXPECT "growth")
run(COMMAND ${WORK_DIR}/pennon modes ${SOURCE_DIR}/data/cases/modes/global.toml --output modes --quiet
            --set modes.global.n_rho=16 --set modes.global.n_theta=32)
if(NOT EXISTS ${WORK_DIR}/modes/global_modes.json)
  message(FATAL_ERROR "the installed pennon wrote no global modes")
endif()

# The completion knows the commands; the manual page has every section.
run(COMMAND bash -c "source '${prefix}/share/bash-completion/completions/pennon'; COMP_WORDS=(pennon l); COMP_CWORD=1; _pennon; echo \${COMPREPLY[*]}"
    EXPECT "^lsa\n$")
file(READ ${prefix}/share/man/man1/pennon.1 page)
foreach(section NAME SYNOPSIS OPTIONS COMMANDS "EXIT STATUS")
  if(NOT page MATCHES "\n\\.SH ${section}\n")
    message(FATAL_ERROR "the manual page has no section ${section}")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK_DIR})
