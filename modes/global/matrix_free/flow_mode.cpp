#include "modes/global/matrix_free/flow_mode.hpp"

#include "modes/global/study/mode_fields.hpp"

namespace pennon::modes::global {

dns::FlowMode flow_mode(const BaseFlow& base, const FlagOperator& flag,
                        const CoupledOperator& coupled, const Eigenpair& pair, double k_x) {
  using Complex = std::complex<double>;
  const Complex scale = scale_of(pair, coupled);
  const Extent& plane = base.q.p.extent();
  PlaneFlow<Complex> q(plane, base.q.components());
  const Eigen::VectorXcd flow = pair.q.head(coupled.flow().unknowns()) / scale;
  coupled.flow().unpack<Complex>(flow, q);
  dns::FlowMode mode(plane, 0);
  mode.lambda = pair.lambda;
  mode.k_x = k_x;
  mode.steady_u = base.q.u;
  mode.steady_p = base.q.p;
  mode.is_inflow = base.is_inflow;
  mode.flag = flag.nodes;
  mode.u = q.u;
  mode.p = q.p;
  mode.zeta.resize(flag.nodes.size());  // 0 where the flag is held
  mode.zeta_t.resize(flag.nodes.size());
  const std::size_t held = flag.nodes.size() - static_cast<std::size_t>(coupled.flag_nodes());
  for (Eigen::Index node = 0; node < coupled.flag_nodes(); ++node) {
    const std::size_t j = held + static_cast<std::size_t>(node);
    mode.zeta[j] = pair.q[coupled.zeta(node)] / scale;
    mode.zeta_t[j] = pair.q[coupled.zeta_t(node)] / scale;
  }
  return mode;
}

}  // namespace pennon::modes::global
