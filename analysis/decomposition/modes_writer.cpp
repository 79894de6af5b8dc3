#include "analysis/decomposition/modes_writer.hpp"

#include <algorithm>

#include "common/parallel/ranks.hpp"

namespace pennon::decomposition {

ModesWriter::ModesWriter(hdf5::Writer* file, std::string name, const Layout& layout,
                         std::size_t modes, bool is_complex, const std::string& meaning)
    : file_(file), name_(std::move(name)), points_(layout.points) {
  if (file_ == nullptr) return;
  const hdf5::Shape shape = {modes, layout.components.size(), layout.points};
  if (!is_complex) {
    file_->declare(name_, shape, {{"meaning", meaning}});
    return;
  }
  file_->declare(name_ + "_real", shape, {{"meaning", meaning + ", real part"}});
  file_->declare(name_ + "_imag", shape, {{"meaning", meaning + ", imaginary part"}});
}

void ModesWriter::add(Band band, std::size_t first_mode, const Eigen::MatrixXd& phi) {
  add_to(name_, band, first_mode, phi);
}

void ModesWriter::add(Band band, std::size_t first_mode, const Eigen::MatrixXcd& phi) {
  add_to(name_ + "_real", band, first_mode, phi.real());
  add_to(name_ + "_imag", band, first_mode, phi.imag());
}

void ModesWriter::add_to(const std::string& array, Band band, std::size_t first_mode,
                         const Eigen::MatrixXd& phi) {
  const auto modes = static_cast<std::size_t>(phi.cols());
  const std::vector<double> bands =
      ranks::gather(std::vector{static_cast<double>(band.first), static_cast<double>(band.count)});
  const std::vector<double> values =
      ranks::gather({phi.data(), static_cast<std::size_t>(phi.size())});
  if (file_ == nullptr) return;
  const double* next = values.data();
  for (std::size_t k = 0; k < bands.size(); k += 2) {
    const auto first = static_cast<std::size_t>(bands[k]),
               count = static_cast<std::size_t>(bands[k + 1]);
    for (std::size_t j = 0; j < modes; ++j, next += count)
      for (std::size_t done = 0; done < count;) {
        const std::size_t component = (first + done) / points_, point = (first + done) % points_;
        const std::size_t length = std::min(points_ - point, count - done);
        file_->write_part(array, {first_mode + j, component, point}, {1, 1, length},
                          {next + done, length});
        done += length;
      }
  }
}

}  // namespace pennon::decomposition
