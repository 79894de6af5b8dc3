#include "dns/run/flag_loads.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "common/case/about_key.hpp"
#include "common/errors.hpp"
#include "common/io/csv.hpp"

namespace pennon::dns {
namespace {

template <int dim>
Eigen::Matrix<double, dim, 1> components(const std::array<double, 3>& vector) {
  return Eigen::Map<const Eigen::Vector3d>(vector.data()).template tail<dim>();
}

// Adds the forces per area of a table to the nodes nearest to its places. Throws InputError
// (file:line).
template <int dim>
void add_traction(const std::filesystem::path& file, const Flag<dim>& flag,
                  NodeVectors<dim>& forces) {
  const CsvTable table(file);
  table.expect_only(dim == 3 ? std::vector<std::string>{"x", "y", "f_x", "f_y", "f_z"}
                             : std::vector<std::string>{"y", "f_y", "f_z"});
  table.expect_each_once(
      dim == 3 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"y"}, "the place");
  const auto number = [&](std::size_t row, const char* column) {
    const auto value = table.number(row, table.column(column));
    if (!value) throw InputError(table.place(row), fmt::format("{} is missing", column));
    return *value;
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double x = dim == 3 ? number(row, "x") : 0.0;
    const int node = nearest_node(flag.mesh(), x, number(row, "y"));
    Eigen::Matrix<double, dim, 1> per_area;
    if constexpr (dim == 3) per_area[0] = number(row, "f_x");
    per_area[dim - 2] = number(row, "f_y");
    per_area[dim - 1] = number(row, "f_z");
    forces.col(node) += flag.mass()[node] / flag.material().mu * per_area;
  }
}

}  // namespace

bool LoadSettings::are_there() const {
  return pressure != 0 || load != std::array<double, 3>{} || edge_load != std::array<double, 3>{} ||
         !traction.empty();
}

void declare(Schema& schema, LoadSettings& loads) {
  schema.table("dns.loads", "What acts on a flag by itself, beside [flag] gravity.")
      .key({"pressure", &loads.pressure,
            "jump, below minus above, normal to the deformed flag, in rho_f V^2"})
      .key({"load", &loads.load,
            "force per area along x, y, z, keeping its direction, in rho_f V^2"})
      .key({"edge_load", &loads.edge_load,
            "force per span on the trailing edge along x, y, z, in rho_f V^2 L"})
      .key({"traction", &loads.traction,
            "CSV file with columns x, y, f_x, f_y, f_z: force per area, keeping its direction, at "
            "the node nearest to each place (x, y) at rest; in two dimensions y, f_y, f_z"});
}

void check(const LoadSettings& loads, const FlagParameters& flag, Faults& faults) {
  if (!flag.gamma && (loads.load[0] != 0 || loads.edge_load[0] != 0 || flag.gravity[0] != 0))
    about_key(faults, "dns.loads",
              "or flag.gravity acts along x, but without flag.gamma the flag is two-dimensional");
}

template <int dim>
FlagLoads<dim> loads_of(const LoadSettings& settings, const FlagParameters& parameters,
                        const Flag<dim>& flag) {
  const FlagMesh& mesh = flag.mesh();
  FlagLoads<dim> loads;
  loads.gravity = components<dim>(parameters.gravity);
  if (settings.pressure != 0)
    loads.pressure = Eigen::VectorXd::Constant(flag.elements(), settings.pressure);
  const Eigen::Matrix<double, dim, 1> per_area = components<dim>(settings.load);
  const Eigen::Matrix<double, dim, 1> per_span = components<dim>(settings.edge_load);
  if (per_area.isZero(0) && per_span.isZero(0) && settings.traction.empty()) return loads;
  loads.node_forces.setZero(dim, mesh.nodes());
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j) {
      loads.node_forces.col(mesh.index(i, j)) += mesh.area(i, j) * per_area;
      if (j + 1 == mesh.chord_nodes())
        loads.node_forces.col(mesh.index(i, j)) += mesh.span_share(i) * per_span;
    }
  if (!settings.traction.empty()) add_traction(settings.traction, flag, loads.node_forces);
  return loads;
}

template FlagLoads<2> loads_of(const LoadSettings&, const FlagParameters&, const Flag<2>&);
template FlagLoads<3> loads_of(const LoadSettings&, const FlagParameters&, const Flag<3>&);

int nearest_node(const FlagMesh& mesh, double x, double y) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j)
      if (const double distance = std::hypot(mesh.x(i) - x, mesh.y(j) - y); distance < least) {
        least = distance;
        best = mesh.index(i, j);
      }
  return best;
}

}  // namespace pennon::dns
