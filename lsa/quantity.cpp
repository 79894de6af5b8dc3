#include "lsa/quantity.hpp"

#include <algorithm>
#include <cassert>

#include "lsa/two_d_ratio.hpp"

namespace pennon::lsa {
namespace {

template <double Stability::*member>
double at(const Point& point, const Theory& theory) {
  return solve(point, theory).*member;
}

template <double TwoDRatio::*member>
double ratio_at(const Point& point, const Theory& theory) {
  return two_d_ratio(point, theory).*member;
}

const std::vector<Quantity>& all() {
  using S = Stability;
  using B = StabilityBatch;
  static const std::vector<Quantity> quantities = {
      {"growth", "growth rate max Im omega (4.9), in V/L", "ω_i", false, at<&S::growth>,
       &B::growth},
      {"frequency", "frequency Re omega/(2 pi) of the growing root (4.7), in V/L", "f", false,
       at<&S::frequency>, &B::frequency},
      {"P", "P of (4.7), unstable where negative", "P", true, at<&S::P>, &B::P},
      {"mu_cr", "critical mass ratio (4.8b); nothing where no mass ratio is unstable", "μ_cr",
       false, at<&S::mu_cr>, &B::mu_cr},
      {"c_m", "added-mass coefficient m_a/(rho_f L) (4.5b)", "c_m", false, at<&S::c_m>, &B::c_m},
      {"omega_r_plus", "Re omega of the root with +P^1/2 (4.7), in V/L", "ω_r^+", true,
       at<&S::omega_r_plus>, &B::omega_r_plus},
      {"omega_i_plus", "Im omega of the root with +P^1/2 (4.7), in V/L", "ω_i^+", true,
       at<&S::omega_i_plus>, &B::omega_i_plus},
      {"omega_r_minus", "Re omega of the root with -P^1/2 (4.7), in V/L", "ω_r^-", true,
       at<&S::omega_r_minus>, &B::omega_r_minus},
      {"omega_i_minus", "Im omega of the root with -P^1/2 (4.7), in V/L", "ω_i^-", true,
       at<&S::omega_i_minus>, &B::omega_i_minus},
      {"minus_P", "-P, which figures 3b and 4b of the paper call omega_i^2", "-P", true,
       [](const Point& p, const Theory& t) { return -solve(p, t).P; }, nullptr},
      {"frequency_ratio", "frequency over that of the flag in two dimensions (4.10)",
       "ω_r / ω_r^2D", false, ratio_at<&TwoDRatio::frequency_ratio>, nullptr},
      {"growth_ratio", "growth rate over that of the flag in two dimensions", "ω_i / ω_i^2D", false,
       ratio_at<&TwoDRatio::growth_ratio>, nullptr},
      {"P_expansion", "P from its value in two dimensions (4.11a)", "P", true,
       ratio_at<&TwoDRatio::P_expansion>, nullptr},
      {"growth_ratio_expansion", "growth ratio for small k_x/k_y (4.11b)", "ω_i / ω_i^2D", false,
       ratio_at<&TwoDRatio::growth_ratio_expansion>, nullptr},
  };
  return quantities;
}

std::vector<std::string> names(bool for_maps) {
  std::vector<std::string> result;
  for (const Quantity& q : all())
    if (!for_maps || q.lanes != nullptr) result.push_back(q.name);
  return result;
}

}  // namespace

const std::vector<std::string>& curve_quantities() {
  static const std::vector<std::string> result = names(false);
  return result;
}

const std::vector<std::string>& map_quantities() {
  static const std::vector<std::string> result = names(true);
  return result;
}

const Quantity& quantity(const std::string& name) {
  const auto found = std::ranges::find(all(), name, &Quantity::name);
  assert(found != all().end());
  return *found;
}

}  // namespace pennon::lsa
