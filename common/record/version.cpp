#include "common/record/version.hpp"

#include <H5public.h>
#include <fmt/format.h>
#include <gsl/gsl_version.h>

#include <toml++/toml.h>
#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "pennon_commit.hpp"

namespace pennon {

std::string version() {
  return PENNON_VERSION;
}
std::string commit() {
  return PENNON_COMMIT;
}

std::vector<std::pair<std::string, std::string>> library_versions() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned patch = 0;
  H5get_libversion(&major, &minor, &patch);
  return {
      {"ARPACK-NG", ARPACK_VERSION},
      {"CLI11", CLI11_VERSION},
      {"Eigen",
       fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"FFTW", FFTW_VERSION_TEXT},
      {"fmt",
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"GSL", gsl_version},
      {"HDF5", fmt::format("{}.{}.{}", major, minor, patch)},
      {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                    NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"PETSc", PETSC_VERSION_TEXT},
      {"SuiteSparse", SUITESPARSE_VERSION_TEXT},
      {"toml++", fmt::format("{}.{}.{}", TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
      {"compiler", __VERSION__},
  };
}

}  // namespace pennon
