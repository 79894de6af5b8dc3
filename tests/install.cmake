# What `cmake --install` leaves behind, used by another project and by a user; needs everything built.
add_test(NAME Installation.ServesASecondProjectAndAUser
         COMMAND ${CMAKE_COMMAND} -D BUILD_DIR=${PROJECT_BINARY_DIR} -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
                 -D WORK_DIR=${CMAKE_CURRENT_BINARY_DIR}/install
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/regression/install/check.cmake)
set_tests_properties(Installation.ServesASecondProjectAndAUser PROPERTIES LABELS regression TIMEOUT 1800
                     COST 1000) # of the longest: it should not be the last to begin
