/// The spanwise direction, along which the fluid has the period S: its planes x_m = m S/M, m = 0 ..
/// M - 1, and the Fourier coefficients of fields along it. One plane is two dimensions, where
/// there is nothing to transform. The station m of a flag lies in the plane m (wall_faces.hpp).
///
/// MPI ranks share the planes, in blocks; `plane` counts those of a rank, from 0. Transforms need
/// whole columns along x, so here, and nowhere else in the fluid, fields travel between ranks.
///
/// Coefficients are real: plane m <= M/2 holds the cosine of wavenumber 2 pi m/S, plane M - m its
/// sine. The highest wavenumber of an even number of planes is dropped: its sine vanishes at all
/// planes, so that its derivative is not defined.
#pragma once

#include <cstddef>
#include <memory>

#include "dns/grid/field.hpp"

namespace pennon::dns {

class Span {
 public:
  /// `length`: S, in L; not used for one plane. Throws InputError where there are more ranks than
  /// planes.
  Span(int planes, double length);
  ~Span();
  Span(const Span&) = delete;
  Span& operator=(const Span&) = delete;
  Span(Span&&) noexcept;
  Span& operator=(Span&&) noexcept;

  int planes() const { return planes_; }              ///< of all ranks together, M
  int local_planes() const { return local_planes_; }  ///< of this rank
  int first_plane() const { return first_plane_; }    ///< of this rank, among all planes
  bool has_span() const { return planes_ > 1; }
  double length() const { return length_; }
  /// x of a plane of this rank, in L.
  double x(int plane) const { return length_ * (first_plane_ + plane) / planes_; }
  /// How many waves fit the span at the wavenumber whose coefficients a plane holds, 0 .. M/2.
  int waves(int plane) const;
  /// The wavenumber 2 pi waves/length, in 1/L; 0 where the coefficient is dropped.
  static double wavenumber(int waves, int planes, double length);
  bool is_dropped(int plane) const { return has_span() && 2 * waves(plane) == planes_; }

  /// The Fourier transform along x and its inverse, in place: of `points` numbers in each plane,
  /// `stride` from one plane to the next.
  void to_coefficients(double* values, std::size_t points, std::size_t stride) const;
  void to_values(double* coefficients, std::size_t points, std::size_t stride) const;
  /// The derivative by x at all points of a field, ghosts included.
  void differentiate(const Field<double>& f, Field<double>& f_x) const;
  /// Takes out the upper third of the wavenumbers: what a product of two fields would alias.
  void dealias(double* values, std::size_t points, std::size_t stride) const;

 private:
  class Columns;
  struct Exchange;
  template <class Change>
  void transform(const double* from, double* to, std::size_t points, std::size_t stride,
                 const Change& change) const;

  int planes_;
  double length_;
  int first_plane_ = 0, local_planes_ = 1;
  std::unique_ptr<Columns> columns_;    // null for one plane
  std::unique_ptr<Exchange> exchange_;  // null for one rank
};

}  // namespace pennon::dns
