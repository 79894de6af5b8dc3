pennon_test(test_flag LABEL unit
            SOURCES unit/dns/flag/forces.cpp unit/dns/flag/frequency.cpp unit/dns/run/initial_shape.cpp
                    unit/dns/flag/tangent_matrix.cpp unit/dns/flag/material.cpp
            LINK pennon::dns_run)
# In a program of its own: it takes the place of malloc.
pennon_test(test_flag_allocations LABEL unit SOURCES unit/dns/flag/allocations.cpp LINK pennon::dns_run)
pennon_test(test_runs LABEL unit
            SOURCES unit/dns/run/settings.cpp unit/dns/run/state_file.cpp
                    unit/dns/run/step_control.cpp
            LINK pennon::dns_run GTest::gmock)
pennon_test(test_flag_validation LABEL verification
            SOURCES verification/dns/flag/plates.cpp verification/dns/flag/lines.cpp
                    verification/dns/flag/extremes.cpp verification/dns/flag/in_vacuo.cpp
            LINK pennon::dns_run pennon::modes_normal)
pennon_test(test_fluid_verification LABEL verification
            SOURCES verification/dns/fluid/manufactured.cpp verification/dns/fluid/budgets.cpp
                    verification/dns/fluid/identities.cpp verification/dns/fluid/potential.cpp
                    verification/dns/fluid/plate.cpp verification/dns/fluid/outflow.cpp
                    verification/dns/fluid/extremes.cpp
            LINK pennon::dns_run pennon::lsa)
pennon_test(test_fluid_validation LABEL validation
            SOURCES validation/dns/fluid/plate_drag.cpp validation/dns/fluid/theodorsen.cpp
                    validation/dns/fluid/large_grid.cpp
            LINK pennon::dns_run)
pennon_test(test_fluid LABEL unit SOURCES unit/dns/grid/span.cpp unit/dns/fluid/parts.cpp LINK pennon::dns_run)

# Not tests: these draw pictures of docs/accuracy.md.
add_executable(fluid_pictures support/fluid_pictures.cpp)
target_link_libraries(fluid_pictures PRIVATE pennon_test_support pennon::analysis_figures)
add_executable(coupled_pictures support/coupled_pictures.cpp)
target_link_libraries(coupled_pictures PRIVATE pennon_test_support pennon::analysis_figures pennon::lsa)
# Not a test: keeps what a run said under data/reference/pennon/runs.
add_executable(keep_run support/keep_run.cpp)
target_link_libraries(keep_run PRIVATE pennon_test_support pennon::common_case pennon::common_io pennon::common_record)
pennon_test(test_added_mass LABEL unit SOURCES unit/dns/coupling/added_mass.cpp LINK pennon::dns_run)
pennon_test(test_coupling LABEL verification SOURCES verification/dns/coupling/coupling.cpp
            LINK pennon::dns_run)
