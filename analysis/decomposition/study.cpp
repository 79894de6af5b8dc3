#include "analysis/decomposition/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/decomposition/combined_modes.hpp"
#include "analysis/decomposition/modes_writer.hpp"
#include "analysis/decomposition/pod.hpp"
#include "analysis/decomposition/spanwise_wave.hpp"
#include "analysis/decomposition/triangular_factor.hpp"
#include "common/errors.hpp"
#include "common/io/hdf5.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::decomposition {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXd;

constexpr const char* file_name = "decomposition.h5";
constexpr std::size_t peaks_kept = 5;

std::vector<double> row_major(const Eigen::MatrixXd& matrix) {
  std::vector<double> values(static_cast<std::size_t>(matrix.size()));
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), matrix.rows(), matrix.cols()) = matrix;
  return values;
}

std::vector<double> list_of(const VectorXd& values) {
  return {values.begin(), values.end()};
}

template <class Function>
std::vector<double> each_of(const std::vector<DmdMode>& modes, const Function& number) {
  std::vector<double> values;
  values.reserve(modes.size());
  for (const DmdMode& mode : modes) values.push_back(number(mode));
  return values;
}

// What is decomposed, and how; then what was found, array by array.
class ResultFile {
 public:
  ResultFile(const Decomposition& found, const OutputFolder& folder) {
    if (!ranks::is_leading()) return;
    file_.emplace(folder / file_name);

    file_->attributes({{"kind", "decomposition"},
                       {"method", name_of(found.settings.method)},
                       {"source", found.layout.name},
                       {"quantity", found.layout.quantity},
                       {"components", fmt::format("{}", fmt::join(found.layout.components, ","))},
                       {"mean", found.settings.removes_mean() ? "removed" : "kept"},
                       {"numbers", found.is_complex ? "complex" : "real"},
                       {"dt", found.times.dt}});
    write("/t", {found.times.t.size()}, found.times.t, "times of the snapshots");
    const Layout& layout = found.layout;
    if (layout.dimensions > 0)
      write("/coordinates", {layout.points, layout.dimensions}, layout.coordinates,
            "of each point; the modes' last index counts the points");
    if (layout.stations)
      file_->attributes({{"span", layout.stations->span},
                         {"stations", static_cast<std::int64_t>(layout.stations->count)}});
  }

  void write(const std::string& name, const hdf5::Shape& shape, const std::vector<double>& values,
             const std::string& meaning) {
    if (file_) file_->write(name, shape, values, {{"meaning", meaning}});
  }
  void write_complex(const std::string& name, const MatrixXcd& rows, const std::string& meaning) {
    const hdf5::Shape shape = {static_cast<hsize_t>(rows.rows()),
                               static_cast<hsize_t>(rows.cols())};
    write(name + "_real", shape, row_major(rows.real()), meaning + ", real part");
    write(name + "_imag", shape, row_major(rows.imag()), meaning + ", imaginary part");
  }
  hdf5::Writer* writer() { return file_ ? &*file_ : nullptr; }
  void finish() {
    if (file_) file_->finish();
  }

 private:
  std::optional<hdf5::Writer> file_;
};

// The mean of each value and its weight, without which the data are not rebuilt.
template <class Scalar>
class ValuesWriter {
 public:
  ValuesWriter(ResultFile& file, const Layout& layout)
      : mean_(file.writer(), "/mean", layout, 1, !std::is_same_v<Scalar, double>,
              "of each value over the snapshots"),
        weight_(file.writer(), "/weight", layout, 1, false, "of each value, its mean over time") {}
  void add(const BandOfData<Scalar>& data) {
    mean_.add(data.band, 0, DenseMatrix<Scalar>(data.mean));
    weight_.add(data.band, 0, Eigen::MatrixXd(data.mean_weight));
  }

 private:
  ModesWriter mean_, weight_;
};

template <class Scalar, class Mode>
void write_modes(const Bands<Scalar>& bands, const DenseMatrix<Mode>& combination,
                 const std::string& meaning, ResultFile& file) {
  ModesWriter writer(file.writer(), "/modes", bands.layout(),
                     static_cast<std::size_t>(combination.cols()), !std::is_same_v<Mode, double>,
                     meaning);
  ValuesWriter<Scalar> values(file, bands.layout());
  for_each_band_of_modes<Scalar, Mode>(
      bands, combination, [&](const BandOfData<Scalar>& data, const DenseMatrix<Mode>& phi) {
        writer.add(data.band, 0, phi);
        values.add(data);
      });
}

// As many as are asked for, else ten or all there are.
std::size_t number_of_modes(std::optional<std::int64_t> asked, Index there,
                            const std::string& why) {
  constexpr Index unasked = 10;
  if (asked && *asked > there)
    throw InputError("[decompose]",
                     fmt::format("decompose.n_modes = {} is more than the {} there are: {}", *asked,
                                 there, why));
  return static_cast<std::size_t>(asked ? *asked : std::min(unasked, there));
}

template <class Scalar>
void find_pod(const Bands<Scalar>& bands, Decomposition& found, const OutputFolder& folder) {
  const DenseMatrix<Scalar> R = triangular_factor(bands);
  const Index there = std::min<Index>(static_cast<Index>(bands.layout().values()),
                                      bands.snapshots() - (bands.removes_mean() ? 1 : 0));
  found.n_modes = number_of_modes(
      found.settings.n_modes, there,
      fmt::format("{} snapshots of {} values{}", bands.snapshots(), bands.layout().values(),
                  bands.removes_mean() ? ", less their mean" : ""));
  const Pod<Scalar> pod =
      decomposition::pod(R, bands.removes_mean(), static_cast<Index>(found.n_modes));
  found.variance = pod.variance;
  found.pod = {pod.energy, pod.coefficients.template cast<Complex>()};
  ResultFile file(found, folder);
  file.write("/energy", {static_cast<hsize_t>(pod.energy.size())}, list_of(pod.energy),
             "energy of each mode, all of them; their sum is the variance");
  if constexpr (std::is_same_v<Scalar, double>) {
    file.write("/coefficients",
               {static_cast<hsize_t>(pod.coefficients.rows()), found.times.t.size()},
               row_major(pod.coefficients), "of each mode at each time");
  } else {
    file.write_complex("/coefficients", pod.coefficients, "of each mode at each time");
  }
  write_modes<Scalar, Scalar>(bands, pod.combination, "mode, component, point; of norm 1", file);
  file.finish();
}

template <class Scalar>
void find_dmd(const Bands<Scalar>& bands, Decomposition& found, const OutputFolder& folder) {
  const Settings& settings = found.settings;
  const DenseMatrix<Scalar> R = triangular_factor(bands);
  found.variance = R.squaredNorm() / static_cast<double>(R.cols());
  std::optional<Index> rank;
  if (settings.rank) rank = *settings.rank;
  found.dmd = decomposition::dmd(R, found.times.dt, bands.layout().values(),
                                 {settings.variant, rank, static_cast<Index>(settings.delays)});
  Dmd& dmd = *found.dmd;
  const auto count = static_cast<Index>(dmd.modes.size());
  ResultFile file(found, folder);
  const hdf5::Shape shape = {dmd.modes.size()};
  file.write("/growth", shape, each_of(dmd.modes, [](const DmdMode& m) { return m.lambda.real(); }),
             "growth rate of each mode, the largest mean square first");
  file.write("/omega", shape, each_of(dmd.modes, [](const DmdMode& m) { return m.lambda.imag(); }),
             "angular frequency");
  file.write("/growth_error", shape,
             each_of(dmd.modes, [](const DmdMode& m) { return m.growth_error; }),
             "standard deviation of the growth rate");
  file.write("/omega_error", shape,
             each_of(dmd.modes, [](const DmdMode& m) { return m.omega_error; }),
             "standard deviation of the angular frequency");
  file.write("/amplitude", shape, each_of(dmd.modes, [](const DmdMode& m) { return m.amplitude; }),
             "at the first snapshot");
  file.write("/residual", shape, each_of(dmd.modes, [](const DmdMode& m) { return m.residual; }),
             "|Y c - theta X c|/(|theta| |X c|)");
  found.n_modes = number_of_modes(settings.n_modes, count,
                                  fmt::format("the rank is {}, see decompose.rank", dmd.rank));
  const auto kept = static_cast<Index>(found.n_modes);
  write_modes<Scalar, Complex>(
      bands, dmd.combination.leftCols(kept),
      "mode, component, point; of norm 1, with the phase of the first snapshot", file);
  file.finish();
}

std::vector<Index> kept_frequencies(const Spod& spod, const std::vector<double>& asked) {
  if (asked.empty()) return peaks(spod, peaks_kept);
  std::vector<Index> kept;
  for (const double f : asked) {
    const auto nearest =
        std::ranges::min_element(spod.f, {}, [&](double there) { return std::abs(there - f); });
    const double half_step = std::abs(spod.f[1] - spod.f[0]) / 2;
    constexpr double slack = 1e-9;
    if (std::abs(*nearest - f) > half_step * (1 + slack))
      throw InputError(
          "[decompose]",
          fmt::format("decompose.frequencies has {}, and those of the snapshots lie between {} "
                      "and {}",
                      f, std::ranges::min(spod.f), std::ranges::max(spod.f)));
    kept.push_back(nearest - spod.f.begin());
  }
  return kept;
}

template <class Scalar>
void find_spod(const Bands<Scalar>& bands, Decomposition& found, const OutputFolder& folder) {
  const Settings& settings = found.settings;
  const Blocks blocks =
      welch_blocks(bands.snapshots(), settings.block, settings.overlap, settings.window);
  const Index there = std::min<Index>(blocks.count(), static_cast<Index>(bands.layout().values()));
  found.n_modes =
      number_of_modes(settings.n_modes, there,
                      fmt::format("{} blocks of {} snapshots, of {} values", blocks.count(),
                                  blocks.length, bands.layout().values()));
  found.spod = SpodResult{spod(bands, blocks), {}};
  const Spod& spod = found.spod->spod;
  double sum = 0;
  for (const VectorXd& energy : spod.energy) sum += energy.sum();
  found.variance = sum / (static_cast<double>(blocks.length) * found.times.dt);
  if (!(found.variance > 0))
    throw InputError("[decompose]", "all snapshots are equal: nothing is left to decompose");
  found.spod->kept = kept_frequencies(spod, settings.frequencies);
  const std::vector<Index>& kept = found.spod->kept;

  ResultFile file(found, folder);
  Eigen::MatrixXd energies(static_cast<Index>(spod.f.size()), there), intervals(energies.rows(), 2);
  std::vector<double> mode_f;
  mode_f.reserve(kept.size());
  for (Index f = 0; f < energies.rows(); ++f) {
    energies.row(f) = spod.energy[static_cast<std::size_t>(f)];
    const auto interval = energy_interval(spod, f);
    intervals.row(f) << interval[0], interval[1];
  }
  for (const Index f : kept) mode_f.push_back(spod.f[static_cast<std::size_t>(f)]);
  file.write("/f", {spod.f.size()}, spod.f, "frequencies");
  file.write("/energy", {spod.f.size(), static_cast<hsize_t>(there)}, row_major(energies),
             "energy of each mode at each frequency, a density");
  file.write("/interval", {spod.f.size(), 2}, row_major(intervals),
             "95 % interval of the true energy of a mode apart from others, in its energy");
  file.write("/mode_f", {mode_f.size()}, mode_f, "frequencies whose modes are kept");
  {
    const std::size_t each = found.n_modes;
    ModesWriter writer(
        file.writer(), "/modes", bands.layout(), kept.size() * each, true,
        fmt::format("{} modes at each of mode_f one behind the other; mode, component, "
                    "point; of norm 1",
                    each));
    ValuesWriter<Scalar> values(file, bands.layout());
    for_each_band_of_spod_modes<Scalar>(
        bands, spod, kept, static_cast<Index>(each),
        [&](const BandOfData<Scalar>& data, std::size_t chosen, const MatrixXcd& phi) {
          writer.add(data.band, chosen * each, phi);
          if (chosen == 0) values.add(data);
        });
  }
  file.finish();
}

void find_waves(const Bands<double>& bands, Decomposition& found, const OutputFolder& folder) {
  found.waves = waves(bands, found.settings.y);
  ResultFile file(found, folder);
  const std::size_t M = found.times.t.size(), count = found.waves.size();
  MatrixXcd zeta(static_cast<Index>(count), static_cast<Index>(M));
  std::vector<double> k_x, along, against;
  for (const SpanwiseWaveParts& wave : found.waves) {
    zeta.row(static_cast<Index>(wave.n)) =
        Eigen::Map<const Eigen::RowVectorXcd>(wave.zeta.data(), zeta.cols());
    k_x.push_back(wave.k_x);
    along.push_back(wave.along);
    against.push_back(wave.against);
  }
  // Of z: the mean over the stations of each wave's square is half of |zeta_n|^2, but at the ends.
  for (const SpanwiseWaveParts& wave : found.waves) {
    const bool is_alone =
        wave.n == 0 || (bands.layout().stations && 2 * wave.n == bands.layout().stations->count);
    found.variance += (is_alone ? 1 : 0.5) * zeta.row(static_cast<Index>(wave.n)).squaredNorm() /
                      static_cast<double>(M);
  }
  file.write("/k_x", {count}, k_x, "wavenumber of each wave n = 0 ... along the span");
  file.write("/along", {count}, along, "amplitude of what travels along +x");
  file.write("/against", {count}, against, "amplitude of what travels along -x");
  file.write_complex("/zeta", zeta, "zeta_n at each time, a row for each n");
  file.finish();
}

void find_projection(const Bands<double>& bands, std::vector<GivenMode> given, Decomposition& found,
                     const OutputFolder& folder) {
  found.projection = project(bands, std::move(given));
  const Projection& projection = *found.projection;
  found.variance = projection.whole.squaredNorm() / static_cast<double>(projection.whole.size());
  found.n_modes = projection.modes.size();
  ResultFile file(found, folder);
  const std::size_t M = found.times.t.size();
  std::vector<double> growth, omega, k;
  for (const GivenMode& mode : projection.modes) {
    growth.push_back(mode.lambda.real());
    omega.push_back(mode.lambda.imag());
    k.push_back(mode.k);
  }
  file.write("/k", {k.size()}, k, "wavenumber of each mode along x");
  file.write("/growth", {k.size()}, growth, "growth rate that the mode has");
  file.write("/omega", {k.size()}, omega, "angular frequency that the mode has");
  file.write_complex("/coefficients", projection.a, "amplitude of each mode at each time");
  file.write("/rest", {M}, list_of(projection.rest), "norm of what is left at each time");
  file.write("/whole", {M}, list_of(projection.whole), "norm of the shape at each time");
  file.finish();
}

template <class Scalar>
void find(const Snapshots& snapshots, std::vector<GivenMode> given, Decomposition& found,
          const OutputFolder& folder) {
  const Settings& settings = found.settings;
  const Bands<Scalar> bands(snapshots, {.removes_mean = settings.removes_mean(),
                                        .is_weighted = settings.method != Method::waves,
                                        .has_mean_weight = settings.method == Method::dmd,
                                        .memory = settings.memory_bytes()});
  found.times = bands.times();
  if (settings.method == Method::pod) find_pod(bands, found, folder);
  if (settings.method == Method::dmd) find_dmd(bands, found, folder);
  if (settings.method == Method::spod) find_spod(bands, found, folder);
  if constexpr (std::is_same_v<Scalar, double>) {
    if (settings.method == Method::waves) find_waves(bands, found, folder);
    if (settings.method > Method::waves) find_projection(bands, std::move(given), found, folder);
  }
}

void add_notes_on(const Dmd& dmd, const Decomposition& found, std::vector<std::string>& notes) {
  constexpr double clean = 1e-6, large = 0.1, noise = 0.5;
  if (!(dmd.misfit < large))
    notes.push_back(fmt::format(
        "the sum of these modes leaves {:.2g} of the snapshots' norm: noise, or motion that "
        "they do not tell. decompose.delays = 2 or more tells oscillations that stand, a "
        "higher decompose.rank more modes",
        dmd.misfit));
  const bool shows_noise =
      std::ranges::any_of(dmd.modes, [](const DmdMode& mode) { return mode.residual > clean; });
  if (found.settings.variant == DmdVariant::exact && shows_noise)
    notes.emplace_back(
        "noise makes exact dynamic modes decay too fast, which the errors do not hold; "
        "decompose.variant = \"optimised\" has no such bias");
  if (dmd.rank < dmd.rank_of_signal)
    notes.push_back(fmt::format(
        "{} singular values are above the noise, but {} exponentials are the most that could be "
        "fitted",
        dmd.rank_of_signal, dmd.rank));
  if (dmd.vanished > 0)
    notes.push_back(
        fmt::format("{} of the {} eigenvalues vanish: what they hold is gone after one step",
                    dmd.vanished, dmd.rank));
  const auto spurious =
      std::ranges::count_if(dmd.modes, [](const DmdMode& mode) { return mode.residual > noise; });
  if (spurious > 0)
    notes.push_back(fmt::format(
        "{} of {} modes have a residual above 0.5: they are noise, and not dynamics; a lower "
        "decompose.rank leaves them out",
        spurious, dmd.modes.size()));
  const auto unknown = std::ranges::count_if(dmd.modes, [](const DmdMode& mode) {
    return mode.growth_error >= std::abs(mode.lambda.real());
  });
  if (unknown > 0)
    notes.push_back(fmt::format(
        "of {} of {} modes (both of a pair counted) the growth rate is zero within its error",
        unknown, dmd.modes.size()));
}

// What a reader should mind about these numbers.
std::vector<std::string> notes_on(const Decomposition& found) {
  std::vector<std::string> notes;
  if (found.times.is_resampled)
    notes.push_back(
        fmt::format("the times were not equally spaced (by up to {:.2g} of the step of {:.6g}); "
                    "the snapshots were resampled by cubic splines",
                    found.times.largest_shift, found.times.dt));
  if (found.spod) {
    const Spod& spod = found.spod->spod;
    constexpr double few = 4;
    if (spod.independent_blocks < few)
      notes.push_back(
          fmt::format("{} blocks are worth {:.2g} independent ones: the energies are uncertain by "
                      "a factor of {:.2g}, and those of the first modes too large; shorter "
                      "blocks or more snapshots help",
                      spod.blocks.count(), spod.independent_blocks, energy_interval(spod, 1)[1]));
  }
  if (found.dmd) add_notes_on(*found.dmd, found, notes);
  if (found.settings.method == Method::waves) {
    const auto short_wave = std::ranges::find_if(
        found.waves, [](const SpanwiseWaveParts& wave) { return wave.is_short; });
    if (short_wave != found.waves.end())
      notes.push_back(fmt::format(
          "the snapshots hold fewer than three periods of the wave n = {}: how much of it "
          "travels is not to be told",
          short_wave->n));
  }
  return notes;
}

}  // namespace

Decomposition decompose(std::unique_ptr<Snapshots> snapshots, const Settings& settings,
                        const OutputFolder& folder, std::vector<GivenMode> given) {
  if (settings.wave) snapshots = spanwise_wave(std::move(snapshots), *settings.wave);
  Decomposition found{.settings = settings, .layout = snapshots->layout(), .times = {}};
  found.is_complex = found.layout.is_complex;
  if (found.is_complex) {
    if (settings.is_of_shapes())
      throw InputError(
          "[decompose]",
          fmt::format("decompose.method = \"{}\" is of a flag's shape, and {} holds complex "
                      "numbers",
                      name_of(settings.method), found.layout.name));
    find<Complex>(*snapshots, {}, found, folder);
  } else {
    find<double>(*snapshots, std::move(given), found, folder);
  }
  found.notes = notes_on(found);
  return found;
}

}  // namespace pennon::decomposition
