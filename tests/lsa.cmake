pennon_test(test_lsa_studies LABEL unit SOURCES unit/lsa_studies.cpp LINK pennon::lsa)
pennon_test(test_lsa_theory LABEL verification
            SOURCES verification/lsa_theory.cpp verification/lsa_added_mass.cpp LINK pennon::lsa)
pennon_test(test_lsa_accuracy LABEL verification SOURCES verification/lsa_accuracy.cpp LINK pennon::lsa)

# Not a test: draws the pictures of docs/accuracy.md.
add_executable(lsa_error_picture support/lsa_error_picture.cpp)
target_link_libraries(lsa_error_picture PRIVATE pennon::lsa pennon::analysis)
