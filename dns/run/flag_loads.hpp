/// What acts on a flag by itself, beside its weight: the table [dns.loads].
#pragma once

#include <array>
#include <string>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "dns/flag/flag.hpp"

namespace pennon::dns {

struct LoadSettings {
  double pressure = 0;                          ///< follower pressure jump, rho_f V^2
  std::array<double, 3> load = {0, 0, 0};       ///< per area, keeping its direction, rho_f V^2
  std::array<double, 3> edge_load = {0, 0, 0};  ///< per span at the trailing edge, rho_f V^2 L
  std::string traction;                         ///< CSV file: force per area at places of the flag

  bool are_there() const;
};

void declare(Schema&, LoadSettings&);
void check(const LoadSettings&, const FlagParameters&, Faults&);

/// These loads on the flag's nodes, with its gravity. Throws InputError (file:line) where the file
/// of the tractions lacks something.
template <int dim>
FlagLoads<dim> loads_of(const LoadSettings&, const FlagParameters&, const Flag<dim>&);

/// The node nearest to a place at rest; x is not used in two dimensions.
int nearest_node(const FlagMesh&, double x, double y);

}  // namespace pennon::dns
