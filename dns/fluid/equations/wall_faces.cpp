#include "dns/fluid/equations/wall_faces.hpp"

#include <cmath>

namespace pennon::dns {

std::vector<double> coupled_chord(const OGrid& grid) {
  std::vector<double> chord;
  for (int i = grid.n_theta() / 2; i >= 0; --i) chord.push_back((1 + std::cos(grid.theta(i))) / 2);
  chord.front() = 0;
  return chord;
}

}  // namespace pennon::dns
