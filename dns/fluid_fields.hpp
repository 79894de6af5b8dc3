/// The fluid's fields on disk: one HDF5 file for each time, on the grid of that time.
#pragma once

#include <filesystem>

#include "dns/fluid.hpp"

namespace pennon::dns {

/// Writes the corners of the grid and, at the cells, velocity, pressure and vorticity; kind =
/// "fluid_fields". Arrays run [plane][rho][theta]; with a span a plane is repeated at x = gamma, so
/// that the cells along x have two ends. Throws FileError.
void write_fields(const Fluid&, const FluidState&, const std::filesystem::path& file);

/// Bytes of such a file.
std::uintmax_t size_of_fields(const Fluid&);

}  // namespace pennon::dns
