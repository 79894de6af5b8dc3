#include "lsa/root.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_roots.h>

#include <exception>
#include <limits>
#include <memory>

namespace pennon::lsa {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int most_iterations = 200;

// A C++ function as GSL calls it: an exception must not cross the C code, so it waits here.
class Guarded {
 public:
  Guarded(const std::function<double(double)>& f, double sign) : f_(f), sign_(sign) {
    function_.function = [](double t, void* self) { return static_cast<Guarded*>(self)->call(t); };
    function_.params = this;
  }
  gsl_function* get() { return &function_; }
  void rethrow() const {
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  double call(double t) {
    try {
      return sign_ * f_(t);
    } catch (...) {
      fault_ = std::current_exception();
      return 0;
    }
  }

  const std::function<double(double)>& f_;
  double sign_;
  gsl_function function_{};
  std::exception_ptr fault_;
};

}  // namespace

double find_root(const std::function<double(double)>& f, double a, double b) {
  if (f(a) == 0) return a;
  if (f(b) == 0) return b;
  gsl_set_error_handler_off();
  Guarded guarded(f, 1);
  const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  gsl_root_fsolver_set(solver.get(), guarded.get(), a, b);
  for (int i = 0; i < most_iterations; ++i) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) break;
    guarded.rethrow();
    const double low = gsl_root_fsolver_x_lower(solver.get());
    const double high = gsl_root_fsolver_x_upper(solver.get());
    if (gsl_root_test_interval(low, high, 0, epsilon) == GSL_SUCCESS) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

double find_maximum(const std::function<double(double)>& f, double a, double inside, double b) {
  gsl_set_error_handler_off();
  Guarded guarded(f, -1);
  const std::unique_ptr<gsl_min_fminimizer, void (*)(gsl_min_fminimizer*)> minimizer(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free);
  if (gsl_min_fminimizer_set(minimizer.get(), guarded.get(), inside, a, b) != GSL_SUCCESS) {
    guarded.rethrow();
    return inside;  // a plateau: no value around it is smaller
  }
  for (int i = 0; i < most_iterations; ++i) {
    if (gsl_min_fminimizer_iterate(minimizer.get()) != GSL_SUCCESS) break;
    guarded.rethrow();
    const double low = gsl_min_fminimizer_x_lower(minimizer.get());
    const double high = gsl_min_fminimizer_x_upper(minimizer.get());
    if (gsl_min_test_interval(low, high, 0, 1e-10) == GSL_SUCCESS) break;
  }
  return gsl_min_fminimizer_x_minimum(minimizer.get());
}

}  // namespace pennon::lsa
