pennon_test(test_analysis
  SOURCES
    unit/analysis/drawing/figure.cpp
    unit/analysis/drawing/raster.cpp
    unit/analysis/drawing/surface_picture.cpp
    unit/analysis/figures/of_flag.cpp
    unit/analysis/figures/symbol.cpp
    unit/analysis/signal/energy_budget.cpp
    unit/analysis/signal/growth.cpp
    unit/analysis/signal/limit_cycle.cpp
    unit/analysis/signal/run_history.cpp
  SEPARATE
    unit/analysis/drawing/raster.cpp
  LINK pennon::analysis_figures GTest::gmock)

pennon_test(test_decomposition
  SOURCES
    unit/analysis/decomposition/dmd.cpp
    unit/analysis/decomposition/pod.cpp
    unit/analysis/decomposition/projection.cpp
    unit/analysis/decomposition/sources.cpp
    unit/analysis/decomposition/spod.cpp
  SEPARATE
    unit/analysis/decomposition/dmd.cpp
    unit/analysis/decomposition/projection.cpp
    unit/analysis/decomposition/spod.cpp
  LINK pennon::analysis_decomposition GTest::gmock)
