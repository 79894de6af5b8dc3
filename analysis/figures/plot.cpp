#include "analysis/figures/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "analysis/drawing/figure.hpp"
#include "analysis/figures/of_decomposition.hpp"
#include "analysis/figures/of_flag.hpp"
#include "analysis/figures/of_fluid.hpp"
#include "analysis/figures/of_lsa.hpp"
#include "analysis/figures/of_modes.hpp"
#include "analysis/figures/of_neutral.hpp"
#include "common/errors.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {
namespace {

Figure figure_of(const std::filesystem::path& path, const hdf5::Reader& file) {
  const std::string kind = file.text("/", "kind");
  if (kind == "lsa_curve") return figure_of_curve(file);
  if (kind == "lsa_map" || kind == "global_map") return figure_of_map(file);
  if (kind == "lsa_verdicts") return figure_of_verdicts(file);
  if (kind == "normal_modes") return figure_of_normal_modes(file);
  if (kind == "global_modes") return figure_of_spectrum(file);
  if (kind == "global_neutral") return figure_of_neutral_curve(file);
  if (kind == "decomposition") return figure_of_decomposition(file);
  if (kind == "flag_history") return figure_of_flag_history(file);
  if (kind == "flag_convergence") return figure_of_flag_convergence(file);
  if (kind == "flag_shapes") return figure_of_flag_shapes(file);
  if (kind == "fluid_history" || kind == "coupled_history") return figure_of_fluid_history(file);
  if (kind == "fluid_fields") return figure_of_fluid_fields(file);
  throw InputError(path.string(),
                   kind.empty() ? "is not a file that pennon wrote: it has no attribute `kind`"
                                : fmt::format("holds {}, which this pennon cannot draw", kind));
}

}  // namespace

bool has_no_picture(const std::filesystem::path& path) {
  const std::string kind = hdf5::Reader(path).text("/", "kind");
  return kind.ends_with("_checkpoint") || kind == "global_mode_frames";
}

Pictures pictures_of(const std::filesystem::path& path) {
  const hdf5::Reader file(path);
  const std::string kind = file.text("/", "kind");
  Pictures pictures;
  pictures.figures.push_back({"", figure_of(path, file)});
  if (kind == "flag_shapes" && file.shape("/position/000000", {hdf5::any, hdf5::any, 3})[0] > 1)
    pictures.strain = picture_of_strain(file);
  if (kind == "coupled_history")
    pictures.figures.push_back({"trailing_edge", figure_of_trailing_edge(file)});
  if (kind == "decomposition")
    std::ranges::move(figures_of_modes(file), std::back_inserter(pictures.figures));
  if (kind == "global_modes")
    std::ranges::move(figures_of_global_modes(file), std::back_inserter(pictures.figures));
  return pictures;
}

std::vector<std::filesystem::path> plot(const std::filesystem::path& path) {
  const Pictures found = pictures_of(path);
  std::filesystem::path stem = path;
  stem.replace_extension();
  std::vector<std::filesystem::path> pictures;
  for (const auto& [name, figure] : found.figures)
    std::ranges::copy(draw(figure, name.empty() ? stem.string() : stem.string() + "_" + name),
                      std::back_inserter(pictures));
  if (found.strain) pictures.push_back(draw(*found.strain, stem.string() + "_strain"));
  return pictures;
}

}  // namespace pennon::analysis
