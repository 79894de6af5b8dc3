/// What may change at a restart, and what a checkpoint says of its case.
#include "dns/run/restart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "common/case/parameters.hpp"
#include "common/errors.hpp"
#include "dns/run/settings.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::dns {
namespace {

using test::failure_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

// The resolved case of a coupled run; later lines stand in place of earlier ones of the same key.
std::string case_text(double mu, std::int64_t n_rho, double dt, std::vector<double> probes = {}) {
  FlagParameters flag;
  flag.mu = mu;
  FlowParameters flow;
  flow.Re = 100;
  bool has_flow = true;
  Settings settings;
  settings.is_given = true;
  settings.dt = dt;
  settings.fluid.n_rho = n_rho;
  settings.probes.y = settings.probes.z = std::move(probes);
  Schema schema;
  declare(schema, flag);
  declare(schema, flow, has_flow);
  declare(schema, settings);
  return resolved_text(schema);
}

class Restart : public testing::Test {
 protected:
  std::filesystem::path checkpoint(const CaseOfRun& the_case, double t) {
    std::filesystem::path path = folder_ / "checkpoint.h5";
    hdf5::Writer file(path);
    file.attributes({{"kind", "fluid_checkpoint"}, {"t", t}});
    write(the_case, file);
    file.finish();
    return path;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Restart, GoesOnWithTheSameCaseAndOtherSteps) {
  const auto path = checkpoint({case_text(0.1, 20, 0.01), {}}, 0.5);
  const Beginning beginning = beginning_at(path, case_text(0.1, 20, 0.005), 1, false);
  EXPECT_EQ(beginning.checkpoint, path);
  EXPECT_TRUE(beginning.the_case.changes.empty());
  EXPECT_EQ(beginning.the_case.text, case_text(0.1, 20, 0.005));
}

TEST_F(Restart, TakesOtherPhysicsOnlyKnowinglyAndRecordsIt) {
  const auto path =
      checkpoint({case_text(0.1, 20, 0.01), {{0.2, "flow.Re", "50.0", "100.0"}}}, 0.5);
  const auto restart = [&](bool accepts) {
    return beginning_at(path, case_text(0.3, 20, 0.01), 1, accepts);
  };
  EXPECT_THAT(failure_of<InputError>([&] { restart(false); }),
              AllOf(HasSubstr("flag.mu = 0.1 there, 0.3 here"), HasSubstr("--change")));
  const std::vector<CaseChange> changes = restart(true).the_case.changes;
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].key, "flow.Re");
  EXPECT_EQ(changes[1].key, "flag.mu");
  EXPECT_EQ(changes[1].t, 0.5);
  EXPECT_EQ(changes[1].before, "0.1");
  EXPECT_EQ(changes[1].after, "0.3");
}

TEST_F(Restart, RefusesAnotherGridAndOtherProbes) {
  const auto path = checkpoint({case_text(0.1, 20, 0.01, {0.5}), {}}, 0.5);
  for (const std::string& other :
       {case_text(0.1, 22, 0.01, {0.5}), case_text(0.1, 20, 0.01, {0.6})})
    EXPECT_THAT(failure_of<InputError>([&] { beginning_at(path, other, 1, true); }),
                HasSubstr("it cannot change at a restart"));
}

TEST_F(Restart, NamesEveryKeyAtOnce) {
  const auto path = checkpoint({case_text(0.1, 20, 0.01, {0.5}), {}}, 0.5);
  EXPECT_THAT(
      failure_of<InputError>([&] { beginning_at(path, case_text(0.2, 22, 0.01), 1, false); }),
      AllOf(HasSubstr("flag.mu"), HasSubstr("dns.n_rho"), HasSubstr("dns.probes.y"),
            HasSubstr("dns.probes.z")));
}

TEST_F(Restart, RefusesAnEndThatIsReached) {
  const auto path = checkpoint({case_text(0.1, 20, 0.01), {}}, 0.5);
  const auto restart = [&] { return beginning_at(path, case_text(0.1, 20, 0.01), 0.5, false); };
  EXPECT_NO_THROW(restart()) << "its results were not written yet";
  test::write_text(folder_ / "summary.json", "{}");
  for (const double t_end : {0.4, 0.5})
    EXPECT_THAT(
        failure_of<InputError>([&] { beginning_at(path, case_text(0.1, 20, 0.01), t_end, true); }),
        HasSubstr("dns.t_end: = " + fmt::format("{}", t_end) + " is reached already"));
}

TEST_F(Restart, RefusesATimeThatIsNone) {
  for (const double t : {std::nan(""), HUGE_VAL})
    EXPECT_THAT(failure_of<InputError>([&] {
                  beginning_at(checkpoint({case_text(0.1, 20, 0.01), {}}, t),
                               case_text(0.1, 20, 0.01), 1, true);
                }),
                HasSubstr("the attribute t of /"));
}

// No rule is about a key that is not there.
TEST(AtRestart, RulesAreOfKeysOfTheCase) {
  FlagParameters flag;
  FlowParameters flow;
  bool has_flow = false;
  Settings settings;
  Schema schema;
  declare(schema, flag);
  declare(schema, flow, has_flow);
  declare(schema, settings);
  int free = 0, physics = 0;
  for (const Table& table : schema.tables)
    for (const Key& key : table.keys) {
      const std::string name = table.name + "." + key.name;
      EXPECT_TRUE(is_of_simulation(name)) << name;
      free += at_restart(name) == AtRestart::free ? 1 : 0;
      physics += at_restart(name) == AtRestart::physics ? 1 : 0;
    }
  EXPECT_GE(free, 14);
  EXPECT_GE(physics, 24);
  for (const char* fixed : {"flag.gamma", "dns.R", "dns.n_x", "dns.wall_spacing", "dns.flag.n_y",
                            "dns.probes.y", "dns.initial.A", "dns.output.probe_y"})
    EXPECT_EQ(at_restart(fixed), AtRestart::fixed) << fixed;
}

}  // namespace
}  // namespace pennon::dns
