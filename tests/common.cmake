pennon_test(common_tests LABEL unit
  SOURCES
    support/case_mutator.cpp
    unit/common_atomic_file.cpp
    unit/common_case_fuzz.cpp
    unit/common_case_reader.cpp
    unit/common_csv.cpp
    unit/common_hdf5.cpp
    unit/common_nearest_name.cpp
    unit/common_output_folder.cpp
    unit/common_progress.cpp
    unit/common_record.cpp
    unit/common_schema.cpp
    unit/common_sweep.cpp
    unit/common_xdmf.cpp
  LINK pennon::common Boost::headers GTest::gmock util)
