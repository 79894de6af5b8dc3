/// The three phases of a run (section 5.1 of the paper), told from the spanwise amplitudes of the
/// trailing edge. With e_n the envelope of |zeta_n| over one period and e = (sum e_n^2)^(1/2):
///
/// Phase I, growth, ends when e reaches half its largest value, if it stops growing (within 10 %)
/// before the last fifth of the run: there Stuart's and Landau's growth rate is 3/4 of the linear
/// one. (The paper lets phase II begin with the two-dimensional mode, which grows once the waves
/// that a run started with are large.)
///
/// Phase II, interaction, ends when a single mode rules for good: from then to the end of the run
///     - the mode that is largest at the end holds 90 % of e^2;
///     - e stays within 10 % of its mean over the last fifth of the run.
/// In two dimensions there is one mode, and only e counts.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pennon::analysis {

struct Phases {
  std::optional<double> I_end, II_end;
  std::size_t ruling = 0;          ///< n of the mode that is largest at the end
  std::vector<std::string> notes;  ///< why an end is not there
};

/// `amplitudes` |zeta_n| as [n][row]; `period` of the flapping.
Phases find_phases(const std::vector<double>& t, const std::vector<std::vector<double>>& amplitudes,
                   double period);

}  // namespace pennon::analysis
