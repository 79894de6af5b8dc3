# Not tests: these draw the pictures of docs/accuracy.md, and keep what a run said under
# data/reference/pennon/runs.
function(pennon_tool name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(${name} support/${name}.cpp)
  target_link_libraries(${name} PRIVATE pennon_test_support ${ARG_LINK})
endfunction()

pennon_tool(lsa_error_picture LINK pennon::lsa pennon::analysis_figures)
pennon_tool(fluid_pictures LINK pennon::analysis_figures)
pennon_tool(coupled_pictures LINK pennon::analysis_figures pennon::lsa)
pennon_tool(keep_run LINK pennon::common_case pennon::common_io pennon::common_record)

# By hand: tests/support/try_robustness.sh PENNON FOREIGN_FILES.
if(PENNON_VALIDATION)
  add_test(NAME Robustness.HoldsByClass
           COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/support/try_robustness.sh $<TARGET_FILE:pennon>
                   $<TARGET_FILE:test_foreign_files>)
  set_tests_properties(Robustness.HoldsByClass PROPERTIES LABELS validation TIMEOUT 3600)
endif()
