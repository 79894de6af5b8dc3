/// The terms of the equations that need derivatives along the span, for all planes of this rank:
/// prediction and projection have them from here.
#pragma once

#include "dns/fluid/equations/component.hpp"
#include "dns/fluid/step.hpp"
#include "dns/grid/metrics.hpp"
#include "dns/grid/span.hpp"

namespace pennon::dns {

/// Whether the pressure acts on a component: along x only where there is a span.
inline bool has_pressure_gradient(const Span& span, std::size_t component) {
  return component != along_x || span.has_span();
}

/// A component of grad p at all cells of this rank, of the pressure with its ghosts.
void find_pressure_gradient(const Metrics<double>&, const Span&, std::size_t component,
                            const Field<double>& p, FluidScratch&, Field<double>& gradient);

/// Adds `factor` times the derivative by x of a flux, which is lost, to packed cells.
void add_flux_along_x(const Span&, double factor, Field<double>& flux, double* packed);

}  // namespace pennon::dns
