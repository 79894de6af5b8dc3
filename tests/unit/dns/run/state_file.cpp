/// States are told member by member, and a checkpoint holds them whole.
#include "dns/run/state_file.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "common/errors.hpp"
#include "dns/coupling/visit_state.hpp"
#include "tests/support/member_count.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::dns {
namespace {

template <class State>
void expect_each_member_once(State state) {
  std::set<const void*> places;
  std::set<std::string> names;
  visit(state, [&](const MemberInfo& info, const auto& value) {
    names.insert(info.name);
    places.insert(&value);
    EXPECT_GE(static_cast<const void*>(&value), static_cast<const void*>(&state));
    EXPECT_LT(static_cast<const void*>(&value), static_cast<const void*>(&state + 1));
  });
  EXPECT_EQ(places.size(), test::member_count<State>());
  EXPECT_EQ(names.size(), test::member_count<State>());
}

TEST(StateMembers, AreVisitedEachOnce) {
  expect_each_member_once(FluidState());
  expect_each_member_once(FlagState<2>());
  expect_each_member_once(FlagState<3>());
  expect_each_member_once(CoupledState<2>());
  expect_each_member_once(CoupledState<3>());
}

// The counting above can fail.
TEST(StateMembers, AreCountedByTheirInitialisers) {
  struct Three {
    double t = 0;
    std::vector<double> values;
    FluidState fluid;
  };
  EXPECT_EQ(test::member_count<Three>(), 3U);
}

// Random numbers for every member of a state.
class Filling {
 public:
  Filling(const Fluid& fluid, Eigen::Index nodes) : fluid_(fluid), nodes_(nodes) {}

  void operator()(const MemberInfo&, FluidState& fluid) { visit(fluid, *this); }
  template <int dim>
  void operator()(const MemberInfo&, FlagState<dim>& flag) {
    visit(flag, *this);
  }
  void operator()(const MemberInfo&, double& number) { number = one(); }
  void operator()(const MemberInfo&, Field<double>& f) {
    f = Field<double>(fluid_.extent());
    fill(f);
  }
  void operator()(const MemberInfo&, std::vector<Field<double>>& fields) {
    fields.assign(static_cast<std::size_t>(fluid_.components()), Field<double>(fluid_.extent()));
    for (Field<double>& f : fields) fill(f);
  }
  void operator()(const MemberInfo&, std::vector<Displacement<double>>& grids) {
    grids.assign(3, Displacement<double>(fluid_.extent()));
    for (Displacement<double>& grid : grids) {
      fill(grid.y);
      fill(grid.z);
    }
  }
  void operator()(const MemberInfo&, std::vector<bool>& sides) {
    for (std::size_t i = 0; i < fluid_.extent().wall_faces(); ++i) sides.push_back(one() > 0.5);
  }
  template <int rows, int options>
  void operator()(const MemberInfo&, Eigen::Matrix<double, rows, Eigen::Dynamic, options>& values) {
    constexpr Eigen::Index stations = 4;
    values.resize(rows == Eigen::Dynamic ? stations : rows,
                  rows == Eigen::Dynamic ? nodes_ / stations - 1 : nodes_);
    for (double& value : values.reshaped()) value = one();
  }

 private:
  double one() { return std::uniform_real_distribution<double>(0.1, 1)(engine_); }
  void fill(Field<double>& f) {
    for (double& value : f.values()) value = one();
  }

  const Fluid& fluid_;
  Eigen::Index nodes_;
  std::mt19937 engine_{5};
};

// What is saved: of a field the cells, of the grid the corners at two times.
class Comparison {
 public:
  void operator()(const MemberInfo&, const FluidState& a, const FluidState& b) const {
    visit_both(a, b, *this);
  }
  template <int dim>
  void operator()(const MemberInfo&, const FlagState<dim>& a, const FlagState<dim>& b) const {
    visit_both(a, b, *this);
  }
  void operator()(const MemberInfo& info, const Field<double>& a, const Field<double>& b) const {
    compare(info, a, b, a.extent().n_rho);
  }
  void operator()(const MemberInfo& info, const std::vector<Field<double>>& a,
                  const std::vector<Field<double>>& b) const {
    ASSERT_EQ(a.size(), b.size()) << info.name;
    for (std::size_t c = 0; c < a.size(); ++c) compare(info, a[c], b[c], a[c].extent().n_rho);
  }
  void operator()(const MemberInfo& info, const std::vector<Displacement<double>>& a,
                  const std::vector<Displacement<double>>& b) const {
    ASSERT_EQ(a.size(), b.size()) << info.name;
    for (std::size_t k = 0; k < 2; ++k) {
      compare(info, a[k].y, b[k].y, a[k].y.extent().n_rho + 1);
      compare(info, a[k].z, b[k].z, a[k].z.extent().n_rho + 1);
    }
  }
  template <class Value>
  void operator()(const MemberInfo& info, const Value& a, const Value& b) const {
    EXPECT_EQ(a, b) << info.name;
  }

 private:
  static void compare(const MemberInfo& info, const Field<double>& a, const Field<double>& b,
                      int rows) {
    for (int plane = 0; plane < a.extent().planes; ++plane)
      for (int j = 0; j < rows; ++j)
        EXPECT_TRUE(
            std::equal(a.row(plane, j), a.row(plane, j) + a.extent().n_theta, b.row(plane, j)))
            << info.name << " in plane " << plane << ", row " << j;
  }
};

class StateFile : public testing::Test {
 protected:
  static constexpr int nodes = 20;
  test::TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "state.h5";
  Fluid fluid_{
      OGrid({.n_rho = 6, .n_theta = 8, .R = 2, .wall_spacing = 0.2}), Span(4, 2.0), {100, 0.5}, {}};

  template <class State>
  State filled() const {
    State state;
    visit(state, Filling(fluid_, nodes));
    return state;
  }
};

TEST_F(StateFile, HoldsTheFlagsState) {
  const auto state = filled<FlagState<3>>();
  hdf5::Writer file(path_);
  write_state(state, file);
  file.finish();
  const FlagState<3> read = read_flag_state<3>(hdf5::Reader(path_), nodes);
  visit_both(state, read, Comparison());
  EXPECT_THROW(read_flag_state<3>(hdf5::Reader(path_), nodes + 1), InputError);
  EXPECT_THROW(read_flag_state<2>(hdf5::Reader(path_), nodes), InputError);
}

// Before there is a step before.
TEST_F(StateFile, HoldsAFlagAtItsStart) {
  FlagState<2> state;
  state.x = NodeVectors<2>::Random(2, nodes);
  state.v = NodeVectors<2>::Random(2, nodes);
  hdf5::Writer file(path_);
  write_state(state, file);
  file.finish();
  const FlagState<2> read = read_flag_state<2>(hdf5::Reader(path_), nodes);
  visit_both(state, read, Comparison());
}

TEST_F(StateFile, HoldsTheStateOfFlagAndFluid) {
  auto state = filled<CoupledState<3>>();
  state.flag.t = state.fluid.t;
  state.flag.previous_dt = state.fluid.previous_dt;  // they step together
  constexpr double energy = 0.25;
  hdf5::Writer file(path_);
  write_state(state.fluid, fluid_, &file);
  write_flag_of(state, energy, file);
  file.finish();
  CoupledState<3> read;
  read.fluid = read_fluid_state(hdf5::Reader(path_), fluid_);
  EXPECT_EQ(read_flag_of(hdf5::Reader(path_), nodes, 4, read), energy);
  visit_both(state, read, Comparison());
  const Fluid finer(OGrid({.n_rho = 8, .n_theta = 8, .R = 2, .wall_spacing = 0.2}), Span(4, 2.0),
                    {100, 0.5}, {});
  EXPECT_THROW(read_fluid_state(hdf5::Reader(path_), finer), InputError);
}

}  // namespace
}  // namespace pennon::dns
