#include "modes/global/solve/sensitivity.hpp"

#include <algorithm>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr double relative_step = 1e-4;  // of the central differences of K

}  // namespace

Sensitivity sensitivity(const Eigenpair& pair, const CoupledOperator& coupled,
                        const dns::FlagMaterial& material, const FlagOf& flag_of) {
  const Eigen::VectorXcd zeta = pair.q.segment(coupled.zeta(0), coupled.flag_nodes()),
                         zeta_t = pair.q.segment(coupled.zeta_t(0), coupled.flag_nodes()),
                         force = pair.p.segment(coupled.zeta_t(0), coupled.flag_nodes());
  const auto by_stiffness = [&](double dns::FlagMaterial::*parameter, double step) -> Complex {
    dns::FlagMaterial more = material, less = material;
    more.*parameter += step;
    less.*parameter -= step;
    const Eigen::MatrixXcd change =
        (flag_of(more, 1).stiffness - flag_of(less, 1).stiffness) / (2 * step);
    return -force.dot(change * zeta);
  };
  const Eigen::VectorXd mass = flag_of(material, 1).mass / material.mu;
  const Eigen::MatrixXcd by_tension = (flag_of(material, 1 + relative_step).stiffness -
                                       flag_of(material, 1 - relative_step).stiffness) /
                                      (2 * relative_step);
  return {.mu = -pair.lambda * force.dot(mass.asDiagonal() * zeta_t),
          .K_B = material.K_B > 0
                     ? by_stiffness(&dns::FlagMaterial::K_B, relative_step * material.K_B)
                     : Complex(0),
          .nu_s = by_stiffness(&dns::FlagMaterial::nu_s, relative_step),
          .tension = -force.dot(by_tension * zeta)};
}

}  // namespace pennon::modes::global
