/// The work of `pennon decompose`: snapshots, decomposed as the settings say, with all that is
/// written of them.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/decomposition/dmd.hpp"
#include "analysis/decomposition/projection.hpp"
#include "analysis/decomposition/settings.hpp"
#include "analysis/decomposition/snapshots.hpp"
#include "analysis/decomposition/spod.hpp"
#include "analysis/decomposition/waves.hpp"
#include "common/io/output_folder.hpp"

namespace pennon::decomposition {

struct PodResult {
  Eigen::VectorXd energy;         ///< all
  Eigen::MatrixXcd coefficients;  ///< a_j(t_m), modes x M
};

struct SpodResult {
  Spod spod;
  std::vector<Eigen::Index> kept;  ///< the frequencies whose modes are kept
};

struct Decomposition {
  Settings settings;
  Layout layout;
  TimeGrid times;
  bool is_complex = false;
  std::size_t n_modes = 0;  ///< reported and kept
  double variance = 0;      ///< of the data as decomposed: mean <q, q>
  std::optional<PodResult> pod = {};
  std::optional<Dmd> dmd = {};
  std::optional<SpodResult> spod = {};
  std::vector<SpanwiseWaveParts> waves = {};
  std::optional<Projection> projection = {};
  std::vector<std::string> notes = {};  ///< what to mind, in sentences
};

/// `given`: the modes on which normal_modes and global_modes project.
/// Decomposes and writes decomposition.h5, on the leading rank; every rank calls. Throws InputError
/// where the data or the settings do not serve, SolverError where a fit does not converge.
Decomposition decompose(std::unique_ptr<Snapshots>, const Settings&, const OutputFolder&,
                        std::vector<GivenMode> given = {});

}  // namespace pennon::decomposition
