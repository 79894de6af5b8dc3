#include "analysis/decomposition/given_modes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/signal/series.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::decomposition {
namespace {

using Complex = std::complex<double>;

// Between the nodes by cubic splines.
std::function<Complex(double)> profile(const std::vector<double>& y,
                                       const std::vector<double>& real,
                                       const std::vector<double>& imaginary) {
  const auto re = std::make_shared<analysis::Spline>(y, real);
  const auto im = std::make_shared<analysis::Spline>(y, imaginary);
  return [re, im](double at) { return Complex((*re)(at), (*im)(at)); };
}

}  // namespace

std::vector<GivenMode> given_modes(const modes::NormalModes& family) {
  std::vector<GivenMode> given;
  for (const modes::NormalMode& mode : family.modes)
    given.push_back({fmt::format("n = {}, m = {}", mode.n, mode.m),
                     mode.k_x,
                     {0, mode.omega},
                     [shape = mode.shape](double y) { return Complex(shape(y)); },
                     mode.k_x == 0});
  return given;
}

std::vector<GivenMode> given_global_modes(const std::filesystem::path& path,
                                          std::optional<std::int64_t> count) {
  const hdf5::Reader file(path);
  if (const std::string kind = file.text("/", "kind"); kind != "global_modes")
    file.fail(
        fmt::format("holds {}, where the global modes of pennon modes are needed (global_modes.h5)",
                    kind.empty() ? "nothing that pennon wrote" : kind));
  const std::vector<double> growth = file.list("/growth"),
                            omega = file.list("/omega", growth.size()), y = file.list("/y");
  if (y.size() < 3 || !std::ranges::is_sorted(y, std::less_equal()))
    file.fail("has no increasing y of three nodes at least in /y");
  const double k_x = file.number("/", "k_x");
  std::vector<double> is_box(growth.size(), 0.0);
  if (file.contains("/is_box")) is_box = file.list("/is_box", growth.size());
  if (count && *count > static_cast<std::int64_t>(growth.size()))
    file.fail(fmt::format("holds {} modes; decompose.n_modes = {}", growth.size(), *count));
  std::vector<GivenMode> given;
  for (std::size_t j = 0; j < growth.size(); ++j) {
    if (count ? static_cast<std::int64_t>(j) >= *count : is_box[j] != 0) continue;
    const std::string group = fmt::format("/mode_{}/", j + 1);
    const auto Y = profile(y, file.list(group + "zeta_real", y.size()),
                           file.list(group + "zeta_imag", y.size()));
    const std::string name = fmt::format("mode {}", j + 1);
    given.push_back({k_x != 0 ? name + ", along +x" : name, k_x, {growth[j], omega[j]}, Y});
    if (k_x != 0) given.push_back({name + ", along -x", -k_x, {growth[j], omega[j]}, Y});
  }
  if (given.empty()) file.fail("holds no mode of the flag or its wake");
  return given;
}

}  // namespace pennon::decomposition
