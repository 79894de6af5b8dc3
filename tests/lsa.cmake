pennon_test(test_lsa
  SOURCES
    unit/lsa/studies.cpp
  LINK pennon::lsa)
pennon_test(test_lsa_verification
  SOURCES
    verification/lsa/accuracy.cpp
    verification/lsa/added_mass.cpp
    verification/lsa/theory.cpp
  SEPARATE
    verification/lsa/theory.cpp
  LINK pennon::lsa)
