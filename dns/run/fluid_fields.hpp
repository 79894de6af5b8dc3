/// The fluid's fields on disk: one HDF5 file for each time, on the grid of that time.
#pragma once

#include <filesystem>
#include <string>

#include "common/io/xdmf.hpp"
#include "dns/fluid/fluid.hpp"

namespace pennon::dns {

/// Writes the corners of the grid and, at the cells, velocity, pressure and vorticity; kind =
/// "fluid_fields". Arrays run [plane][rho][theta], without the first index in two dimensions; with
/// a span the first plane stands again at x = gamma, so that the cells along x have two ends. Every
/// rank calls. Throws FileError.
void write_fields(const Fluid&, const FluidState&, const std::filesystem::path& file);

/// What an XDMF file says of the fields that write_fields() left in `file` at a time.
xdmf::Grid described_fields(const Fluid&, double t, const std::string& file);

/// Bytes of such a file.
std::uintmax_t size_of_fields(const Fluid&);

}  // namespace pennon::dns
