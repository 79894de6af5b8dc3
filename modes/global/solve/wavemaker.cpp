#include "modes/global/solve/wavemaker.hpp"

#include <cmath>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

double speed(const PlaneFlow<Complex>& q, int j, int i) {
  double sum = 0;
  for (const Field<Complex>& component : q.u) sum += std::norm(component.row(0, j)[i]);
  return std::sqrt(sum);
}

}  // namespace

FlagFeedback flag_feedback(const Eigenpair& pair, const CoupledOperator& coupled) {
  const auto held = static_cast<std::size_t>(coupled.flow().columns() + 1 - coupled.flag_nodes());
  const auto nodes = held + static_cast<std::size_t>(coupled.flag_nodes());
  FlagFeedback feedback{std::vector<double>(nodes), std::vector<Complex>(nodes),
                        std::vector<Complex>(nodes), std::vector<Complex>(nodes)};
  for (Eigen::Index node = 0; node < coupled.flag_nodes(); ++node) {
    const Complex zeta = pair.q[coupled.zeta(node)], zeta_t = pair.q[coupled.zeta_t(node)],
                  p = std::conj(pair.p[coupled.zeta_t(node)]);
    const std::size_t at = held + static_cast<std::size_t>(node);
    feedback.wavemaker[at] = std::abs(p) * std::abs(zeta_t);
    feedback.mass[at] = -pair.lambda * p * zeta_t;
    feedback.damping[at] = -p * zeta_t;
    feedback.stiffness[at] = -p * zeta;
  }
  return feedback;
}

AdjointFields adjoint_fields(const Eigenpair& pair, const CoupledOperator& coupled,
                             const PlaneFlow<Complex>& fixed, Complex scale) {
  const Extent& extent = fixed.p.extent();
  AdjointFields adjoint{PlaneFlow<Complex>(extent, fixed.components()), Field<double>(extent),
                        flag_feedback(pair, coupled)};
  constexpr double of_whole_plane = 0.5;
  const Eigen::VectorXcd p =
      of_whole_plane * std::conj(scale) * pair.p.head(coupled.flow().unknowns());
  coupled.flow().unpack<Complex>(p, adjoint.p);
  for (int j = 0; j < extent.n_rho; ++j)
    for (int i = 0; i < extent.n_theta; ++i)
      adjoint.wavemaker.row(0, j)[i] = speed(adjoint.p, j, i) * speed(fixed, j, i);
  return adjoint;
}

}  // namespace pennon::modes::global
