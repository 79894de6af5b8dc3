/// A point in the parameters of flow and flag: steady flow, coupled operator and the fluid's
/// response, for a flag of any mass ratio.
#pragma once

#include <optional>
#include <vector>

#include "modes/global/neutral/neutral.hpp"
#include "modes/global/solve/aerodynamic_matrix.hpp"
#include "modes/global/study/study.hpp"

namespace pennon::modes::global {

/// Does not move while an Aerodynamics of it is in use. The stations share their factors: only the
/// one that was asked last has them.
struct Station {
  BaseFlow base;
  FlagOperator flag;        ///< with mu = 1
  CoupledOperator coupled;  ///< with mu = 1
  AerodynamicMatrix F;

  Station(BaseFlow, FlagOperator, std::shared_ptr<const LinearFluid>,
          std::shared_ptr<SparseFactors>);

  Aerodynamics aerodynamics();
  CoupledOperator with_mass_ratio(double mu) const;
};

/// The points along one parameter, the others those of a case. A steady flow is found from that of
/// the point asked for before.
class Stations {
 public:
  /// Precondition: the settings are resolved. Throws InputError where they make no grid.
  Stations(const FlagParameters&, const FlowParameters&, const Settings&, CurveParameter,
           std::shared_ptr<SparseFactors>);

  /// Both throw SolverError where the steady flow fails.
  Station at(double value);
  /// The flag alone, with mu = 1, which costs nothing where the flow is that of the point before.
  FlagOperator flag_at(double value);
  /// Whether F does, from point to point.
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
  int spanwise_nodes_;
  std::shared_ptr<SparseFactors> factors_;
  std::optional<BaseFlow> base_;
  std::shared_ptr<const LinearFluid> fluid_;  // of the last station, where it is still good
};

}  // namespace pennon::modes::global
