pennon_test(test_global_parts LABEL unit SOURCES unit/modes/global/equations/parts.cpp
            LINK pennon::modes_global_matrix_free pennon::modes_normal)
pennon_test(test_map_eigenpairs LABEL unit SOURCES unit/modes/global/matrix_free/map_eigenpairs.cpp
            LINK pennon::modes_global_matrix_free Boost::headers)
pennon_test(test_global_fields LABEL unit SOURCES unit/modes/global/study/fields.cpp LINK pennon::modes_global_matrix_free)
pennon_test(test_global_reports LABEL unit SOURCES unit/modes/global/study/reports.cpp unit/modes/global/study/wire.cpp
            LINK pennon::modes_global_study GTest::gmock)
pennon_test(test_global_still_fluid LABEL verification
            SOURCES verification/modes/global/still_fluid.cpp LINK pennon::modes_global_study pennon::modes_global_solve_slepc)
pennon_test(test_global_neutral LABEL unit
            SOURCES unit/modes/global/neutral/neutral.cpp unit/modes/global/study/neutral_curve.cpp unit/modes/global/map/reduced_map.cpp unit/modes/global/study/both_signs.cpp
            LINK pennon::modes_global_matrix_free)
pennon_test(test_global_modes LABEL verification
            SOURCES verification/modes/global/base_flow.cpp verification/modes/global/growth.cpp
                    verification/modes/global/propagator.cpp
            LINK pennon::modes_global_matrix_free pennon::modes_normal pennon::dns_run)
# In a program of its own: PETSc with complex numbers.
pennon_test(test_global_eigensolver LABEL unit SOURCES unit/modes/global/solve/eigensolver.cpp
            LINK pennon::modes_global_study pennon::modes_global_solve_slepc)
pennon_test(test_global_validation LABEL validation
            SOURCES validation/modes/global/cases.cpp validation/modes/global/neutral.cpp
            LINK pennon::modes_global_matrix_free pennon::dns_run)
