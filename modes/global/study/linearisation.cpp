#include "modes/global/study/linearisation.hpp"

#include "dns/flag/of_case.hpp"
#include "dns/fluid/equations/wall_faces.hpp"

namespace pennon::modes::global {

Linearisation::Linearisation(BaseFlow its_base, FlagOperator its_flag,
                             std::shared_ptr<const LinearFluid> fluid,
                             std::shared_ptr<SparseFactors> factors)
    : base(std::move(its_base)),
      flag(its_flag),
      coupled(fluid, std::move(its_flag)),
      F(std::move(fluid), std::move(factors)) {}

Aerodynamics Linearisation::aerodynamics() {
  return [this](std::complex<double> lambda) {
    return Response{F.at(lambda),
                    [this](const Eigen::VectorXcd& zeta) { return F.derivative(zeta); }};
  };
}

CoupledOperator Linearisation::with_mass_ratio(double mu) const {
  CoupledOperator scaled = coupled;
  scaled.flag.mass *= mu;
  return scaled;
}

Linearisations::Linearisations(const FlagParameters& flag, const FlowParameters& flow,
                               const Settings& settings, CurveParameter parameter,
                               std::shared_ptr<SparseFactors> factors)
    : parameter_(parameter),
      grid_(grid_of(settings)),
      chord_(dns::coupled_chord(grid_)),
      edge_(dns::leading_edge_of(flag)),
      material_(dns::material_of(flag, 1)),
      flow_(plane_parameters(flow, settings)),
      k_x_(*settings.k_x),
      stations_(static_cast<int>(settings.n_x)),
      factors_(std::move(factors)) {}

void Linearisations::move_to(double value) {
  switch (parameter_) {
    case CurveParameter::Re:
      flow_.Re = value;
      break;
    case CurveParameter::k_x:
      k_x_ = value;
      break;
    case CurveParameter::K_B:
      material_.K_B = value;
      break;
    case CurveParameter::nu_s:
      material_.nu_s = value;
      break;
  }
  if (fluid_varies()) fluid_ = nullptr;
  const int components = k_x_ != 0 ? 3 : 2;
  if (!base_)
    base_ = base_flow(grid_, flow_, components);
  else if (base_->parameters.Re != flow_.Re || base_->q.components() != components)
    base_ = base_flow(grid_, flow_, components, *base_);
}

FlagOperator Linearisations::flag_at(double value) {
  move_to(value);
  return flag_operator(chord_, edge_, material_, base_->forces, k_x_, stations_);
}

Linearisation Linearisations::at(double value) {
  FlagOperator flag = flag_at(value);
  if (!fluid_)
    fluid_ = std::make_shared<LinearFluid>(
        linear_fluid(grid_, *base_, static_cast<int>(flag.mass.size()), k_x_));
  return {*base_, std::move(flag), fluid_, factors_};
}

}  // namespace pennon::modes::global
