# Checks the style and finds defects: cmake -D BUILD_DIR=build-lint -P cmake/lint.cmake
#
# clang-format over every file, then clang-tidy, two at a time, over every source that is not known to
# pass. cmake/lint.passed lists those that are: a hash for each, over the source, the headers of the
# project that it includes, the checks, and clang-tidy's version. Only a source that passed enters the
# list, at once; the list is committed with the change, so that a fresh clone checks what is new and no
# more. That was chosen over a faster check of everything: clang-tidy 14 searches all of the standard
# library and of Eigen again for each source, which takes some 10 minutes on two cores for all. Where two
# branches change the list, git keeps the lines of both (.gitattributes); a line too many does no harm,
# for a hash that belongs to no source is dropped.
#
# Some checks run with -D DEEP=ON only, which knows no list and looks at every source. The static analyzer
# takes three times as long as all other checks together, the search for parameters that are copied in
# vain up to as long as they. The others in `deep_checks` take a fifth together and find what the code
# has no occasion for (C strings, macros) or what the compiler's own warnings say.
cmake_minimum_required(VERSION 3.25)

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source_dir)
cmake_path(ABSOLUTE_PATH BUILD_DIR BASE_DIRECTORY ${source_dir})
set(scratch_dir ${BUILD_DIR}/lint)
set(passed_file ${CMAKE_CURRENT_LIST_DIR}/lint.passed)
set(deep_checks
    clang-analyzer-*
    performance-unnecessary-value-param
    bugprone-assert-side-effect
    bugprone-misplaced-widening-cast
    bugprone-multiple-statement-macro
    bugprone-not-null-terminated-result
    bugprone-reserved-identifier
    bugprone-signed-char-misuse
    bugprone-sizeof-expression
    bugprone-stringview-nullptr
    bugprone-suspicious-semicolon
    bugprone-suspicious-string-compare
    modernize-use-nullptr
    readability-redundant-control-flow
    readability-redundant-declaration)
set(checks "")
if(NOT DEEP)
  list(TRANSFORM deep_checks PREPEND "-" OUTPUT_VARIABLE checks)
  list(JOIN checks "," checks)
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

execute_process(COMMAND clang-tidy --version OUTPUT_VARIABLE tidy_version COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "version [0-9.]+" tidy_version "${tidy_version}")

# Changes whenever what clang-tidy would see of the project changes.
function(lint_key source result)
  included_headers(${source} included)
  set(hashes "${checks}${tidy_version}")
  foreach(file IN LISTS included ITEMS .clang-tidy ${source})
    file(SHA256 ${source_dir}/${file} hash)
    string(APPEND hashes ${file}${hash})
  endforeach()
  string(SHA256 key "${hashes}")
  set(${result} ${key} PARENT_SCOPE)
endfunction()

set(passed "")
if(EXISTS ${passed_file} AND NOT DEEP)
  file(STRINGS ${passed_file} passed)
endif()
file(MAKE_DIRECTORY ${scratch_dir})
set(entries "")
set(unseen "")
set(unseen_count 0)
foreach(source IN LISTS sources)
  lint_key(${source} key)
  set(entry "${source} ${key}")
  list(APPEND entries ${entry})
  # A file in scratch_dir is what an interrupted run left of a source that passed.
  if(NOT (entry IN_LIST passed OR EXISTS ${scratch_dir}/${key}))
    string(APPEND unseen "${source}\n${scratch_dir}/${key}\n")
    math(EXPR unseen_count "${unseen_count} + 1")
  endif()
endforeach()

# Writes the list: the sources that passed, now or before, as they are.
function(keep_passed)
  set(lines "")
  foreach(entry IN LISTS entries)
    string(REGEX REPLACE ".* " "" key "${entry}")
    if(entry IN_LIST passed OR EXISTS ${scratch_dir}/${key})
      list(APPEND lines "${entry}")
    endif()
  endforeach()
  list(SORT lines)
  list(JOIN lines "\n" text)
  set(before "")
  if(EXISTS ${passed_file})
    file(READ ${passed_file} before)
  endif()
  if(NOT before STREQUAL "${text}\n")
    file(WRITE ${passed_file} "${text}\n")
  endif()
endfunction()

message(STATUS "clang-tidy on ${unseen_count} sources")
file(WRITE ${scratch_dir}/unseen "${unseen}")
# $0: the source, $1: the file that says that it passed.
set(tidy "clang-tidy --quiet --checks='${checks}' -p '${BUILD_DIR}' \"$0\"")
execute_process(
  COMMAND xargs --no-run-if-empty --max-procs=2 --max-args=2 --delimiter=\\n
          sh -c "if ${tidy} 2>\"$1.log\"; then mv \"$1.log\" \"$1\"; else grep -v ' generated' \"$1.log\"; exit 1; fi"
  INPUT_FILE ${scratch_dir}/unseen WORKING_DIRECTORY ${source_dir} RESULT_VARIABLE status)
if(NOT DEEP)
  keep_passed()
endif()
file(REMOVE_RECURSE ${scratch_dir})
if(NOT status EQUAL 0)
  message(FATAL_ERROR "clang-tidy found the defects above")
endif()
message(STATUS "lint passed")
