#include "dns/run/flow_mode_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::dns {
namespace {

using Complex = std::complex<double>;

constexpr const char* velocity_names[] = {"v", "w", "u"};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw InputError("dns.initial.global_modes",
                   fmt::format("names {}, which {}", path.string(), what));
}

std::string group_of(int number) {
  return fmt::format("/mode_{}", number);
}

void expect_mode(const hdf5::Reader& file, int number) {
  if (file.text("/", "kind") != "global_modes")
    fail(file.path(), "is no file of global modes, as pennon modes writes with [modes.global]");
  if (!file.contains(group_of(number) + "/zeta_real"))
    fail(file.path(), fmt::format("holds {} modes; dns.initial.global_mode = {} is not among them",
                                  file.shape("/growth", {hdf5::any})[0], number));
}

class ModeReader {
 public:
  ModeReader(const std::filesystem::path& path, int number, const Fluid& fluid,
             const FlagParameters& flag)
      : path_(path),
        file_(path),
        group_(group_of(number)),
        fluid_(fluid),
        plane_{1, fluid.extent().n_rho, fluid.extent().n_theta} {
    expect_mode(file_, number);
    expect_grid();
    expect("flow.Re", "Re", fluid.parameters().Re);
    expect("flow.U", "U", fluid.parameters().U);
    expect("flag.mu", "mu", flag.mu);
    expect("flag.K_B", "K_B", flag.K_B);
    expect("flag.K_S", "K_S", flag.K_S);
    expect("flag.nu_s", "nu_s", flag.nu_s);
    expect_wave();
  }

  FlowMode mode(int number) const {
    FlowMode mode(plane_, fluid_.components());
    const auto index = static_cast<std::size_t>(number - 1);
    const std::vector<double> growth = file_.list("/growth"),
                              omega = file_.list("/omega", growth.size());
    if (index >= growth.size()) fail(fmt::format("has no growth rate of mode {}", number));
    mode.lambda = {growth[index], omega[index]};
    mode.k_x = k_x();
    for (std::size_t c = 0; c < mode.u.size(); ++c) {
      const std::string name = velocity_names[c];
      if (!file_.contains("/base/" + name)) continue;  // no cross-flow, no wave: it is 0
      mode.steady_u[c] = field("/base/" + name);
      mode.u[c] = complex_field(name);
    }
    mode.steady_p = field("/base/p");
    mode.p = complex_field("p");
    for (const double value : file_.list("/base/is_inflow", static_cast<hsize_t>(plane_.n_theta)))
      mode.is_inflow.push_back(value != 0);
    const std::vector<double> real = finite_list(group_ + "/zeta_real", hdf5::any),
                              imaginary = finite_list(group_ + "/zeta_imag", real.size());
    const hdf5::Array nodes = file_.read("/flag", {real.size(), 2});
    file_.expect_finite("/flag", nodes.values);
    for (std::size_t j = 0; j < real.size(); ++j)
      mode.flag.push_back({nodes.values[2 * j], nodes.values[2 * j + 1]});
    for (std::size_t j = 0; j < real.size(); ++j) {
      mode.zeta.emplace_back(real[j], imaginary[j]);
      mode.zeta_t.push_back(mode.lambda * mode.zeta.back());
    }
    return mode;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { pennon::dns::fail(path_, what); }

  std::vector<double> finite_list(const std::string& name, hsize_t count) const {
    std::vector<double> values = file_.list(name, count);
    file_.expect_finite(name, values);
    return values;
  }

  double k_x() const { return file_.number("/", "k_x", 0); }

  void expect(const char* key, const char* attribute, double here) const {
    const double there = file_.number("/", attribute, NAN);
    constexpr double rounding = 1e-12;
    if (!(std::abs(there - here) <= rounding * std::abs(here)))
      fail(fmt::format("was made with {} = {:.6g}; here it is {:.6g}", key, there, here));
  }

  void expect_grid() const {
    // x, y, z; files of earlier versions have no x.
    const hdf5::Shape shape = file_.shape("/points");
    const hsize_t numbers = !shape.empty() && shape.back() == 2 ? 2 : 3;
    const hdf5::Array points = file_.read("/points", {hdf5::any, hdf5::any, numbers});
    const auto rows = static_cast<hsize_t>(plane_.n_rho), columns = points.shape[1] - 1;
    if (points.shape[0] - 1 != rows || columns != static_cast<hsize_t>(plane_.n_theta))
      fail(fmt::format("was made on {} x {} cells; here they are {} x {} (dns.n_rho, dns.n_theta)",
                       points.shape[0] - 1, columns, rows, plane_.n_theta));
    const OGrid& grid = fluid_.grid();
    double largest = 0;
    for (int j = 0; j <= plane_.n_rho; ++j)
      for (int i = 0; i < plane_.n_theta; ++i) {
        const std::size_t corner =
            static_cast<std::size_t>(j) * points.shape[1] + static_cast<std::size_t>(i);
        const double* end = points.values.data() + (corner + 1) * numbers;
        const Complex there(end[-2], end[-1]);
        largest = std::max(largest, std::abs(there - OGrid::place(grid.rho(j), grid.theta(i))));
      }
    constexpr double rounding = 1e-9;
    if (!(largest < rounding))
      fail(
          "was made on another grid: dns.R, dns.wall_spacing or dns.wake_clustering are not those "
          "here");
  }

  // A whole number of waves along the span.
  void expect_wave() const {
    const Span& span = fluid_.span();
    const bool has_u = file_.contains("/base/u");
    if (!span.has_span()) {
      if (k_x() != 0)
        fail(fmt::format("has waves along the span (k_x = {:.6g}); here there are two dimensions",
                         k_x()));
    } else {
      const double waves = k_x() * span.length() / (2 * std::numbers::pi);
      constexpr double slack = 1e-9;
      if (std::abs(waves - std::round(waves)) > slack)
        fail(
            fmt::format("has {:.6g} waves (k_x = {:.6g}) in a span of flag.gamma = {:.6g}; a whole "
                        "number fits",
                        waves, k_x(), span.length()));
      const double nodes = file_.number("/", "n_x", NAN);
      if (k_x() != 0 && !(std::abs(nodes * std::abs(waves) - span.planes()) < slack * nodes))
        fail(
            fmt::format("was made with {:.6g} spanwise nodes in a wave; here dns.n_x = {} gives it "
                        "{:.6g}, which modes.global.n_x should be",
                        nodes, span.planes(), span.planes() / std::abs(waves)));
    }
    if (fluid_.parameters().U != 0 && !has_u)
      fail("has no velocity along x, which flow.U needs; modes with a wave along the span have it");
  }

  Field<double> field(const std::string& name) const {
    Field<double> f(plane_);
    fill(name, [&](int j, int i, double value) { f.row(0, j)[i] = value; });
    return f;
  }
  Field<Complex> complex_field(const std::string& name) const {
    Field<Complex> f(plane_);
    fill(group_ + "/" + name + "_real",
         [&](int j, int i, double value) { f.row(0, j)[i].real(value); });
    fill(group_ + "/" + name + "_imag",
         [&](int j, int i, double value) { f.row(0, j)[i].imag(value); });
    return f;
  }
  template <class Set>
  void fill(const std::string& name, const Set& set) const {
    const hdf5::Array array = file_.read(
        name, {static_cast<hsize_t>(plane_.n_rho), static_cast<hsize_t>(plane_.n_theta)});
    file_.expect_finite(name, array.values);
    std::size_t k = 0;
    for (int j = 0; j < plane_.n_rho; ++j)
      for (int i = 0; i < plane_.n_theta; ++i) set(j, i, array.values[k++]);
  }

  std::filesystem::path path_;
  hdf5::Reader file_;
  std::string group_;
  const Fluid& fluid_;
  Extent plane_;
};

}  // namespace

void expect_flow_mode(const std::filesystem::path& file, int number) {
  expect_mode(hdf5::Reader(file), number);
}

FlowMode read_flow_mode(const std::filesystem::path& file, int number, const Fluid& fluid,
                        const FlagParameters& flag) {
  return ModeReader(file, number, fluid, flag).mode(number);
}

}  // namespace pennon::dns
