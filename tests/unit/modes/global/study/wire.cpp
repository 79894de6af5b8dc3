/// What pennon-global hands to pennon arrives as it was, every member of it.
#include "modes/global/study/wire.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/global_findings.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::modes::global {
namespace {

using test::failure_of;
using test::global_findings;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

// Through a file, as from process to process.
Findings sent(const Findings& findings) {
  const TemporaryFolder folder;
  write_findings(findings, folder / "global_modes.json");
  return read_findings(folder / "global_modes.json");
}

// NaN is itself.
void expect_same(const std::vector<std::vector<double>>& found,
                 const std::vector<std::vector<double>>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].size(), expected[i].size());
    for (std::size_t k = 0; k < found[i].size(); ++k)
      EXPECT_TRUE(found[i][k] == expected[i][k] ||
                  (std::isnan(found[i][k]) && std::isnan(expected[i][k])))
          << found[i][k] << ' ' << expected[i][k];
  }
}

TEST(GlobalWire, CarriesTheSpectrum) {
  const FoundModes expected = global_findings().spectrum, found = sent(global_findings()).spectrum;
  EXPECT_EQ(found.base_flow.drag_coefficient, expected.base_flow.drag_coefficient);
  EXPECT_EQ(found.base_flow.residual, expected.base_flow.residual);
  EXPECT_EQ(found.base_flow.tension, expected.base_flow.tension);
  EXPECT_EQ(found.chord, expected.chord);
  EXPECT_EQ(found.unknowns, expected.unknowns);
  EXPECT_EQ(found.requested, expected.requested);
  EXPECT_EQ(found.converged, expected.converged);
  EXPECT_EQ(found.searched, expected.searched);
  EXPECT_EQ(found.box, expected.box);
  EXPECT_EQ(found.too_fast, expected.too_fast);
  EXPECT_EQ(found.checked, expected.checked);
  EXPECT_EQ(found.biorthogonality_defect, expected.biorthogonality_defect);
  EXPECT_EQ(found.base_seconds, expected.base_seconds);
  EXPECT_EQ(found.operator_seconds, expected.operator_seconds);
  EXPECT_EQ(found.eigen_seconds, expected.eigen_seconds);
  ASSERT_EQ(found.modes.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const GlobalMode &mode = found.modes[k], &other = expected.modes[k];
    EXPECT_EQ(mode.lambda, other.lambda);
    EXPECT_EQ(mode.residual, other.residual);
    EXPECT_EQ(mode.zeta, other.zeta);
    EXPECT_EQ(mode.adjoint_residual, other.adjoint_residual);
    EXPECT_EQ(mode.kind, other.kind);
    EXPECT_EQ(mode.shares.flag, other.shares.flag);
    EXPECT_EQ(mode.shares.near, other.shares.near);
    EXPECT_EQ(mode.shares.wake, other.shares.wake);
    EXPECT_EQ(mode.shares.outer, other.shares.outer);
  }
  const Sensitivity &of = *found.modes[0].sensitivity, &other = *expected.modes[0].sensitivity;
  EXPECT_EQ(of.mu, other.mu);
  EXPECT_EQ(of.K_B, other.K_B);
  EXPECT_EQ(of.nu_s, other.nu_s);
  EXPECT_EQ(of.tension, other.tension);
  EXPECT_FALSE(found.modes[1].sensitivity);
}

TEST(GlobalWire, CarriesTheNeutralCurve) {
  const NeutralCurve expected = *global_findings().neutral,
                     found = *sent(global_findings()).neutral;
  EXPECT_EQ(found.parameter, expected.parameter);
  ASSERT_EQ(found.points.size(), expected.points.size());
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    const CurvePoint &point = found.points[i], &other = expected.points[i];
    EXPECT_EQ(point.value, other.value);
    EXPECT_EQ(point.fit_error, other.fit_error);
    EXPECT_EQ(point.evaluations, other.evaluations);
    EXPECT_EQ(point.seconds, other.seconds);
    EXPECT_EQ(point.largest_growth, other.largest_growth);
    EXPECT_EQ(point.distance, other.distance);
    ASSERT_EQ(point.modes.size(), other.modes.size());
    for (std::size_t k = 0; k < point.modes.size(); ++k) {
      const BranchPoint &one = point.modes[k], &two = other.modes[k];
      EXPECT_EQ(one.branch, two.branch);
      EXPECT_EQ(one.residual, two.residual);
      EXPECT_EQ(one.mode.omega, two.mode.omega);
      EXPECT_EQ(one.mode.mu, two.mode.mu);
      EXPECT_EQ(one.mode.by_mu, two.mode.by_mu);
      EXPECT_EQ(one.mode.zeta, two.mode.zeta);
      EXPECT_EQ(one.mode.evaluations, two.mode.evaluations);
    }
  }
  ASSERT_EQ(found.missing.size(), 1u);
  EXPECT_EQ(found.missing[0].value, expected.missing[0].value);
  EXPECT_EQ(found.missing[0].fault, expected.missing[0].fault);
}

TEST(GlobalWire, CarriesTheMap) {
  const GrowthMap expected = *global_findings().map, found = *sent(global_findings()).map;
  EXPECT_EQ(found.parameter, expected.parameter);
  EXPECT_EQ(found.x, expected.x);
  EXPECT_EQ(found.mu, expected.mu);
  expect_same(found.growth, expected.growth);
  expect_same(found.omega, expected.omega);
  EXPECT_EQ(found.neutral, expected.neutral);
  EXPECT_EQ(found.basis_size, expected.basis_size);
  EXPECT_EQ(found.fit_error, expected.fit_error);
  EXPECT_EQ(found.basis_error, expected.basis_error);
  EXPECT_EQ(found.lambda_error, expected.lambda_error);
  EXPECT_EQ(found.checked_basis, expected.checked_basis);
  EXPECT_EQ(found.checked, expected.checked);
  EXPECT_EQ(found.samples, expected.samples);
  EXPECT_EQ(found.samples_off_axis, expected.samples_off_axis);
  EXPECT_EQ(found.sample_seconds, expected.sample_seconds);
  EXPECT_EQ(found.map_seconds, expected.map_seconds);
}

TEST(GlobalWire, TellsNothingFromNoNumber) {
  Findings findings;
  findings.spectrum.biorthogonality_defect = std::numeric_limits<double>::quiet_NaN();
  findings.spectrum.base_flow.residual = -std::numeric_limits<double>::infinity();
  findings.spectrum.base_flow.drag_coefficient = std::numeric_limits<double>::infinity();
  const Findings found = sent(findings);
  EXPECT_FALSE(found.neutral);
  EXPECT_FALSE(found.map);
  EXPECT_TRUE(found.spectrum.modes.empty());
  ASSERT_TRUE(found.spectrum.biorthogonality_defect);
  EXPECT_TRUE(std::isnan(*found.spectrum.biorthogonality_defect));
  EXPECT_EQ(found.spectrum.base_flow.residual, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(found.spectrum.base_flow.drag_coefficient, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(sent(Findings{}).spectrum.biorthogonality_defect);
}

TEST(GlobalWire, NamesTheFileThatIsNotWhatItShouldBe) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "global_modes.json";
  const auto fault = [&] { return failure_of<FileError>([&] { read_findings(file); }); };
  EXPECT_THAT(fault(), AllOf(HasSubstr(file.string()), HasSubstr("cannot be read")));
  test::write_text(file, "{\"global\": ");
  EXPECT_THAT(fault(), AllOf(HasSubstr(file.string()), HasSubstr("parse error")));
  nlohmann::ordered_json json = to_wire(global_findings());
  json["global"].erase("requested");
  test::write_text(file, json.dump());
  EXPECT_THAT(fault(), AllOf(HasSubstr(file.string()), HasSubstr("'requested' not found")));
  json = to_wire(global_findings());
  json["map"]["over"] = "mu";
  test::write_text(file, json.dump());
  EXPECT_THAT(fault(), AllOf(HasSubstr(file.string()), HasSubstr("'mu' not found")));
}

}  // namespace
}  // namespace pennon::modes::global
