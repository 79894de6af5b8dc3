pennon_test(test_modes LABEL unit
  SOURCES
    unit/modes_bessel_zero.cpp
    unit/modes_decomposition.cpp
    unit/modes_families.cpp
    unit/modes_generalised_eigenproblem.cpp
    unit/modes_initial_shape.cpp
    unit/modes_map_eigenpairs.cpp
    unit/modes_settings.cpp
    unit/modes_spline_space.cpp
    unit/modes_study.cpp
  LINK pennon::modes Boost::headers GTest::gmock)
pennon_test(test_modes_in_vacuo LABEL verification
  SOURCES verification/modes_in_vacuo.cpp verification/modes_second_methods.cpp
  LINK pennon::modes Boost::headers)
pennon_test(test_modes_bessel_table LABEL validation
  SOURCES verification/modes_bessel_table.cpp LINK pennon::modes Boost::headers)
