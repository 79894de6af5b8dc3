# Checks the style and finds defects: cmake -D BUILD_DIR=build -P cmake/lint.cmake
#
# clang-format over every file, then clang-tidy over every source, two at a time. A source that was
# found clean is not looked at again until it, a header of the project it includes, or the list of
# checks changes. The static analyzer takes three times as long as all other checks together, the
# search for parameters that are copied in vain up to as long as they, and two more a fifth of what is
# left; these run with -D DEEP=ON only.
cmake_minimum_required(VERSION 3.25)

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source_dir)
cmake_path(ABSOLUTE_PATH BUILD_DIR BASE_DIRECTORY ${source_dir})
set(stamp_dir ${BUILD_DIR}/lint)
set(checks "")
if(NOT DEEP)
  string(JOIN "," checks -clang-analyzer-* -performance-unnecessary-value-param
         -bugprone-reserved-identifier -bugprone-stringview-nullptr)
endif()

file(GLOB_RECURSE headers RELATIVE ${source_dir} ${source_dir}/*/*.hpp)
file(GLOB_RECURSE sources RELATIVE ${source_dir} ${source_dir}/*/*.cpp)
list(FILTER headers EXCLUDE REGEX "^build")
list(FILTER sources EXCLUDE REGEX "^build")
if(NOT EXISTS ${BUILD_DIR}/compile_commands.json)
  message(FATAL_ERROR "${BUILD_DIR} has no compile_commands.json: configure it first")
endif()

message(STATUS "clang-format")
execute_process(COMMAND clang-format --dry-run -Werror ${headers} ${sources}
                WORKING_DIRECTORY ${source_dir} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "clang-format would change the lines above: run clang-format -i on the files")
endif()

# The project's headers a file includes, directly and through others.
function(included_headers file result)
  set(found "")
  set(open ${file})
  while(open)
    list(POP_FRONT open next)
    file(STRINGS ${source_dir}/${next} includes REGEX "^#include \"")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" header "${include}")
      if(header IN_LIST headers AND NOT header IN_LIST found)
        list(APPEND found ${header})
        list(APPEND open ${header})
      endif()
    endforeach()
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# Changes whenever what clang-tidy would see of the project changes.
function(lint_key source result)
  included_headers(${source} included)
  set(hashes "${checks}")
  foreach(file IN LISTS included ITEMS .clang-tidy ${source})
    file(SHA256 ${source_dir}/${file} hash)
    string(APPEND hashes ${file}${hash})
  endforeach()
  string(SHA256 key "${hashes}")
  set(${result} ${key} PARENT_SCOPE)
endfunction()

file(MAKE_DIRECTORY ${stamp_dir})
set(unseen "")
set(unseen_count 0)
foreach(source IN LISTS sources)
  lint_key(${source} key)
  if(NOT EXISTS ${stamp_dir}/${key})
    string(APPEND unseen "${source}\n${stamp_dir}/${key}\n")
    math(EXPR unseen_count "${unseen_count} + 1")
  endif()
endforeach()

message(STATUS "clang-tidy on ${unseen_count} sources")
file(WRITE ${stamp_dir}/unseen "${unseen}")
set(tidy "clang-tidy --quiet --checks='${checks}' -p '${BUILD_DIR}' \"$0\"")
execute_process(
  COMMAND xargs --no-run-if-empty --max-procs=2 --max-args=2 --delimiter=\\n
          sh -c "if ${tidy} 2>\"$1.log\"; then mv \"$1.log\" \"$1\"; else grep -v ' generated' \"$1.log\"; exit 1; fi"
  INPUT_FILE ${stamp_dir}/unseen WORKING_DIRECTORY ${source_dir} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "clang-tidy found the defects above")
endif()
message(STATUS "lint passed")
