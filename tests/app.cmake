# Both start pennon as a user does.
pennon_test(test_app
  SOURCES
    regression/app/analyze.cpp
    regression/app/checks.cpp
    regression/app/commands.cpp
    regression/app/compare.cpp
    regression/app/completion.cpp
    regression/app/coupled.cpp
    regression/app/decompose.cpp
    regression/app/fluid.cpp
    regression/app/folders.cpp
    regression/app/global.cpp
    regression/app/kept_history.cpp
    regression/app/long_step.cpp
    regression/app/named_keys.cpp
  LINK pennon::analysis_decomposition pennon::analysis_figures Boost::headers GTest::gmock)
pennon_test(test_app_validation
  SOURCES
    validation/analysis/decomposition_oracle.cpp
    validation/app/compare_table1.cpp
    validation/app/long_step.cpp
    validation/dns/coupling/coupled_cases.cpp
    validation/modes/global/convergence.cpp
  SEPARATE
    validation/modes/global/convergence.cpp
  LINK pennon::common_case pennon::common_io pennon::common_record pennon::analysis_decomposition fmt::fmt Boost::headers GTest::gmock)
# Files that others may have written, or damaged.
pennon_test(test_foreign_files
  SOURCES
    regression/app/foreign_files.cpp
    support/foreign_files.cpp
    support/hdf5_mutator.cpp
  LINK pennon::app GTest::gmock)
pennon_test(test_foreign_files_validation
  SOURCES
    validation/app/foreign_files.cpp
    support/foreign_files.cpp
    support/hdf5_mutator.cpp
  LINK pennon::app GTest::gmock)
foreach(program test_app test_app_validation test_foreign_files test_foreign_files_validation)
  if(NOT TARGET ${program})
    continue()
  endif()
  target_compile_definitions(${program} PRIVATE PENNON_EXECUTABLE="$<TARGET_FILE:pennon>"
                             PENNON_MPIEXEC="${MPIEXEC_EXECUTABLE}")
  add_dependencies(${program} pennon pennon-global)
endforeach()
