pennon_test(test_flag LABEL unit
            SOURCES unit/flag_forces.cpp unit/flag_frequency.cpp unit/flag_initial_shape.cpp
                    unit/flag_tangent_matrix.cpp
            LINK pennon::dns)
# In a program of its own: it takes the place of malloc.
pennon_test(test_flag_allocations LABEL unit SOURCES unit/flag_allocations.cpp LINK pennon::dns)
pennon_test(test_flag_validation LABEL verification
            SOURCES verification/flag_plates.cpp verification/flag_lines.cpp
                    verification/flag_extremes.cpp verification/flag_in_vacuo.cpp
            LINK pennon::dns pennon::modes)
pennon_test(test_fluid_verification LABEL verification
            SOURCES verification/fluid_manufactured.cpp verification/fluid_budgets.cpp
                    verification/fluid_identities.cpp verification/fluid_potential.cpp
                    verification/fluid_plate.cpp verification/fluid_outflow.cpp
                    verification/fluid_extremes.cpp
            LINK pennon::dns pennon::lsa)
pennon_test(test_fluid_validation LABEL validation
            SOURCES validation/fluid_plate_drag.cpp validation/fluid_theodorsen.cpp
                    validation/fluid_large_grid.cpp
            LINK pennon::dns)
pennon_test(test_fluid LABEL unit SOURCES unit/span.cpp unit/fluid_parts.cpp LINK pennon::dns)

# Not tests: these draw pictures of docs/accuracy.md.
add_executable(fluid_pictures support/fluid_pictures.cpp)
target_link_libraries(fluid_pictures PRIVATE pennon_options pennon::analysis)
add_executable(coupled_pictures support/coupled_pictures.cpp)
target_link_libraries(coupled_pictures PRIVATE pennon_options pennon::analysis pennon::lsa)
# Not a test: keeps what a run said under data/reference/pennon/runs.
add_executable(keep_run support/keep_run.cpp)
target_link_libraries(keep_run PRIVATE pennon_options pennon::common)
pennon_test(test_coupling LABEL verification
            SOURCES unit/added_mass.cpp verification/coupling.cpp LINK pennon::dns)
