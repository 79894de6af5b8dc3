#include "dns/fluid/step.hpp"

#include <fmt/format.h>

#include "common/errors.hpp"

namespace pennon::dns {

void combine(double a, const Field<double>& f, double b, const Field<double>& g,
             Field<double>& sum) {
  const double *from = f.values().data(), *other = g.values().data();
  double* to = sum.values().data();
  for (std::size_t k = 0; k < sum.values().size(); ++k) to[k] = a * from[k] + b * other[k];
}

void fail_at(double t, const std::string& what) {
  throw SolverError(fmt::format("at t = {:.6g}: {}", t, what));
}

}  // namespace pennon::dns
