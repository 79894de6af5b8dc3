/// Snapshots in an HDF5 file that another code wrote. At its root it has
///
///   t   (M)              times, increasing
///   z   (M, n_x, n_y) or (M, n_y), a flag's shape, with y (n_y), and with a span x (n_x), which
///   has
///       the attribute `span`, the period S; or
///   q   (M, n) or (M, c, n), anything, of real or complex numbers (compounds r, i), with the
///       optional attribute `names` of the c components; optional weight (n) or (M, n), coordinates
///       (n, 2 or 3), and x with `span` where the n points are stations along a span, station by
///       station.
///
/// The weights of a flag are its pieces: the lengths between the middles of neighbouring y, times
/// S/n_x; those of q are `weight`, else 1.
#pragma once

#include <filesystem>
#include <memory>

#include "analysis/decomposition/snapshots.hpp"
#include "analysis/decomposition/times.hpp"

namespace pennon::decomposition {

/// Which of the two a file with both is asked for.
enum class Foreign { flag, field };

/// Throws InputError where the file is not of this layout: with the array and what is needed.
std::unique_ptr<Snapshots> open_foreign_file(const std::filesystem::path&, Foreign, const Window&);

/// Signals in a CSV file with a header: the first column is t, each other one a component at one
/// point. Throws InputError where there is no column t, or none beside it.
std::unique_ptr<Snapshots> open_signals(const std::filesystem::path&, const Window&);

}  // namespace pennon::decomposition
