pennon_test(test_global_modes LABEL verification
            SOURCES verification/global_base_flow.cpp verification/global_growth.cpp
            LINK pennon::global pennon::dns)
