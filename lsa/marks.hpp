/// Published outcomes as marks on a picture over two axes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/io/hdf5.hpp"
#include "lsa/axes.hpp"
#include "lsa/outcomes.hpp"

namespace pennon::lsa {

/// The outcome's coordinate along an axis; none where the table does not say it.
std::optional<double> coordinate(const Outcome&, Axis);

/// Places on a picture and what is known of them: 1 unstable, 0 stable.
struct Marks {
  std::vector<double> x, y, unstable;

  void add(double along_x, double along_y, bool is_unstable);
};

/// Writes /marks/x, /marks/y and /marks/unstable; nothing without marks.
void write(const Marks&, hdf5::Writer&);

/// Writes as marks the outcomes without cross-flow (with
/// it, where the model has it) that have both coordinates. `y` may be "mu_cr", where mu is meant.
void write_marks(hdf5::Writer&, const std::vector<Outcome>&, Axis x, const std::string& y,
                 bool cross_flow);

}  // namespace pennon::lsa
