#include "modes/normal/study.hpp"

#include "modes/normal/bessel.hpp"
#include "modes/normal/hanging_chain.hpp"
#include "modes/normal/initial_shape.hpp"

namespace pennon::modes {
namespace {

NormalModes modes_of(const Settings& settings, const FlagParameters& flag,
                     const FlowParameters& flow) {
  const ModeRange range = mode_range(settings, flag);
  switch (settings.family) {
    case Family::bessel:
      return bessel_modes(range, flag, flow);
    case Family::hanging_chain:
      return hanging_chain_modes(range, flag, flow);
    case Family::in_vacuo:
      break;
  }
  return in_vacuo_modes(range, flag, flow, settings.tension, static_cast<int>(settings.elements));
}

Decomposition decomposition_of(const DecomposeSettings& settings, const NormalModes& family) {
  if (!settings.samples.empty())
    return decompose(family, read_samples(settings.samples, family.gamma.has_value()),
                     settings.samples);
  const InitialShape shape(settings.A, settings.B, family.gamma);
  return decompose(family, shape, shape.largest_wave());
}

}  // namespace

Result run(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow) {
  Result result{modes_of(settings, flag, flow), {}, {}, std::nullopt};
  const auto last = static_cast<double>(settings.shape_points - 1);
  for (std::int64_t i = 0; i < settings.shape_points; ++i)
    result.y.push_back(static_cast<double>(i) / last);
  for (const NormalMode& mode : result.modes.modes) {
    std::vector<double>& shape = result.shapes.emplace_back();
    for (const double y : result.y) shape.push_back(mode.shape(y));
  }
  if (settings.decompose.is_given)
    result.decomposition = decomposition_of(settings.decompose, result.modes);
  return result;
}

}  // namespace pennon::modes
