pennon_test(analysis_tests LABEL unit
  SOURCES
    unit/analysis_figure.cpp
    unit/analysis_figures_of_flag.cpp
    unit/analysis_raster.cpp
    unit/analysis_surface_picture.cpp
  LINK pennon::analysis GTest::gmock)
