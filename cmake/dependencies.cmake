# Every library pennon stands on. A missing one is named together with Debian's package for it. The
# installed package reads this file too (pennonConfig.cmake): there a missing library means that pennon
# is not found. All are macros, so that return() leaves this file.
find_package(PkgConfig REQUIRED)

macro(pennon_missing what package)
  if(NOT CMAKE_FIND_PACKAGE_NAME STREQUAL pennon)
    message(FATAL_ERROR "${what} was not found: install ${package} (./run.sh does it)")
  endif()
  set(pennon_FOUND FALSE)
  set(pennon_NOT_FOUND_MESSAGE "${what}, which pennon needs, was not found: install ${package}")
  return()
endmacro()

macro(pennon_pkg_config target module package)
  pkg_check_modules(${target} QUIET IMPORTED_TARGET GLOBAL ${module})
  if(NOT ${target}_FOUND)
    pennon_missing(${module} ${package})
  endif()
  # A library's own headers are not ours to warn about.
  set_property(TARGET PkgConfig::${target} PROPERTY INTERFACE_SYSTEM_INCLUDE_DIRECTORIES
               ${${target}_INCLUDE_DIRS})
endmacro()

macro(pennon_find_package name package)
  find_package(${name} QUIET)
  if(NOT ${name}_FOUND)
    pennon_missing(${name} ${package})
  endif()
endmacro()

pennon_pkg_config(GSL gsl libgsl-dev)
# GSL brings a plain CBLAS of its own, which must not stand in for the system's: the fluid's time
# goes into its products.
pennon_pkg_config(BLAS blas libblas-dev)
get_target_property(gsl_libraries PkgConfig::GSL INTERFACE_LINK_LIBRARIES)
list(FILTER gsl_libraries EXCLUDE REGEX "gslcblas|^PkgConfig::BLAS$")
set_target_properties(PkgConfig::GSL PROPERTIES
                      INTERFACE_LINK_LIBRARIES "${gsl_libraries};PkgConfig::BLAS")
pennon_pkg_config(HDF5 hdf5-serial libhdf5-dev)
pennon_pkg_config(ARPACK arpack libarpack2-dev)
pennon_pkg_config(LAPACKE lapacke liblapacke-dev)
pennon_pkg_config(FFTW fftw3 libfftw3-dev)
pennon_find_package(MPI libopenmpi-dev)
pennon_find_package(Eigen3 libeigen3-dev)
pennon_find_package(tomlplusplus libtomlplusplus-dev)
pennon_find_package(CLI11 libcli11-dev)
pennon_find_package(fmt libfmt-dev)
pennon_find_package(nlohmann_json nlohmann-json3-dev)
pennon_find_package(OpenMP libgomp1)

# SuiteSparse comes without a package description on Debian 12.
find_path(SUITESPARSE_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse)
find_library(UMFPACK_LIBRARY umfpack)
find_library(CHOLMOD_LIBRARY cholmod)
if(NOT SUITESPARSE_INCLUDE_DIR OR NOT UMFPACK_LIBRARY OR NOT CHOLMOD_LIBRARY)
  pennon_missing(SuiteSparse libsuitesparse-dev)
endif()
set(SUITESPARSE_VERSION "")
foreach(part MAIN SUB SUBSUB)
  file(STRINGS ${SUITESPARSE_INCLUDE_DIR}/SuiteSparse_config.h line
       REGEX "^#define SUITESPARSE_${part}_VERSION")
  string(REGEX REPLACE "[^0-9]" "" number "${line}")
  string(JOIN . SUITESPARSE_VERSION ${SUITESPARSE_VERSION} ${number})
endforeach()
if(NOT TARGET pennon_suitesparse)
  add_library(pennon_suitesparse INTERFACE IMPORTED GLOBAL)
  target_include_directories(pennon_suitesparse SYSTEM INTERFACE ${SUITESPARSE_INCLUDE_DIR})
  target_link_libraries(pennon_suitesparse INTERFACE ${UMFPACK_LIBRARY} ${CHOLMOD_LIBRARY})
endif()

# PETSc with real numbers for the simulation, with complex ones and SLEPc for the global modes: whichever
# of the two is the system's default. No program can hold both.
macro(pennon_petsc_of scalar target module package)
  file(GLOB petsc_dirs /usr/lib/petscdir/petsc-${scalar}/lib/pkgconfig
                       /usr/lib/slepcdir/slepc-${scalar}/lib/pkgconfig
                       /usr/lib/petscdir/*/*-${scalar}/lib/pkgconfig)
  set(pkg_config_path "$ENV{PKG_CONFIG_PATH}")
  list(JOIN petsc_dirs ":" petsc_path)
  set(ENV{PKG_CONFIG_PATH} "${petsc_path}:${pkg_config_path}")
  pennon_pkg_config(${target} ${module} ${package})
  set(ENV{PKG_CONFIG_PATH} "${pkg_config_path}")
  # Its flags are those of its own package build.
  set_property(TARGET PkgConfig::${target} PROPERTY INTERFACE_COMPILE_OPTIONS "")
endmacro()
pennon_petsc_of(real PETSC PETSc libpetsc-real-dev)
pennon_petsc_of(complex SLEPC SLEPc libslepc-complex-dev)
