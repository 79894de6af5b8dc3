pennon_test(test_app LABEL regression SOURCES regression/app_commands.cpp
            LINK pennon::common Boost::headers GTest::gmock)
target_compile_definitions(test_app PRIVATE PENNON_EXECUTABLE="$<TARGET_FILE:pennon>")
add_dependencies(test_app pennon)
