pennon_test(test_grid LABEL unit
            SOURCES unit/dns/grid/o_grid.cpp unit/dns/numerics/separable_solver.cpp unit/dns/numerics/anderson.cpp
                    unit/dns/grid/elliptic_grid.cpp unit/dns/grid/metrics.cpp unit/dns/grid/scratch.cpp
            LINK pennon::dns_run)
pennon_test(test_grid_shapes LABEL verification SOURCES verification/dns/grid/shapes.cpp
            LINK pennon::dns_run)
# In a program of its own: it takes the place of malloc.
pennon_test(test_grid_allocations LABEL unit SOURCES unit/dns/grid/allocations.cpp LINK pennon::dns_run)
