/// The body that the flow of a run passes: a flag that moves as prescribed, or one that the flow
/// moves. fluid_run.cpp advances it through time, keeps its history and saves it.
#pragma once

#include <memory>

#include "common/io/hdf5.hpp"
#include "dns/coupling/coupling.hpp"
#include "dns/flag/shape_function.hpp"
#include "dns/run/fluid_history.hpp"

namespace pennon::dns {

class FlowBody {
 public:
  FlowBody() = default;
  virtual ~FlowBody() = default;
  FlowBody(const FlowBody&) = delete;
  FlowBody& operator=(const FlowBody&) = delete;

  virtual FluidState& fluid() = 0;
  virtual const FluidState& fluid() const = 0;
  /// Sets the state at t = 0; the first step will be dt long.
  virtual void start(double dt) = 0;
  virtual CoupledStepSummary advance(double dt) = 0;
  /// Keeps all that the next step depends on; and back, after a step that was left half-way. What
  /// follows may be write() only.
  virtual void keep_state() = 0;
  virtual void restore_state() = 0;

  /// Adds the body's columns to a row of the history that add_row() has begun. Every MPI rank
  /// calls.
  virtual void complete_row(const CoupledStepSummary&, FluidHistory&) const {}
  virtual void add_shape(FluidHistory&) const {}
  /// What a checkpoint holds beside the fluid's state.
  virtual void write(hdf5::Writer&) const {}
  virtual void read(const hdf5::Reader&) {}
};

/// A flag that moves as prescribed.
std::unique_ptr<FlowBody> prescribed_body(Fluid&, WallMotion);

/// A flag that the flow moves: in two dimensions, or with the fluid's span. `zeta`: z of its
/// initial displacement; without it straight, by dns.initial.angle, or as a global mode. Throws
/// InputError where the shape is steeper than the flag is long; start() where the file of the mode
/// does not serve.
std::unique_ptr<FlowBody> coupled_body(Fluid&, const Settings&, const FlagParameters&,
                                       const std::optional<ShapeFunction>& zeta);

}  // namespace pennon::dns
