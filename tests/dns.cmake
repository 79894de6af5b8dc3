# The grid, and the solvers that know nothing of flags and fluids.
pennon_test(test_grid
  SOURCES
    unit/dns/grid/elliptic_grid.cpp
    unit/dns/grid/metrics.cpp
    unit/dns/grid/o_grid.cpp
    unit/dns/grid/scratch.cpp
    unit/dns/grid/span.cpp
    unit/dns/numerics/anderson.cpp
    unit/dns/numerics/backward_difference.cpp
    unit/dns/numerics/separable_solver.cpp
  SEPARATE
    unit/dns/grid/metrics.cpp
    unit/dns/grid/o_grid.cpp
    unit/dns/numerics/separable_solver.cpp
  LINK pennon::dns_run)
# In a program of its own: it takes the place of malloc.
pennon_test(test_grid_allocations
  SOURCES
    unit/dns/grid/allocations.cpp
  LINK pennon::dns_run)
pennon_test(test_grid_verification
  SOURCES
    verification/dns/grid/shapes.cpp
  LINK pennon::dns_run)

# The flag by itself.
pennon_test(test_flag
  SOURCES
    unit/dns/flag/forces.cpp
    unit/dns/flag/frequency.cpp
    unit/dns/flag/material.cpp
    unit/dns/flag/tangent_matrix.cpp
    unit/dns/run/initial_shape.cpp
  SEPARATE
    unit/dns/flag/material.cpp
    unit/dns/flag/tangent_matrix.cpp
    unit/dns/run/initial_shape.cpp
  LINK pennon::dns_run)
# In a program of its own: it takes the place of malloc.
pennon_test(test_flag_allocations
  SOURCES
    unit/dns/flag/allocations.cpp
  LINK pennon::dns_run)
pennon_test(test_flag_verification
  SOURCES
    verification/dns/flag/extremes.cpp
    verification/dns/flag/in_vacuo.cpp
    verification/dns/flag/lines.cpp
    verification/dns/flag/plates.cpp
  LINK pennon::dns_run pennon::modes_normal)

# The fluid about a flag that moves as it is told.
pennon_test(test_fluid
  SOURCES
    unit/dns/fluid/convection.cpp
    unit/dns/fluid/parts.cpp
  LINK pennon::dns_run)
# In a program of its own: it takes the place of malloc.
pennon_test(test_fluid_allocations
  SOURCES
    unit/dns/fluid/allocations.cpp
  LINK pennon::dns_run)
pennon_test(test_fluid_verification
  SOURCES
    verification/dns/fluid/budgets.cpp
    verification/dns/fluid/extremes.cpp
    verification/dns/fluid/identities.cpp
    verification/dns/fluid/manufactured.cpp
    verification/dns/fluid/outflow.cpp
    verification/dns/fluid/plate.cpp
    verification/dns/fluid/potential.cpp
    verification/dns/fluid/span.cpp
    verification/dns/fluid/span_budgets.cpp
  SEPARATE
    verification/dns/fluid/budgets.cpp
    verification/dns/fluid/extremes.cpp
    verification/dns/fluid/identities.cpp
    verification/dns/fluid/manufactured.cpp
    verification/dns/fluid/outflow.cpp
    verification/dns/fluid/span_budgets.cpp
  LINK pennon::dns_run pennon::lsa)
pennon_test(test_fluid_validation
  SOURCES
    validation/dns/fluid/large_grid.cpp
    validation/dns/fluid/plate_drag.cpp
    validation/dns/fluid/theodorsen.cpp
  LINK pennon::dns_run)

# Flag and fluid together.
pennon_test(test_coupling
  SOURCES
    unit/dns/coupling/added_mass.cpp
  LINK pennon::dns_run)
# In a program of its own: it takes the place of malloc.
pennon_test(test_coupling_allocations
  SOURCES
    unit/dns/coupling/allocations.cpp
  LINK pennon::dns_run)
pennon_test(test_coupling_verification
  SOURCES
    verification/dns/coupling/coupling.cpp
    verification/dns/coupling/order.cpp
  LINK pennon::dns_run)

# Runs through time.
pennon_test(test_runs
  SOURCES
    unit/dns/run/history_records.cpp
    unit/dns/run/settings.cpp
    unit/dns/run/restart.cpp
    unit/dns/run/state_file.cpp
    unit/dns/run/step_control.cpp
  LINK pennon::dns_run GTest::gmock)
