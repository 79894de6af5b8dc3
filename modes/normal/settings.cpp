#include "modes/normal/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "modes/normal/bessel_zero.hpp"

namespace pennon::modes {
namespace {

// Numbers of all shapes together: 800 MB in modes.h5.
constexpr double most_shape_values = 1e8;

const std::vector<std::string>& family_names() {
  static const std::vector<std::string> names = {"bessel", "hanging_chain", "in_vacuo"};
  return names;
}

void check_waves(const Settings& settings, const FlagParameters& flag, Faults& faults) {
  for (const std::int64_t n : settings.n) {
    if (n > 0 && !flag.gamma)
      faults.about("modes.normal.n",
                   fmt::format("modes.normal.n holds {}, but without flag.gamma the "
                               "flag is two-dimensional and has n = 0 only",
                               n));
    else if (n > largest_n && settings.family == Family::bessel)
      faults.about("modes.normal.n",
                   fmt::format("modes.normal.n holds {}, but the family bessel has n = 0 to {}", n,
                               largest_n));
  }
  const double modes =
      static_cast<double>(mode_range(settings, flag).n.size()) * static_cast<double>(settings.m);
  if (modes * static_cast<double>(settings.shape_points) > most_shape_values)
    faults.about("modes.normal.shape_points",
                 fmt::format("modes.normal asks for {} modes of {} shape_points each; all together "
                             "must be at most {:.0e} values",
                             modes, settings.shape_points, most_shape_values));
}

void check_shape(const DecomposeSettings& decompose, const FlagParameters& flag, Faults& faults) {
  const std::size_t longest = std::max(decompose.A.size(), decompose.B.size());
  const char* longer = decompose.A.size() == longest ? "modes.decompose.A" : "modes.decompose.B";
  if (!flag.gamma && (longest > 1 || !decompose.B.empty()))
    faults.about(
        decompose.B.empty() ? "modes.decompose.A" : "modes.decompose.B",
        "modes.decompose holds amplitudes of spanwise waves, but without flag.gamma the flag "
        "is two-dimensional: only A = [A_0] is right");
  else if (longest > largest_n + 1)
    faults.about(longer, fmt::format("{} holds {} amplitudes, but n = 0 to {} are offered", longer,
                                     longest, largest_n));
  else if (!decompose.B.empty() && decompose.B.front() != 0)
    faults.about("modes.decompose.B",
                 fmt::format("modes.decompose.B begins with B_0 = {}, which has no effect since "
                             "sin(0) = 0; it must be 0",
                             decompose.B.front()));
}

void check_decompose(const Settings& settings, const FlagParameters& flag, Faults& faults) {
  const DecomposeSettings& decompose = settings.decompose;
  const bool has_shape = !decompose.A.empty() || !decompose.B.empty();
  const bool has_samples = !decompose.samples.empty();
  if (!settings.is_given)
    faults.about("modes.decompose",
                 "[modes.decompose] needs [modes.normal], which says into which "
                 "modes to decompose");
  if (has_shape && has_samples)
    faults.about("modes.decompose.samples",
                 "modes.decompose has both samples and amplitudes A, B; give one of the two");
  else if (has_shape)
    check_shape(decompose, flag, faults);
  else if (!has_samples)
    faults.about("modes.decompose",
                 "[modes.decompose] has nothing to decompose; give samples, the "
                 "path of a CSV file, or A and B, the amplitudes of (5.1)");
}

}  // namespace

void check_family(const Settings& settings, std::int64_t m, const std::string& table,
                  const FlagParameters& flag, const FlowParameters& flow, Faults& faults) {
  if (settings.family != Family::in_vacuo) return;
  if (!(flow.Re > 0) && !(flag.K_B > 0))
    faults.about("modes.normal.family",
                 "modes.normal.family = \"in_vacuo\" needs a tension (flow.Re, but the case has no "
                 "[flow]) or a bending stiffness (flag.K_B, but it is 0)");
  if (m > most_modes_in_vacuo)
    faults.about(table + ".m", fmt::format("{}.m = {}, but the family in_vacuo has m = 1 to {}",
                                           table, m, most_modes_in_vacuo));
  else if (m > settings.elements / 2)
    faults.about(table + ".m",
                 fmt::format("{}.m = {} is too many for modes.normal.elements = {}: two elements a "
                             "mode are the least; take {} or more",
                             table, m, settings.elements, 2 * m));
}

const std::string& name_of(Family family) {
  return family_names()[static_cast<std::size_t>(family)];
}

void declare(Schema& schema, Settings& settings) {
  schema
      .table("modes.normal", "Normal modes of the flag without fluid loading.", &settings.is_given)
      .key({"family", choice(settings.family, family_names()),
            "bessel: (C 5); hanging_chain: tension T_0 (1-y); in_vacuo: with K_B and the tension "
            "below"})
      .key({"n", &settings.n, "waves along the span, k_x = 2 pi n/gamma", Range{0, 1e6}, false,
            "[0, 1, 2], in two dimensions [0]"})
      .key({"m", &settings.m, "modes along the chord for each n, m = 1 to this",
            Range{1, largest_m}})
      .key({"tension", choice(settings.tension, {"blasius", "linear", "constant", "wedge"}),
            "of in_vacuo, times T_0 = 1.3 Re^-1/2: 1 - sqrt(y); 1 - y; 1; 1 - y with the mass and "
            "spanwise tension of (C 1)"})
      .key({"elements", &settings.elements, "of in_vacuo: elements along the chord", Range{8, 1e4}})
      .key({"shape_points", &settings.shape_points, "points along the chord of each shape written",
            Range{2, 1e6}});
  schema
      .table("modes.decompose", "A displacement as a sum of the modes of [modes.normal].",
             &settings.decompose.is_given)
      .key({"samples", &settings.decompose.samples,
            "CSV file with the columns x, y, zeta, scaled by L (in two dimensions y, zeta)"})
      .key({"A", &settings.decompose.A, "A_0, A_1, ... of the initial shape (5.1), scaled by L"})
      .key({"B", &settings.decompose.B,
            "B_0 = 0, B_1, ... of the initial shape (5.1), scaled by L"});
}

void check(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow,
           bool is_asked_for, Faults& faults) {
  if (settings.is_given || is_asked_for) {
    check_family(settings, settings.m, "modes.normal", flag, flow, faults);
    check_waves(settings, flag, faults);
  }
  if (settings.decompose.is_given) check_decompose(settings, flag, faults);
}

ModeRange mode_range(const Settings& settings, const FlagParameters& flag) {
  ModeRange range{{}, static_cast<int>(settings.m)};
  for (const std::int64_t n : settings.n) range.n.push_back(static_cast<int>(n));
  if (range.n.empty()) range.n = flag.gamma ? std::vector<int>{0, 1, 2} : std::vector<int>{0};
  std::ranges::sort(range.n);
  range.n.erase(std::unique(range.n.begin(), range.n.end()), range.n.end());
  return range;
}

}  // namespace pennon::modes
