/// Modes, band by band, into an array [mode][component][point] of a file that the leading rank
/// writes.
#pragma once

#include <optional>
#include <string>

#include "analysis/decomposition/snapshots.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::decomposition {

class ModesWriter {
 public:
  /// Declares `name`, or with complex modes name_real and name_imag. `file`: none but on the
  /// leading rank.
  ModesWriter(hdf5::Writer* file, std::string name, const Layout&, std::size_t modes,
              bool is_complex, const std::string& meaning);

  /// Adds the same band of some modes, from `first_mode` on: values x modes. Every rank calls.
  void add(Band, std::size_t first_mode, const Eigen::MatrixXd&);
  void add(Band, std::size_t first_mode, const Eigen::MatrixXcd&);

 private:
  void add_to(const std::string& array, Band, std::size_t first_mode, const Eigen::MatrixXd&);

  hdf5::Writer* file_;
  std::string name_;
  std::size_t points_;
};

}  // namespace pennon::decomposition
