/// States in a checkpoint: every member that the next step depends on, by its name.
///
/// The fluid's fields stand as /u_0, /u_1, ..., [plane][rho][theta]; the vectors of the flag's
/// nodes as /x, in a coupled run /flag_x, [node][component]. The numbers are attributes of the
/// file, those of a coupled flag the array /flag.
#pragma once

#include <optional>

#include "common/io/hdf5.hpp"
#include "dns/coupling/coupling.hpp"
#include "dns/flag/newton.hpp"
#include "dns/fluid/fluid.hpp"

namespace pennon::dns {

/// Every rank calls; `file`: of the leading rank, null on the others. Throws FileError.
void write_state(const FluidState&, const Fluid&, hdf5::Writer* file);
/// Each rank reads its own planes. Throws InputError where the file is of another grid, lacks a
/// member, or holds a value that is not finite.
FluidState read_fluid_state(const hdf5::Reader&, const Fluid&);

/// Throws FileError.
template <int dim>
void write_state(const FlagState<dim>&, hdf5::Writer&);
/// Throws InputError where the file is of a flag with other than `nodes` nodes, or of other
/// dimension, lacks a member, or holds a value that is not finite.
template <int dim>
FlagState<dim> read_flag_state(const hdf5::Reader&, int nodes);

/// What a coupled state has beside the fluid's, and the flag's energy at the start of the run.
/// Throws FileError.
template <int dim>
void write_flag_of(const CoupledState<dim>&, double energy_at_start, hdf5::Writer&);
/// The same into a state whose fluid is read already, of a flag with so many nodes at so many
/// stations; returns the energy. Throws InputError as read_flag_state() does.
template <int dim>
double read_flag_of(const hdf5::Reader&, int nodes, int stations, CoupledState<dim>&);

/// The tangent of the flag as the array /tangent; nothing without one. Throws FileError.
void write_tangent(const std::optional<KeptTangent>&, hdf5::Writer&);
/// None where the file has none.
std::optional<KeptTangent> read_tangent(const hdf5::Reader&);
/// Hands it to the solver of a flag. Throws InputError where it is of another flag.
template <class Solver>
void keep_tangent_of(const hdf5::Reader& file, Solver& solver) {
  const std::optional<KeptTangent> tangent = read_tangent(file);
  if (tangent && !solver.keep(*tangent))
    file.fail("holds at /tangent the matrix of another flag, or none that can be factored");
}

}  // namespace pennon::dns
