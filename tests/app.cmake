pennon_test(test_app LABEL regression
            SOURCES regression/app/analyze.cpp regression/app/checks.cpp regression/app/commands.cpp
                    regression/app/compare.cpp regression/app/coupled.cpp regression/app/fluid.cpp
                    regression/app/global.cpp regression/app/named_keys.cpp
            LINK pennon::analysis_figures Boost::headers GTest::gmock)
target_compile_definitions(test_app PRIVATE PENNON_EXECUTABLE="$<TARGET_FILE:pennon>"
                           PENNON_MPIEXEC="${MPIEXEC_EXECUTABLE}")
add_dependencies(test_app pennon)
pennon_test(test_coupled_validation LABEL validation SOURCES validation/dns/coupling/coupled_cases.cpp
                    validation/app/compare_table1.cpp validation/modes/global/convergence.cpp
            LINK pennon::common_case pennon::common_io pennon::common_record fmt::fmt Boost::headers GTest::gmock)
target_compile_definitions(test_coupled_validation
                           PRIVATE PENNON_EXECUTABLE="$<TARGET_FILE:pennon>"
                                   PENNON_MPIEXEC="${MPIEXEC_EXECUTABLE}")
add_dependencies(test_coupled_validation pennon)
