pennon_test(test_lsa_studies LABEL unit SOURCES unit/lsa/studies.cpp LINK pennon::lsa)
pennon_test(test_lsa_theory LABEL verification
            SOURCES verification/lsa/theory.cpp verification/lsa/added_mass.cpp LINK pennon::lsa)
pennon_test(test_lsa_accuracy LABEL verification SOURCES verification/lsa/accuracy.cpp LINK pennon::lsa)

# Not a test: draws the pictures of docs/accuracy.md.
add_executable(lsa_error_picture support/lsa_error_picture.cpp)
target_link_libraries(lsa_error_picture PRIVATE pennon::lsa pennon::analysis_figures)
