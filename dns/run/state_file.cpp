#include "dns/run/state_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "dns/coupling/visit_state.hpp"

namespace pennon::dns {
namespace {

// use(name in the file, field, its rows) for the fields of one of the fluid's members. Of the grid
// the last entry is left out, which the next step overwrites.
template <class Fields, class Use>
void for_each_field(const MemberInfo& info, Fields& fields, const Use& use) {
  for (std::size_t c = 0; c < fields.size(); ++c)
    use(fmt::format("/{}_{}", info.name, c), fields[c], fields[c].extent().n_rho);
}
template <class Grids, class Use>
void for_each_grid_field(const MemberInfo& info, Grids& grids, const Use& use) {
  for (std::size_t k = 0; k + 1 < grids.size(); ++k) {
    const int corners = grids[k].y.extent().n_rho + 1;
    use(fmt::format("/{}_{}_y", info.name, k), grids[k].y, corners);
    use(fmt::format("/{}_{}_z", info.name, k), grids[k].z, corners);
  }
}

class FluidWriter {
 public:
  FluidWriter(const Fluid& fluid, hdf5::Writer* file) : fluid_(fluid), file_(file) {}

  void operator()(const MemberInfo& info, const double& number) const {
    if (file_) file_->attributes({{info.name, number}});
  }
  void operator()(const MemberInfo& info, const std::vector<Field<double>>& fields) const {
    for_each_field(info, fields, [this](const auto&... of_field) { write(of_field...); });
  }
  void operator()(const MemberInfo& info, const std::vector<Displacement<double>>& grids) const {
    for_each_grid_field(info, grids, [this](const auto&... of_field) { write(of_field...); });
  }
  void operator()(const MemberInfo& info, const Field<double>& field) const {
    write(fmt::format("/{}", info.name), field, field.extent().n_rho);
  }
  void operator()(const MemberInfo& info, const std::vector<bool>& sides) const {
    const std::vector<double> all = ranks::gather(std::vector<double>(sides.begin(), sides.end()));
    if (file_) file_->write(fmt::format("/{}", info.name), {all.size()}, all);
  }

 private:
  void write(const std::string& name, const Field<double>& f, int rows) const {
    const Extent& extent = f.extent();
    std::vector<double> values;
    for (int plane = 0; plane < extent.planes; ++plane)
      for (int j = 0; j < rows; ++j)
        values.insert(values.end(), f.row(plane, j), f.row(plane, j) + extent.n_theta);
    values = ranks::gather(values);
    if (file_)
      file_->write(name,
                   {static_cast<hsize_t>(fluid_.span().planes()), static_cast<hsize_t>(rows),
                    static_cast<hsize_t>(extent.n_theta)},
                   values);
  }

  const Fluid& fluid_;
  hdf5::Writer* file_;
};

class FluidReader {
 public:
  FluidReader(const hdf5::Reader& file, const Fluid& fluid) : file_(file), fluid_(fluid) {}

  void operator()(const MemberInfo& info, double& number) const {
    number = file_.number("/", info.name);
  }
  void operator()(const MemberInfo& info, std::vector<Field<double>>& fields) const {
    fields.assign(static_cast<std::size_t>(fluid_.components()), Field<double>(fluid_.extent()));
    for_each_field(info, fields,
                   [this](const auto& name, auto& f, int rows) { read(name, f, rows); });
  }
  void operator()(const MemberInfo& info, std::vector<Displacement<double>>& grids) const {
    constexpr std::size_t times = 3;  // now, one and two steps before
    grids.assign(times, Displacement<double>(fluid_.extent()));
    for_each_grid_field(info, grids,
                        [this](const auto& name, auto& f, int rows) { read(name, f, rows); });
  }
  void operator()(const MemberInfo& info, Field<double>& field) const {
    field = Field<double>(fluid_.extent());
    read(fmt::format("/{}", info.name), field, fluid_.extent().n_rho);
  }
  void operator()(const MemberInfo& info, std::vector<bool>& sides) const {
    const std::vector<double> all = file_.list(fmt::format("/{}", info.name),
                                               static_cast<hsize_t>(fluid_.span().planes()) *
                                                   static_cast<hsize_t>(fluid_.extent().n_theta));
    const auto first =
        all.begin() + fluid_.span().first_plane() * std::ptrdiff_t(fluid_.extent().n_theta);
    sides.resize(fluid_.extent().wall_faces());
    std::transform(first, first + static_cast<std::ptrdiff_t>(sides.size()), sides.begin(),
                   [](double side) { return side != 0; });
  }

 private:
  void read(const std::string& name, Field<double>& f, int rows) const {
    const Extent& extent = fluid_.extent();
    const hdf5::Shape expected = {static_cast<hsize_t>(fluid_.span().planes()),
                                  static_cast<hsize_t>(rows), static_cast<hsize_t>(extent.n_theta)};
    if (file_.shape(name) != expected)
      file_.fail(
          fmt::format("holds another grid than the case's {} x {} x {} cells; restart with "
                      "the case that wrote it",
                      fluid_.span().planes(), extent.n_rho, extent.n_theta));
    const hdf5::Array array = file_.read(name);
    file_.expect_finite(name, array.values);
    const double* value =
        array.values.data() +
        static_cast<std::ptrdiff_t>(fluid_.span().first_plane()) * rows * extent.n_theta;
    for (int plane = 0; plane < extent.planes; ++plane) {
      for (int j = 0; j < rows; ++j, value += extent.n_theta)
        std::copy_n(value, extent.n_theta, f.row(plane, j));
      f.wrap_theta(plane, 0, rows);
    }
  }

  const hdf5::Reader& file_;
  const Fluid& fluid_;
};

// The numbers among the members of a flag's state, or of a coupled one beside the fluid's.
template <class Value>
struct Numbers {
  std::vector<std::pair<std::string, Value*>> list;

  template <class State>
  explicit Numbers(State& state) {
    collect(state);
  }

 private:
  template <class State>
  void collect(State& state) {
    visit(state, [this](const MemberInfo& info, auto& value) {
      using Type = std::remove_const_t<std::remove_reference_t<decltype(value)>>;
      if constexpr (std::is_same_v<Type, double>) list.emplace_back(info.name, &value);
      if constexpr (IsFlagState<Type>) collect(value);
    });
  }
};

// The matrices among them, each column a row of the file; one that is empty yet, for want of a step
// before, is left out.
class FlagWriter {
 public:
  FlagWriter(const char* prefix, hdf5::Writer& file) : prefix_(prefix), file_(file) {}

  void operator()(const MemberInfo&, const double&) const {}
  void operator()(const MemberInfo&, const FluidState&) const {}
  template <int dim>
  void operator()(const MemberInfo&, const FlagState<dim>& flag) const {
    visit(flag, *this);
  }
  template <int rows, int options>
  void operator()(const MemberInfo& info,
                  const Eigen::Matrix<double, rows, Eigen::Dynamic, options>& values) const {
    if (values.size() > 0)
      file_.write(fmt::format("/{}{}", prefix_, info.name),
                  {static_cast<hsize_t>(values.cols()), static_cast<hsize_t>(values.rows())},
                  {values.data(), static_cast<std::size_t>(values.size())});
  }

 private:
  const char* prefix_;
  hdf5::Writer& file_;
};

class FlagReader {
 public:
  FlagReader(const char* prefix, const hdf5::Reader& file, int nodes, int stations)
      : prefix_(prefix), file_(file), nodes_(nodes), stations_(stations) {}

  void operator()(const MemberInfo&, double&) const {}
  void operator()(const MemberInfo&, FluidState&) const {}
  template <int dim>
  void operator()(const MemberInfo&, FlagState<dim>& flag) const {
    visit(flag, *this);
  }
  template <int rows, int options>
  void operator()(const MemberInfo& info,
                  Eigen::Matrix<double, rows, Eigen::Dynamic, options>& values) const {
    const std::string name = fmt::format("/{}{}", prefix_, info.name);
    const bool may_be_absent = rows == Eigen::Dynamic || info.steps_before > 0;
    if (may_be_absent && !file_.contains(name)) return;
    if constexpr (rows != Eigen::Dynamic) expect_nodes(name, rows);
    const auto segments = static_cast<hsize_t>(nodes_ / stations_ - 1);
    const hdf5::Array array = rows == Eigen::Dynamic
                                  ? file_.read(name, {segments, static_cast<hsize_t>(stations_)})
                                  : file_.read(name);
    file_.expect_finite(name, array.values);
    values.resize(static_cast<Eigen::Index>(array.shape[1]),
                  static_cast<Eigen::Index>(array.shape[0]));
    std::ranges::copy(array.values, values.data());
  }

 private:
  void expect_nodes(const std::string& name, int dim) const {
    const hdf5::Shape shape = file_.shape(name, {hdf5::any, hdf5::any});
    if (shape != hdf5::Shape{static_cast<hsize_t>(nodes_), static_cast<hsize_t>(dim)})
      file_.fail(
          fmt::format("holds {} nodes in {} dimensions, the case's flag has {} in {}; "
                      "restart with the case that wrote it",
                      shape[0], shape[1], nodes_, dim));
  }

  const char* prefix_;
  const hdf5::Reader& file_;
  int nodes_, stations_;
};

constexpr const char* tangent_array = "/tangent";
constexpr const char* coupled_prefix = "flag_";

void expect_time(const hdf5::Reader& file, double t) {
  if (t < 0) file.fail(fmt::format("has t = {}; a run starts at 0", t));
}

// The step before the checkpoint, and what it left of the flag.
template <int dim>
void expect_step_before(const hdf5::Reader& file, const FlagState<dim>& flag) {
  if (flag.previous_dt < 0)
    file.fail(fmt::format("has previous_dt = {}; a step is above 0, or 0 where there was none",
                          flag.previous_dt));
  if (flag.previous_dt > 0 && (flag.previous_x.size() == 0 || flag.previous_v.size() == 0))
    file.fail("lacks the flag of one step before, previous_x and previous_v");
}

// Of a coupled flag, whose time is the fluid's.
template <class Value, class State>
auto numbers_beside_time(State& state) {
  auto numbers = Numbers<Value>(state).list;
  std::erase_if(numbers, [](const auto& number) { return number.first == "t"; });
  return numbers;
}

}  // namespace

void write_state(const FluidState& state, const Fluid& fluid, hdf5::Writer* file) {
  visit(state, FluidWriter(fluid, file));
}

FluidState read_fluid_state(const hdf5::Reader& file, const Fluid& fluid) {
  FluidState state;
  visit(state, FluidReader(file, fluid));
  expect_time(file, state.t);
  return state;
}

template <int dim>
void write_state(const FlagState<dim>& state, hdf5::Writer& file) {
  for (const auto& [name, value] : Numbers<const double>(state).list)
    file.attributes({{name, *value}});
  visit(state, FlagWriter("", file));
}

template <int dim>
FlagState<dim> read_flag_state(const hdf5::Reader& file, int nodes) {
  FlagState<dim> state;
  for (const auto& [name, value] : Numbers<double>(state).list) *value = file.number("/", name);
  expect_time(file, state.t);
  visit(state, FlagReader("", file, nodes, 1));
  expect_step_before(file, state);
  return state;
}

template <int dim>
void write_flag_of(const CoupledState<dim>& state, double energy_at_start, hdf5::Writer& file) {
  std::vector<double> values;
  std::string meaning;
  for (const auto& [name, value] : numbers_beside_time<const double>(state)) {
    values.push_back(*value);
    meaning += name + ", ";
  }
  values.push_back(energy_at_start);
  file.write("/flag", {1, values.size()}, values, {{"meaning", meaning + "energy at the start"}});
  visit(state, FlagWriter(coupled_prefix, file));
}

template <int dim>
double read_flag_of(const hdf5::Reader& file, int nodes, int stations, CoupledState<dim>& state) {
  const auto numbers = numbers_beside_time<double>(state);
  const std::vector<double> values = file.read("/flag", {1, numbers.size() + 1}).values;
  file.expect_finite("/flag", values);
  for (std::size_t k = 0; k < numbers.size(); ++k) *numbers[k].second = values[k];
  state.flag.t = state.fluid.t;
  visit(state, FlagReader(coupled_prefix, file, nodes, stations));
  expect_step_before(file, state.flag);
  if (state.flag.previous_dt != state.fluid.previous_dt)
    file.fail(
        fmt::format("has previous_dt = {} of the flag and {} of the fluid; they step together",
                    state.flag.previous_dt, state.fluid.previous_dt));
  return values.back();
}

void write_tangent(const std::optional<KeptTangent>& tangent, hdf5::Writer& file) {
  if (!tangent) return;
  const std::vector<double>& entries = tangent->factors.entries;
  file.write(tangent_array, {entries.size()}, entries,
             {{"meaning", "entries of the flag's tangent matrix that was factored last"},
              {"mass_factor", tangent->mass_factor},
              {"is_definite", static_cast<std::int64_t>(tangent->factors.is_definite)}});
}

std::optional<KeptTangent> read_tangent(const hdf5::Reader& file) {
  if (!file.contains(tangent_array)) return std::nullopt;
  KeptTangent tangent{file.number(tangent_array, "mass_factor"),
                      {.is_definite = file.number(tangent_array, "is_definite") != 0,
                       .entries = file.list(tangent_array)}};
  file.expect_finite(tangent_array, tangent.factors.entries);
  return tangent;
}

template void write_state(const FlagState<2>&, hdf5::Writer&);
template void write_state(const FlagState<3>&, hdf5::Writer&);
template FlagState<2> read_flag_state(const hdf5::Reader&, int);
template FlagState<3> read_flag_state(const hdf5::Reader&, int);
template void write_flag_of(const CoupledState<2>&, double, hdf5::Writer&);
template void write_flag_of(const CoupledState<3>&, double, hdf5::Writer&);
template double read_flag_of(const hdf5::Reader&, int, int, CoupledState<2>&);
template double read_flag_of(const hdf5::Reader&, int, int, CoupledState<3>&);

}  // namespace pennon::dns
