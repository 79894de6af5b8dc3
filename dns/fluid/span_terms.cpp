#include "dns/fluid/span_terms.hpp"

#include "dns/fluid/equations/momentum.hpp"
#include "dns/grid/packing.hpp"

namespace pennon::dns {

void find_pressure_gradient(const Metrics<double>& metrics, const Span& span, std::size_t component,
                            const Field<double>& p, FluidScratch& scratch,
                            Field<double>& gradient) {
  FieldLease p_xi;
  if (component == along_x) {
    p_xi = scratch.fields.lease("derivative of the pressure by x");
    span.differentiate(p, *p_xi);
  }
  for (int plane = 0; plane < p.extent().planes; ++plane)
    pressure_gradient(metrics, plane, component, p, p_xi.get(), gradient);
}

void add_flux_along_x(const Span& span, double factor, Field<double>& flux, double* packed) {
  span.differentiate(flux, flux);
  for_each_row(flux.extent(), [&](int plane, int j) {
    const double* row = flux.row(plane, j);
    for (int i = 0; i < flux.extent().n_theta; ++i) *packed++ += factor * row[i];
  });
}

}  // namespace pennon::dns
