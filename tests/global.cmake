# The global modes, with PETSc's real numbers.
pennon_test(test_global
  SOURCES
    unit/modes/global/equations/parts.cpp
    unit/modes/global/map/reduced_map.cpp
    unit/modes/global/matrix_free/map_eigenpairs.cpp
    unit/modes/global/neutral/neutral.cpp
    unit/modes/global/solve/spectrum.cpp
    unit/modes/global/study/both_signs.cpp
    unit/modes/global/study/fields.cpp
    unit/modes/global/study/mode_kinds.cpp
    unit/modes/global/study/neutral_curve.cpp
    unit/modes/global/study/reports.cpp
    unit/modes/global/study/wire.cpp
  SEPARATE
    unit/modes/global/neutral/neutral.cpp
    unit/modes/global/solve/spectrum.cpp
    unit/modes/global/study/fields.cpp
    unit/modes/global/study/mode_kinds.cpp
    unit/modes/global/study/neutral_curve.cpp
  LINK pennon::modes_global_matrix_free pennon::modes_normal Boost::headers GTest::gmock)
pennon_test(test_global_verification
  SOURCES
    verification/modes/global/base_flow.cpp
    verification/modes/global/growth.cpp
    verification/modes/global/propagator.cpp
  LINK pennon::modes_global_matrix_free pennon::modes_normal pennon::dns_run)
pennon_test(test_global_validation
  SOURCES
    validation/modes/global/cases.cpp
    validation/modes/global/neutral.cpp
  LINK pennon::modes_global_matrix_free pennon::dns_run)

# In programs of their own: PETSc with complex numbers.
pennon_test(test_global_eigensolver
  SOURCES
    unit/modes/global/solve/slepc/krylov_schur.cpp
  LINK pennon::modes_global_study pennon::modes_global_solve_slepc)
pennon_test(test_global_eigensolver_verification
  SOURCES
    verification/modes/global/still_fluid.cpp
  LINK pennon::modes_global_study pennon::modes_global_solve_slepc)
