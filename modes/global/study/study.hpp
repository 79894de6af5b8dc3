/// The global modes that a case asks for: steady flow, operator, spectrum. The eigensolver is
/// handed in, so that this stays free of it.
#pragma once

#include <array>
#include <optional>

#include "modes/global/study/coupled_problem.hpp"
#include "modes/global/study/mode_fields.hpp"
#include "modes/global/study/mode_kind.hpp"

namespace pennon::modes::global {

/// What the lines of progress of long studies begin with (common/progress.hpp).
inline constexpr std::array<const char*, 2> names_of_progress = {"neutral curve", "growth map"};

struct GlobalMode {
  std::complex<double> lambda = 0;              ///< growth rate and angular frequency, in V/L
  double residual = 0;                          ///< |A q - lambda B q| over |A q| + |lambda| |B q|
  std::vector<std::complex<double>> zeta = {};  ///< at the nodes of the flag, 1 where it is largest
  double adjoint_residual = 0;
  std::optional<Sensitivity> sensitivity = {};  ///< where adjoints were asked for
  EnergyShares shares = {};
  ModeKind kind = ModeKind::flag;
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
  int requested = 0, converged = 0;  ///< modes of flag and wake asked for and found
  int searched = 0;                  ///< pairs that were computed next to each target
  int box = 0;                       ///< modes of the box that were found, listed or not
  int too_fast = 0;                  ///< eigenvalues with |lambda| dt > 1, which are left out
  int checked = 0;                   ///< modes that were computed once more with a larger R
  std::optional<double> biorthogonality_defect = {};
  std::vector<GlobalMode> modes = {};  ///< by falling growth rate, those of the box last
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

/// What the settings ask for. Precondition: they are resolved. Throws SolverError.
Result run(const FlagParameters&, const FlowParameters&, const Settings&, const EigenSolver&);

}  // namespace pennon::modes::global
