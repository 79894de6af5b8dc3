pennon_test(analysis_tests LABEL unit
  SOURCES
    unit/analysis_energy_budget.cpp
    unit/analysis_figure.cpp
    unit/analysis_figures_of_flag.cpp
    unit/analysis_growth.cpp
    unit/analysis_limit_cycle.cpp
    unit/analysis_raster.cpp
    unit/analysis_run_history.cpp
    unit/analysis_surface_picture.cpp
  LINK pennon::analysis GTest::gmock)
