#include "modes/global/matrix_free/map_eigenpairs.hpp"

#include <arpack.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "common/errors.hpp"

namespace pennon::modes {
namespace {

// One run of ARPACK: its arrays, and the order in which it wants to be called.
class Arnoldi {
 public:
  Arnoldi(const Eigen::VectorXd& start, const MapSettings& settings)
      : size_(static_cast<a_int>(start.size())),
        settings_(settings),
        residual_(start),
        vectors_(size_, settings.basis),
        work_(3 * Eigen::Index{size_}),
        inner_work_(3 * settings.basis * (settings.basis + 2)) {
    parameters_[0] = 1;  // exact shifts
    parameters_[2] = settings.most_restarts;
    parameters_[6] = 1;  // A x = lambda x
  }

  void run(const LinearMap& map) {
    constexpr int done = 99;
    for (a_int task = 0; task != done;) {
      dnaupd_c(&task, "I", size_, "LM", settings_.count, settings_.tolerance, residual_.data(),
               settings_.basis, vectors_.data(), size_, parameters_.data(), pointers_.data(),
               work_.data(), inner_work_.data(), static_cast<a_int>(inner_work_.size()), &info_);
      if (task != done) map(work_.data() + pointers_[0] - 1, work_.data() + pointers_[1] - 1);
    }
    if (info_ != 0 || parameters_[4] < settings_.count)
      throw SolverError(fmt::format(
          "Arnoldi's method found {} of {} eigenvalues in {} restarts (ARPACK's info {}); take a "
          "larger basis or a longer time",
          parameters_[4], settings_.count, parameters_[2], info_));
  }

  std::vector<MapEigenpair> eigenpairs() {
    const Eigen::Index columns = settings_.count + 1;
    Eigen::VectorXd real(columns), imaginary(columns), work(3 * settings_.basis);
    Eigen::MatrixXd vectors(size_, columns);
    const std::vector<a_int> select(static_cast<std::size_t>(settings_.basis));
    constexpr a_int want_vectors = 1;
    dneupd_c(want_vectors, "A", select.data(), real.data(), imaginary.data(), vectors.data(), size_,
             0, 0, work.data(), "I", size_, "LM", settings_.count, settings_.tolerance,
             residual_.data(), settings_.basis, vectors_.data(), size_, parameters_.data(),
             pointers_.data(), work_.data(), inner_work_.data(),
             static_cast<a_int>(inner_work_.size()), &info_);
    if (info_ != 0) throw SolverError(fmt::format("ARPACK's dneupd says {}", info_));
    // A complex pair takes two columns: real and imaginary part of the vector above the axis.
    std::vector<MapEigenpair> pairs;
    for (Eigen::Index k = 0; k < parameters_[4]; ++k) {
      MapEigenpair& pair = pairs.emplace_back();
      pair.value = {real[k], std::abs(imaginary[k])};
      pair.vector = vectors.col(k).cast<std::complex<double>>();
      if (imaginary[k] == 0) continue;
      ++k;
      pair.vector += std::complex<double>(0, 1) * vectors.col(k);
    }
    return pairs;
  }

 private:
  a_int size_;
  MapSettings settings_;
  Eigen::VectorXd residual_;
  Eigen::MatrixXd vectors_;
  Eigen::VectorXd work_, inner_work_;
  std::array<a_int, 11> parameters_{};
  std::array<a_int, 14> pointers_{};
  a_int info_ = 1;  // begins with residual_
};

void normalise(const LinearMap& map, MapEigenpair& pair) {
  pair.vector.normalize();
  const Eigen::VectorXd real = pair.vector.real(), imaginary = pair.vector.imag();
  Eigen::VectorXd of_real(real.size()), of_imaginary = Eigen::VectorXd::Zero(real.size());
  map(real.data(), of_real.data());
  if (pair.value.imag() != 0) map(imaginary.data(), of_imaginary.data());
  const Eigen::VectorXcd image =
      of_real.cast<std::complex<double>>() + std::complex<double>(0, 1) * of_imaginary;
  pair.residual = (image - pair.value * pair.vector).norm() / std::abs(pair.value);
}

}  // namespace

std::vector<MapEigenpair> largest_eigenpairs(const LinearMap& map, const Eigen::VectorXd& start,
                                             const MapSettings& settings) {
  Arnoldi arnoldi(start, settings);
  arnoldi.run(map);
  std::vector<MapEigenpair> pairs = arnoldi.eigenpairs();
  for (MapEigenpair& pair : pairs) normalise(map, pair);
  std::ranges::sort(pairs, std::ranges::greater(),
                    [](const MapEigenpair& pair) { return std::abs(pair.value); });
  return pairs;
}

}  // namespace pennon::modes
