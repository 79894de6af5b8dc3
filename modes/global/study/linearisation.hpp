/// The equations of flow and flag linearised at one point of their parameters: the steady flow, the
/// coupled operator about it and the fluid's response, for a flag of any mass ratio.
#pragma once

#include <optional>
#include <vector>

#include "modes/global/neutral/neutral.hpp"
#include "modes/global/solve/aerodynamic_matrix.hpp"
#include "modes/global/study/study.hpp"

namespace pennon::modes::global {

/// An Aerodynamics of it refers to it, so it must neither move nor die while that is in use. All
/// that one Linearisations made share their factors, which are those of the one that was asked last
/// for F.
struct Linearisation {
  BaseFlow base;
  FlagOperator flag;        ///< with mu = 1
  CoupledOperator coupled;  ///< with mu = 1
  AerodynamicMatrix F;

  Linearisation(BaseFlow, FlagOperator, std::shared_ptr<const LinearFluid>,
                std::shared_ptr<SparseFactors>);

  Aerodynamics aerodynamics();
  CoupledOperator with_mass_ratio(double mu) const;
};

/// Linearises at values of one parameter, the others being those of a case. The steady flow of the
/// value that was asked before is the first guess of the next.
class Linearisations {
 public:
  /// Precondition: the settings are resolved. Throws InputError where they make no grid.
  Linearisations(const FlagParameters&, const FlowParameters&, const Settings&, CurveParameter,
                 std::shared_ptr<SparseFactors>);

  /// Both throw SolverError where the steady flow fails.
  Linearisation at(double value);
  /// The flag alone, with mu = 1, which costs nothing where the flow is that of the value before.
  FlagOperator flag_at(double value);
  /// Whether F depends on the parameter.
  bool fluid_varies() const {
    return parameter_ == CurveParameter::Re || parameter_ == CurveParameter::k_x;
  }

 private:
  void move_to(double value);

  CurveParameter parameter_;
  OGrid grid_;
  std::vector<double> chord_;
  dns::Edge edge_;
  dns::FlagMaterial material_;
  PlaneParameters flow_;
  double k_x_;
  int stations_;  // in one wave
  std::shared_ptr<SparseFactors> factors_;
  std::optional<BaseFlow> base_;
  // That of the last value; none where the parameter has changed it since.
  std::shared_ptr<const LinearFluid> fluid_;
};

}  // namespace pennon::modes::global
