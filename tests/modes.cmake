# The normal modes.
pennon_test(test_modes
  SOURCES
    unit/modes/normal/bessel_zero.cpp
    unit/modes/normal/decomposition.cpp
    unit/modes/normal/families.cpp
    unit/modes/normal/generalised_eigenproblem.cpp
    unit/modes/normal/initial_shape.cpp
    unit/modes/normal/settings.cpp
    unit/modes/normal/spline_space.cpp
    unit/modes/normal/study.cpp
  SEPARATE
    unit/modes/normal/families.cpp
    unit/modes/normal/generalised_eigenproblem.cpp
    unit/modes/normal/initial_shape.cpp
    unit/modes/normal/spline_space.cpp
    unit/modes/normal/study.cpp
  LINK pennon::modes_normal Boost::headers GTest::gmock)
pennon_test(test_modes_verification
  SOURCES
    verification/modes/normal/in_vacuo.cpp
    verification/modes/normal/second_methods.cpp
  SEPARATE
    verification/modes/normal/second_methods.cpp
  LINK pennon::modes_normal Boost::headers)
pennon_test(test_modes_validation
  SOURCES
    validation/modes/normal/bessel_table.cpp
  LINK pennon::modes_normal Boost::headers)
