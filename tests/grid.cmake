pennon_test(test_grid LABEL unit
            SOURCES unit/o_grid.cpp unit/separable_solver.cpp unit/anderson.cpp
                    unit/elliptic_grid.cpp unit/metrics.cpp
            LINK pennon::dns)
pennon_test(test_grid_shapes LABEL verification SOURCES verification/grid_shapes.cpp
            LINK pennon::dns)
# In a program of its own: it takes the place of malloc.
pennon_test(test_grid_allocations LABEL unit SOURCES unit/grid_allocations.cpp LINK pennon::dns)
