/// A map of growth rates while it is made: the fits of the response, the basis of the flag's
/// shapes, and the columns that were found with both.
///
/// A mode of the map has its shape in the basis, a, and is then called small; the shape of the
/// whole flag is zeta = Z a (flag_basis.hpp).
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "modes/global/map/checked_fit.hpp"
#include "modes/global/map/flag_basis.hpp"
#include "modes/global/map/map_column.hpp"
#include "modes/global/map/reduced_map.hpp"

namespace pennon::modes::global {

/// What the map is to be made of; all of it outlives the model.
struct MapTask {
  const std::vector<FlagOperator>& flags;  ///< of each column, with mu = 1
  const std::vector<double>& mu;           ///< increasing
  const ReducedMapSettings& settings;
};

class MapModel {
 public:
  MapModel(const MapTask&, std::vector<CheckedFit> fits, FlagBasis basis);

  const MapTask task;
  std::vector<CheckedFit> fits;  ///< of each window
  FlagBasis basis;
  std::vector<MapColumn> columns;  ///< one for each flag; empty until find() has found it

  /// Finds the modes of these columns with the fits and the basis as they are, by several threads.
  /// With `starts_from_known` the search begins at the neutral modes that a column has; else it is
  /// a search over the whole window, which also finds those that the columns do not have yet.
  void find(const std::vector<std::size_t>& these_columns, bool starts_from_known);

  /// The points of these columns whose leading mode belongs to the window.
  std::vector<MapPlace> places(const std::vector<std::size_t>& these_columns,
                               std::size_t window) const;
  bool has_mode(const MapPlace&, std::size_t window) const;
  /// The leading mode at a place that has one, with its shape in the basis.
  const FlagMode& small_mode(const MapPlace& place) const {
    return columns[place.column].leading[place.m]->mode;
  }
  /// The same with the shape of the whole flag.
  FlagMode mode(const MapPlace& place) const { return whole(small_mode(place)); }
  /// A neutral mode whose shape in the basis is `a`, with the shape of the whole flag.
  FlagMode neutral_mode_of_whole_flag(double omega, const Eigen::VectorXcd& a) const {
    return whole({std::complex<double>(0, omega), a, 0});
  }

  const FlagOperator& flag(std::size_t column) const { return task.flags[column]; }
  /// K in the basis, as find() used it.
  const FlagOperator& small_flag(std::size_t column) const { return small_flags_[column]; }

  /// See correction() in flag_mode.hpp: the error of lambda at a place, to first order, if the
  /// response is F.
  std::complex<double> correction_by(const Aerodynamics& F, const MapPlace&) const;
  /// The error of lambda = i omega of a neutral mode that the basis has, to first order, with the
  /// window's fit for the whole flag.
  double neutral_error(std::size_t column, std::size_t window, double mu, const FlagMode&) const;

 private:
  FlagMode whole(FlagMode small) const;
  void find_column(std::size_t column, const std::vector<ResponseInWindow>&,
                   bool starts_from_known);
  bool is_of_whole_flag(std::size_t column, std::size_t window, const NeutralMode&) const;

  std::vector<FlagOperator> small_flags_;
};

}  // namespace pennon::modes::global
