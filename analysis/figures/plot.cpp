#include "analysis/figures/plot.hpp"

#include <fmt/format.h>

#include "analysis/drawing/figure.hpp"
#include "analysis/figures/of_flag.hpp"
#include "analysis/figures/of_fluid.hpp"
#include "analysis/figures/of_global_modes.hpp"
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

std::vector<std::filesystem::path> plot(const std::filesystem::path& path) {
  const hdf5::Reader file(path);
  std::filesystem::path stem = path;
  stem.replace_extension();
  std::vector<std::filesystem::path> pictures = draw(figure_of(path, file), stem);
  if (file.text("/", "kind") == "flag_shapes" && file.shape("/position/000000")[0] > 1)
    pictures.push_back(draw(picture_of_strain(file), stem.string() + "_strain"));
  if (file.text("/", "kind") == "coupled_history")
    for (const std::filesystem::path& picture :
         draw(figure_of_trailing_edge(file), stem.string() + "_trailing_edge"))
      pictures.push_back(picture);
  if (file.text("/", "kind") == "global_modes")
    for (const NamedFigure& named : figures_of_global_modes(file))
      for (const std::filesystem::path& picture :
           draw(named.figure, stem.string() + "_" + named.name))
        pictures.push_back(picture);
  return pictures;
}

}  // namespace pennon::analysis
