# What every target of the project is compiled with, and how a folder becomes a library.
add_library(pennon_options INTERFACE)
target_compile_features(pennon_options INTERFACE cxx_std_20)
target_compile_options(pennon_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow)
# Sums and products are rounded one by one, so that scalar and vector code and every machine give the
# same bits; square roots neither set errno nor trap, so that loops over them become vector code.
target_compile_options(pennon_options INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)
# Threads would share out Eigen's products by their number, and with it the rounding.
target_compile_definitions(pennon_options INTERFACE EIGEN_DONT_PARALLELIZE)
target_include_directories(pennon_options INTERFACE ${PROJECT_SOURCE_DIR})
if(PENNON_SANITIZE)
  target_compile_options(pennon_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(pennon_options INTERFACE -fsanitize=address,undefined)
endif()

# pennon_library(NAME SOURCES... LINK libraries...): the library of one folder.
function(pennon_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(pennon_${name} STATIC ${ARG_SOURCES})
  add_library(pennon::${name} ALIAS pennon_${name})
  target_link_libraries(pennon_${name} PUBLIC pennon_options ${ARG_LINK})
endfunction()
