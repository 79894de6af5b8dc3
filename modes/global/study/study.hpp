/// The global modes that a case asks for: steady flow, operator, spectrum. The eigensolver is
/// handed in, so that this stays free of it.
#pragma once

#include <array>
#include <optional>

#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/eigen_solver.hpp"
#include "modes/global/solve/sensitivity.hpp"
#include "modes/global/solve/spectrum.hpp"
#include "modes/global/study/mode_fields.hpp"
#include "modes/global/study/settings.hpp"

namespace pennon::modes::global {

/// What the lines of progress of long studies begin with (common/progress.hpp).
inline constexpr std::array<const char*, 2> names_of_progress = {"neutral curve", "growth map"};

struct GlobalMode {
  std::complex<double> lambda = 0;              ///< growth rate and angular frequency, in V/L
  double residual = 0;                          ///< |A q - lambda B q| over |A q| + |lambda| |B q|
  std::vector<std::complex<double>> zeta = {};  ///< at the nodes of the flag, 1 where it is largest
  double adjoint_residual = 0;
  std::optional<Sensitivity> sensitivity = {};  ///< where adjoints were asked for
};

/// What is told of the steady flow.
struct BaseFlowSummary {
  double drag_coefficient = 0;       ///< both sides, on 1/2 rho_f V^2 L
  double residual = 0;               ///< as BaseFlow has it
  std::vector<double> tension = {};  ///< at the nodes of the flag, in rho_f V^2 L
};

/// What is told of the modes: what pennon-global hands to pennon (wire.hpp).
struct FoundModes {
  BaseFlowSummary base_flow = {};
  std::vector<double> chord = {};  ///< y of the flag's nodes
  Eigen::Index unknowns = 0;
  int requested = 0, converged = 0;  ///< pairs asked for (Spectrum::requested) and found
  std::optional<double> biorthogonality_defect = {};
  std::vector<GlobalMode> modes = {};  ///< the converged ones, by falling growth rate
  double base_seconds = 0, operator_seconds = 0, eigen_seconds = 0;
};

/// The same with the fields of flow and modes (fields_file.hpp).
struct Result {
  FlagParameters flag;
  BaseFlow base;
  double k_x = 0;
  int n_x = 0;                                    ///< stations of the flag in one wave
  std::vector<std::array<double, 2>> nodes = {};  ///< in its equilibrium, as FlagOperator has them
  FoundModes found = {};
  FieldsOfModes fields = {};  ///< of the modes found
};

/// The flow in a plane that the settings, which are resolved, ask for.
PlaneParameters plane_parameters(const FlowParameters&, const Settings&);

/// Throws InputError where the settings, which are resolved, make no grid.
OGrid grid_of(const Settings&);

/// The n_modes pairs next to each target, each once; without a target the leading ones of several
/// points along the axis of the angular frequency, on both sides where they differ.
Spectrum spectrum_of(const CoupledOperator&, const Settings&, const EigenSolver&);

/// What the settings ask for. Precondition: they are resolved. Throws SolverError.
Result run(const FlagParameters&, const FlowParameters&, const Settings&, const EigenSolver&);

}  // namespace pennon::modes::global
