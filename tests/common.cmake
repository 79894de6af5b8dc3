pennon_test(test_common
  SOURCES
    support/case_mutator.cpp
    unit/common/interrupt.cpp
    unit/common/progress.cpp
    unit/common/case/case_difference.cpp
    unit/common/case/case_fuzz.cpp
    unit/common/case/case_reader.cpp
    unit/common/case/nearest_name.cpp
    unit/common/case/schema.cpp
    unit/common/case/sweep.cpp
    unit/common/io/atomic_file.cpp
    unit/common/io/csv.cpp
    unit/common/io/folder_lock.cpp
    unit/common/io/hdf5.cpp
    unit/common/io/output_folder.cpp
    unit/common/io/record_file.cpp
    unit/common/io/xdmf.cpp
    unit/common/linear_algebra/svd.cpp
    unit/common/process/process.cpp
    unit/common/record/record.cpp
  LINK pennon::common_case pennon::common_io pennon::common_linear_algebra pennon::common_process
       pennon::common_record Boost::headers GTest::gmock util)
