pennon_test(test_lsa_studies LABEL unit SOURCES unit/lsa_studies.cpp LINK pennon::lsa)
pennon_test(test_lsa_theory LABEL verification
            SOURCES verification/lsa_theory.cpp verification/lsa_added_mass.cpp LINK pennon::lsa)
pennon_test(test_lsa_accuracy LABEL verification SOURCES verification/lsa_accuracy.cpp LINK pennon::lsa)
