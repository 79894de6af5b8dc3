#include "modes/global/spectrum.hpp"

#include <fmt/format.h>

#include <Eigen/UmfPackSupport>
#include <algorithm>

#include "common/errors.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::SparseMatrix<Complex>;

// Between eigenvalues that are one, over 1 + |lambda|.
constexpr double same_eigenvalue = 1e-6;

}  // namespace

double residual_of(const Matrix& A, const Matrix& B, const Eigenpair& pair) {
  const Eigen::VectorXcd Aq = A * pair.q, Bq = B * pair.q;
  return (Aq - pair.lambda * Bq).norm() / (Aq.norm() + std::abs(pair.lambda) * Bq.norm());
}

void normalise(const Matrix& B, Eigenpair& pair) {
  pair.q /= std::sqrt(pair.q.dot(B * pair.q).real());
  if (pair.p.size() > 0) pair.p /= std::conj(pair.p.dot(B * pair.q));
}

double biorthogonality_defect(const Matrix& B, const std::vector<Eigenpair>& pairs) {
  double largest = 0;
  for (const Eigenpair& i : pairs)
    for (const Eigenpair& j : pairs)
      if (&i != &j && i.p.size() > 0) largest = std::max(largest, std::abs(i.p.dot(B * j.q)));
  return largest;
}

void biorthogonalise(const Matrix& A, const Matrix& B, std::vector<Eigenpair>& pairs) {
  if (std::ranges::any_of(pairs, [](const Eigenpair& pair) { return pair.p.size() == 0; })) return;
  std::vector<Eigenpair*> order;
  order.reserve(pairs.size());
  for (Eigenpair& pair : pairs) order.push_back(&pair);
  std::ranges::sort(order, {}, [](const Eigenpair* pair) { return pair->p.squaredNorm(); });
  std::vector<Eigen::VectorXcd> Bq;
  Bq.reserve(pairs.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    Eigenpair& pair = *order[k];
    for (std::size_t l = 0; l < k; ++l) {
      pair.q -= order[l]->p.dot(B * pair.q) * order[l]->q;
      pair.p -= Bq[l].dot(pair.p) * order[l]->p;
    }
    normalise(B, pair);
    Bq.emplace_back(B * pair.q);
    pair.residual = residual_of(A, B, pair);
    set_adjoint(A, B, pair.p, pair);
  }
}

void set_adjoint(const Matrix& A, const Matrix& B, Eigen::VectorXcd p, Eigenpair& pair) {
  const Eigen::VectorXcd Ap = A.adjoint() * p, Bp = B.adjoint() * p;
  pair.adjoint_residual =
      (Ap - std::conj(pair.lambda) * Bp).norm() / (Ap.norm() + std::abs(pair.lambda) * Bp.norm());
  pair.p = std::move(p);
}

bool are_same(Complex a, Complex b) {
  return std::abs(a - b) < same_eigenvalue * (1 + std::abs(b));
}

void merge(std::vector<Eigenpair> others, Spectrum& spectrum) {
  for (Eigenpair& pair : others) {
    const auto same = std::ranges::find_if(spectrum.pairs, [&](const Eigenpair& known) {
      return are_same(known.lambda, pair.lambda);
    });
    if (same == spectrum.pairs.end())
      spectrum.pairs.push_back(std::move(pair));
    else if (pair.residual < same->residual)
      *same = std::move(pair);
  }
  std::ranges::sort(spectrum.pairs, [](const Eigenpair& a, const Eigenpair& b) {
    return a.lambda.real() > b.lambda.real();
  });
}

Eigenpair eigenpair_near(const Matrix& A, const Matrix& B, Complex target) {
  constexpr int most_shifts = 20, iterations_of_shift = 8;
  constexpr double tolerance = 1e-12, aside = 1e-6;  // of the shift from the eigenvalue
  Eigenpair pair{target, Eigen::VectorXcd::Ones(A.rows()), 1};
  for (int shift = 0; shift < most_shifts; ++shift) {
    const Matrix shifted = A - target * B;
    const Eigen::UmfPackLU<Matrix> factors(shifted);
    for (int k = 0; k < iterations_of_shift; ++k) {
      const Eigen::VectorXcd right = B * pair.q, next = factors.solve(right);
      const Complex by = pair.q.dot(next) / pair.q.squaredNorm();
      pair.lambda = target + 1.0 / by;
      pair.q = next / next.norm();
      pair.residual = residual_of(A, B, pair);
      if (pair.residual < tolerance) return pair;
    }
    target = pair.lambda + aside * (1 + std::abs(pair.lambda));
  }
  throw SolverError(
      fmt::format("inverse iteration near {:.6g} {:+.6g} i left a residual of {:.3g}; another "
                  "target may help",
                  target.real(), target.imag(), pair.residual));
}

}  // namespace pennon::modes::global
