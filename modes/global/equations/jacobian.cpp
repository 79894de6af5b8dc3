#include "modes/global/equations/jacobian.hpp"

#include <algorithm>
#include <vector>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using RealTriplets = std::vector<Eigen::Triplet<double>>;

constexpr int cell_reach = 2;  // of a cell's equations, in rows and columns
constexpr int cell_period = 2 * cell_reach + 1;

// The unknowns of a field in rows and columns that leave the rests `row` and `column`.
template <class Use>
void for_each_seed(const HalfPlane& unknowns, int row, int column, const Use& use) {
  for (int j = row; j < unknowns.rows(); j += cell_period)
    for (int i = column; i < unknowns.columns(); i += cell_period) use(j, i);
}

// The derivatives of `found` by the unknowns of a field that were stepped together.
void read(const PlaneFlow<Complex>& found, const HalfPlane& unknowns, int field, int row,
          int column, double factor, RealTriplets& entries) {
  for_each_seed(unknowns, row, column, [&](int j, int i) {
    const Eigen::Index by = unknowns.index(field, j, i);
    for (int at_j = std::max(0, j - cell_reach);
         at_j <= std::min(unknowns.rows() - 1, j + cell_reach); ++at_j)
      for (int at_i = std::max(0, i - cell_reach);
           at_i <= std::min(unknowns.columns() - 1, i + cell_reach); ++at_i)
        for (int f = 0; f < unknowns.fields(); ++f) {
          const double value = found.field(f).row(0, at_j)[at_i].imag();
          if (value != 0)
            entries.emplace_back(unknowns.index(f, at_j, at_i), by, factor / complex_step * value);
        }
  });
}

// The same of the forces along z.
void read_forces(const std::vector<Complex>& force, const HalfPlane& unknowns, int field, int row,
                 int column, RealTriplets& entries) {
  constexpr int rows_at_wall = 3;  // that the traction is found from
  for_each_seed(unknowns, row, column, [&](int j, int i) {
    if (j >= rows_at_wall) return;
    for (int at = std::max(0, i - cell_reach);
         at <= std::min(unknowns.columns() - 1, i + cell_reach); ++at) {
      const int segment = unknowns.columns() - 1 - at;  // whose upper face this is
      const double value = force[static_cast<std::size_t>(segment)].imag();
      if (value != 0)
        entries.emplace_back(segment, unknowns.index(field, j, i), value / complex_step);
    }
  });
}

Eigen::SparseMatrix<double> matrix_of(const RealTriplets& entries, Eigen::Index rows,
                                      Eigen::Index n) {
  Eigen::SparseMatrix<double> matrix(rows, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

PlaneFlow<Complex> complex_flow(const PlaneFlow<double>& q) {
  PlaneFlow<Complex> result(q.p.extent(), q.components());
  for (int f = 0; f < q.fields(); ++f)
    std::ranges::copy(q.field(f).values(), result.field(f).values().begin());
  return result;
}

Jacobian jacobian(PlaneEquations<Complex>& equations, const PlaneFlow<double>& q,
                  const HalfPlane& unknowns, bool with_span) {
  PlaneFlow<Complex> at = complex_flow(q), slope(q.p.extent(), q.components()), R = slope, X = R;
  RealTriplets in_plane, along_x, along_x_twice, force;
  for (int f = 0; f < unknowns.fields(); ++f)
    for (int row = 0; row < cell_period; ++row)
      for (int column = 0; column < cell_period; ++column) {
        const auto step_by = [&](PlaneFlow<Complex>& flow, double h) {
          for_each_seed(unknowns, row, column, [&](int j, int i) {
            Complex* values = flow.field(f).row(0, j);
            values[i].imag(h);
            values[unknowns.mirror(i)].imag(unknowns.sign_below(f) * h);
          });
        };
        step_by(at, complex_step);
        equations.evaluate(at, nullptr, R, with_span ? &X : nullptr);
        step_by(at, 0);
        read(R, unknowns, f, row, column, 1, in_plane);
        read_forces(equations.forces().z, unknowns, f, row, column, force);
        if (!with_span) continue;
        read(X, unknowns, f, row, column, -1, along_x);
        step_by(slope, complex_step);
        equations.evaluate(at, &slope, R, &X);
        step_by(slope, 0);
        read(R, unknowns, f, row, column, 1, along_x);
        read(X, unknowns, f, row, column, -1, along_x_twice);
      }
  const Eigen::Index n = unknowns.unknowns();
  return {matrix_of(in_plane, n, n), matrix_of(along_x, n, n), matrix_of(along_x_twice, n, n),
          matrix_of(force, unknowns.columns(), n)};
}

}  // namespace pennon::modes::global
