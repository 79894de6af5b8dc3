#include "dns/run/prescribed_motion.hpp"

#include <cmath>
#include <numbers>

#include "common/smooth_rise.hpp"

namespace pennon::dns {
namespace {

using std::numbers::pi;

}  // namespace

WallMotion prescribed_motion(const MotionSettings& motion, const OGrid& grid, const Span& span,
                             const ShapeFunction& zeta) {
  std::vector<double> chord, stations;
  for (int i = 0; i < grid.n_theta(); ++i) chord.push_back((1 + std::cos(grid.theta(i))) / 2);
  for (int m = 0; m < span.local_planes(); ++m) stations.push_back(span.x(m));
  const double k_x =
      span.has_span() ? 2 * pi * static_cast<double>(motion.waves) / span.length() : 0.0;
  return [motion, zeta, chord, stations, k_x](double t, WallShape& shape) {
    const double omega = 2 * pi * motion.frequency;
    const double amplitude = motion.amplitude * smooth_rise(t, motion.ramp);
    std::size_t corner = 0;
    for (const double x : stations) {
      const double local = amplitude * std::cos(k_x * x);
      for (const double y : chord) {
        double &d_y = shape.y[corner], &d_z = shape.z[corner];
        ++corner;
        d_y = d_z = 0;
        switch (motion.kind) {
          case MotionKind::rigid:
            break;
          case MotionKind::heave:
            d_z = local * std::sin(omega * t + motion.phase);
            break;
          case MotionKind::pitch: {
            const double angle = local * std::sin(omega * t + motion.phase);
            d_y = (y - motion.axis) * (std::cos(angle) - 1);
            d_z = (y - motion.axis) * std::sin(angle);
            break;
          }
          case MotionKind::wave:
            d_z = local * (motion.envelope == Envelope::linear ? y : 1.0) *
                  std::sin(motion.k_y * y - omega * t + motion.phase);
            break;
          case MotionKind::mode:
            d_z = amplitude * zeta(x, y) * std::sin(omega * t + motion.phase);
            break;
        }
      }
    }
  };
}

}  // namespace pennon::dns
