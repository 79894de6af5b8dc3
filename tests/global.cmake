pennon_test(test_global_parts LABEL unit SOURCES unit/global_parts.cpp
            LINK pennon::global pennon::modes)
pennon_test(test_global_fields LABEL unit SOURCES unit/global_fields.cpp LINK pennon::global)
pennon_test(test_global_still_fluid LABEL verification
            SOURCES verification/global_still_fluid.cpp LINK pennon::eigensolver)
pennon_test(test_global_neutral LABEL unit
            SOURCES unit/global_neutral.cpp unit/global_neutral_curve.cpp unit/global_reduced_map.cpp unit/global_both_signs.cpp
            LINK pennon::global)
pennon_test(test_global_modes LABEL verification
            SOURCES verification/global_base_flow.cpp verification/global_growth.cpp
                    verification/global_propagator.cpp
            LINK pennon::global pennon::modes pennon::dns)
# In a program of its own: PETSc with complex numbers.
pennon_test(test_global_eigensolver LABEL unit SOURCES unit/global_eigensolver.cpp
            LINK pennon::eigensolver)
pennon_test(test_global_validation LABEL validation
            SOURCES validation/global_cases.cpp validation/global_neutral.cpp
            LINK pennon::global pennon::dns)
