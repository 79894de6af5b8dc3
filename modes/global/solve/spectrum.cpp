#include "modes/global/solve/spectrum.hpp"

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

// Takes out of each mode and each adjoint what it holds of the others, to first order: with the
// remainders r = A q - lambda B q and s = A^H p - conj(lambda) B^H p, mode l holds
// p_k^H r_l / (lambda_k - lambda_l) of mode k, and adjoint k the conjugate of s_k^H q_l / (lambda_l
// - lambda_k) of adjoint l. The eigenvalues take their change, p^H r, too. Only among
// well-conditioned pairs: in r and s what a mode holds of badly conditioned ones is balanced by
// modes that are not among the pairs, and taking it out by itself makes residuals up to |p| |B q|
// times as large.
void separate(const Pencil& pencil, std::vector<Eigenpair>& pairs) {
  constexpr double largest_condition = 1e4;
  std::vector<Eigenpair*> good;
  for (Eigenpair& pair : pairs)
    if (pair.p.norm() * pencil.B(pair.q).norm() < largest_condition) good.push_back(&pair);
  std::vector<Eigenpair> purer;
  purer.reserve(good.size());
  for (const Eigenpair* l : good) {
    const Eigen::VectorXcd r = pencil.A(l->q) - l->lambda * pencil.B(l->q),
                           s = pencil.A_adjoint(l->p) -
                               std::conj(l->lambda) * pencil.B_adjoint(l->p);
    Eigenpair& pure = purer.emplace_back(*l);
    pure.lambda += l->p.dot(r);
    for (const Eigenpair* k : good) {
      if (k == l) continue;
      const Complex gap = k->lambda - l->lambda;
      pure.q -= k->p.dot(r) / gap * k->q;
      pure.p -= std::conj(s.dot(k->q) / gap) * k->p;
    }
    normalise(pencil, pure);
  }
  for (std::size_t k = 0; k < good.size(); ++k) *good[k] = std::move(purer[k]);
}

}  // namespace

double residual_of(const Pencil& pencil, const Eigenpair& pair) {
  const Eigen::VectorXcd Aq = pencil.A(pair.q), Bq = pencil.B(pair.q);
  return (Aq - pair.lambda * Bq).norm() / (Aq.norm() + std::abs(pair.lambda) * Bq.norm());
}

void normalise(const Pencil& pencil, Eigenpair& pair) {
  pair.q /= std::sqrt(pair.q.dot(pencil.B(pair.q)).real());
  if (pair.p.size() > 0) pair.p /= std::conj(pair.p.dot(pencil.B(pair.q)));
}

double biorthogonality_defect(const Pencil& pencil, const std::vector<Eigenpair>& pairs) {
  double largest = 0;
  for (const Eigenpair& j : pairs) {
    const Eigen::VectorXcd Bq = pencil.B(j.q);
    for (const Eigenpair& i : pairs)
      if (&i != &j && i.p.size() > 0) largest = std::max(largest, std::abs(i.p.dot(Bq)));
  }
  return largest;
}

void biorthogonalise(const Pencil& pencil, std::vector<Eigenpair>& pairs) {
  const auto has_no_adjoint = [](const Eigenpair& pair) { return pair.p.size() == 0; };
  if (pairs.empty() || std::ranges::any_of(pairs, has_no_adjoint)) return;
  separate(pencil, pairs);
  std::vector<Eigenpair*> order;
  order.reserve(pairs.size());
  for (Eigenpair& pair : pairs) order.push_back(&pair);
  std::ranges::sort(order, {}, [](const Eigenpair* pair) { return pair->p.squaredNorm(); });
  std::vector<Eigen::VectorXcd> Bq;
  Bq.reserve(pairs.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    Eigenpair& pair = *order[k];
    for (std::size_t l = 0; l < k; ++l) {
      pair.q -= order[l]->p.dot(pencil.B(pair.q)) * order[l]->q;
      pair.p -= Bq[l].dot(pair.p) * order[l]->p;
    }
    normalise(pencil, pair);
    Bq.push_back(pencil.B(pair.q));
    pair.residual = residual_of(pencil, pair);
    set_adjoint(pencil, pair.p, pair);
  }
}

void set_adjoint(const Pencil& pencil, Eigen::VectorXcd p, Eigenpair& pair) {
  const Eigen::VectorXcd Ap = pencil.A_adjoint(p), Bp = pencil.B_adjoint(p);
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

Eigenpair eigenpair_near(const SparsePencil& pencil, Complex target) {
  constexpr int most_shifts = 20, iterations_of_shift = 8;
  constexpr double tolerance = 1e-12, aside = 1e-6;  // of the shift from the eigenvalue
  Eigenpair pair{target, Eigen::VectorXcd::Ones(pencil.size()), 1};
  for (int shift = 0; shift < most_shifts; ++shift) {
    const Matrix shifted = pencil.matrix_A - target * pencil.matrix_B;
    const Eigen::UmfPackLU<Matrix> factors(shifted);
    for (int k = 0; k < iterations_of_shift; ++k) {
      const Eigen::VectorXcd right = pencil.B(pair.q), next = factors.solve(right);
      const Complex by = pair.q.dot(next) / pair.q.squaredNorm();
      pair.lambda = target + 1.0 / by;
      pair.q = next / next.norm();
      pair.residual = residual_of(pencil, pair);
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
