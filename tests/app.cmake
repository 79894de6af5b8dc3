pennon_test(test_app LABEL regression
            SOURCES regression/app_analyze.cpp regression/app_commands.cpp regression/app_compare.cpp
                    regression/app_coupled.cpp                     regression/app_fluid.cpp regression/app_global.cpp
            LINK pennon::analysis Boost::headers GTest::gmock)
target_compile_definitions(test_app PRIVATE PENNON_EXECUTABLE="$<TARGET_FILE:pennon>"
                           PENNON_MPIEXEC="${MPIEXEC_EXECUTABLE}")
add_dependencies(test_app pennon)
pennon_test(test_coupled_validation LABEL validation SOURCES validation/coupled_cases.cpp
                    validation/compare_table1.cpp validation/global_convergence.cpp
            LINK pennon::common fmt::fmt Boost::headers GTest::gmock)
target_compile_definitions(test_coupled_validation
                           PRIVATE PENNON_EXECUTABLE="$<TARGET_FILE:pennon>"
                                   PENNON_MPIEXEC="${MPIEXEC_EXECUTABLE}")
add_dependencies(test_coupled_validation pennon)
