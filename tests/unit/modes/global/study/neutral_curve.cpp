// The neutral curve, on a small grid.
#include <gtest/gtest.h>

#include <functional>

#include "modes/global/study/growth_map.hpp"
#include "modes/global/study/kept_pieces.hpp"
#include "modes/global/study/linearisation.hpp"
#include "modes/global/study/neutral_curve.hpp"
#include "tests/support/small_flag_flow.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::modes::global {
namespace {

const FlagParameters flag{.mu = 1, .K_B = 1e-3, .gamma = {}};
const FlowParameters flow{.Re = 200};

Settings settings_of(const NeutralSettings& neutral) {
  Settings settings;
  settings.is_given = true;
  settings.n_modes = 0;
  settings.neutral = neutral;
  settings.neutral.is_given = true;
  settings.neutral.check = false;
  settings.neutral.mu = {0.02, 2};
  settings.neutral.omega = {1, 10};
  return resolve(settings, flag, test::small_discretisation);
}

NeutralCurve curve_of(const NeutralSettings& neutral, const Keeper<CurveProgress>& keeper = {}) {
  const EigenSolver none = [](const CoupledOperator&, std::complex<double>, int, bool) {
    return Spectrum{};
  };
  return neutral_curve(flag, flow, settings_of(neutral), none, umfpack_factors(), keeper);
}

Sweep list(std::vector<double> values) {
  Sweep sweep;
  sweep.list = std::move(values);
  return sweep;
}

TEST(GlobalNeutralCurve, FollowedFromPointToPointIsThatOfModesSoughtAnewAtEach) {
  NeutralSettings followed{.Re = list({120, 130, 140, 150, 160, 170})}, sought = followed;
  followed.scan_every = 100;
  sought.scan_every = 1;
  const NeutralCurve a = curve_of(followed), b = curve_of(sought);
  ASSERT_EQ(a.points.size(), 6u);
  ASSERT_EQ(b.points.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const BranchPoint &one = a.points[i].modes.front(), &other = b.points[i].modes.front();
    EXPECT_NEAR(one.mode.mu, other.mode.mu, 1e-9 * other.mode.mu);
    EXPECT_NEAR(one.mode.omega, other.mode.omega, 1e-6);
    EXPECT_EQ(one.branch, other.branch);
    EXPECT_LT(one.residual, 1e-6);
    EXPECT_EQ(a.points[i].fit_error > 0, i == 0 || i == 5);
    EXPECT_GT(b.points[i].fit_error, 0);
  }
}

// Stopped after so many pieces, and gone on with from the file in which they are kept.
template <class Run>
auto in_two_parts(int pieces, const std::filesystem::path& file, const Run& run) {
  struct Stopped {};
  {
    KeptPieces kept(file, "the problem");
    try {
      run(kept, [&, count = 0]() mutable {
        if (++count == pieces) throw Stopped();
      });
      ADD_FAILURE() << "it ended before it was stopped";
    } catch (const Stopped&) {
    }
  }
  KeptPieces kept(file, "the problem");
  return run(kept, [] {});
}

template <class Progress>
Keeper<Progress> watched(Keeper<Progress> keeper, std::function<void()> after) {
  return {keeper.load, [save = keeper.save, after](const Progress& progress) {
            save(progress);
            after();
          }};
}

TEST(GlobalNeutralCurve, GoesOnWhereItWasStopped) {
  const test::TemporaryFolder folder;
  const NeutralSettings neutral{.Re = list({120, 130, 140, 150}), .scan_every = 100};
  const NeutralCurve whole = curve_of(neutral);
  std::vector<std::size_t> saved;
  const NeutralCurve parts = in_two_parts(
      2, folder / "pieces.json", [&](KeptPieces& kept, const std::function<void()>& after) {
        Keeper<CurveProgress> keeper = watched(kept.neutral(), after);
        const auto save = keeper.save;
        keeper.save = [&, save](const CurveProgress& progress) {
          saved.push_back(progress.next);
          save(progress);
        };
        return curve_of(neutral, keeper);
      });
  EXPECT_EQ(saved, (std::vector<std::size_t>{1, 2, 3, 4})) << "no point is found twice";
  ASSERT_EQ(parts.points.size(), whole.points.size());
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    const NeutralMode &a = parts.points[i].modes.front().mode,
                      &b = whole.points[i].modes.front().mode;
    EXPECT_NEAR(a.mu, b.mu, 1e-9 * b.mu);
    EXPECT_NEAR(a.omega, b.omega, 1e-7);
    EXPECT_EQ(parts.points[i].modes.front().branch, whole.points[i].modes.front().branch);
  }
}

TEST(GlobalGrowthMap, GoesOnWhereItWasStopped) {
  const test::TemporaryFolder folder;
  Settings settings = settings_of({});
  settings.map.is_given = true;
  settings.map.k_x = list({0, 1, 2});
  settings.map.omega = {1, 10};
  settings.map.mu = list({0.2, 0.5});
  const auto map_of = [&](const Keeper<MapProgress>& keeper) {
    return growth_map(flag, flow, settings, umfpack_factors(), keeper);
  };
  const GrowthMap whole = map_of({});
  const GrowthMap parts = in_two_parts(1, folder / "pieces.json",
                                       [&](KeptPieces& kept, const std::function<void()>& after) {
                                         return map_of(watched(kept.map(), after));
                                       });
  EXPECT_EQ(parts.samples, whole.samples) << "the first column was not sampled again";
  for (std::size_t m = 0; m < 2; ++m)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(parts.growth[m][i], whole.growth[m][i], 1e-7);
}

TEST(KeptPieces, AreThoseOfOneProblem) {
  const test::TemporaryFolder folder;
  const CurveProgress progress{.found = {}, .faults = {"why"}, .next = 3, .branches = 2};
  KeptPieces(folder / "pieces.json", "one").neutral().keep(progress);
  EXPECT_EQ(KeptPieces(folder / "pieces.json", "one").neutral().begin().next, 3u);
  EXPECT_EQ(KeptPieces(folder / "pieces.json", "another").neutral().begin().next, 0u);
  EXPECT_EQ(KeptPieces(folder / "pieces.json", "one").map().begin().next, 0u);
  test::write_text(folder / "pieces.json", "{\"problem\": \"one\", \"neutral\": [1, 2]}");
  EXPECT_EQ(KeptPieces(folder / "pieces.json", "one").neutral().begin().next, 0u);
  test::write_text(folder / "pieces.json", "not JSON");
  EXPECT_EQ(KeptPieces(folder / "pieces.json", "one").neutral().begin().next, 0u);
}

TEST(GlobalNeutralCurve, AlongTheStiffnessNeedsOneFitAndIsThatOfEachStiffnessByItself) {
  const NeutralCurve along = curve_of({.K_B = list({5e-4, 1e-3, 2e-3})});
  ASSERT_EQ(along.points.size(), 3u);
  const NeutralCurve here = curve_of({.Re = list({200})});
  ASSERT_EQ(here.points.size(), 1u);
  EXPECT_NEAR(along.points[1].modes.front().mode.mu, here.points[0].modes.front().mode.mu, 1e-10);
  EXPECT_EQ(along.points[0].fit_error, along.points[2].fit_error);
}

// Checked by the modes of the whole operator, at each point of the map.
void expect_map_of_the_full_operator(const MapSettings& wanted) {
  Settings settings = settings_of({});
  settings.map = wanted;
  settings.map.is_given = true;
  settings.map.omega = {1, 10};
  Sweep mu;
  mu.list = {0.1, 0.2, 0.35, 0.5};
  settings.map.mu = mu;
  const GrowthMap map = growth_map(flag, flow, settings, umfpack_factors());
  EXPECT_LE(map.fit_error, 1e-6);
  EXPECT_GT(map.checked, 0u);
  Linearisations linearisations(flag, flow, settings, parameter(settings.map), umfpack_factors());
  for (std::size_t i = 0; i < map.x.size(); ++i) {
    const Linearisation linearised = linearisations.at(map.x[i]);
    for (std::size_t m = 0; m < map.mu.size(); ++m) {
      const std::complex<double> lambda(map.growth[m][i], map.omega[m][i]);
      const CoupledOperator coupled = linearised.with_mass_ratio(map.mu[m]);
      const std::complex<double> full = eigenpair_near(coupled.assembled(), lambda).lambda;
      EXPECT_LT(std::abs(full - lambda), 1e-4) << map.x[i] << ' ' << map.mu[m] << ' ' << lambda;
    }
  }
}

TEST(GlobalGrowthMap, HasTheModesOfTheFullOperatorOverTheSpanwiseWavenumber) {
  expect_map_of_the_full_operator({.k_x = list({0, 1})});
}

TEST(GlobalGrowthMap, HasTheModesOfTheFullOperatorOverTheStiffness) {
  expect_map_of_the_full_operator({.K_B = list({5e-4, 1e-3, 2e-3})});
}

TEST(GlobalNeutralCurve, NamesTheValuesAtWhichThereIsNone) {
  NeutralSettings neutral{.k_x = list({0, 40})};
  const NeutralCurve curve = curve_of(neutral);
  ASSERT_EQ(curve.points.size(), 1u);
  EXPECT_EQ(curve.points[0].value, 0);
  ASSERT_EQ(curve.missing.size(), 1u);
  EXPECT_EQ(curve.missing[0].value, 40);
  EXPECT_NE(curve.missing[0].fault.find("no neutral mode"), std::string::npos);
}

}  // namespace
}  // namespace pennon::modes::global
