/// Which refinements of a flag by itself are compared: the table [dns.convergence].
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "dns/flag/settings.hpp"
#include "dns/run/output_settings.hpp"

namespace pennon::dns {

struct ConvergenceSettings {
  bool is_given = false;
  std::vector<std::int64_t> n;      ///< nodes along each side
  std::vector<double> dt;           ///< or time steps
  std::optional<double> reference;  ///< exact z of the probe, or its exact angular frequency
};

void declare(Schema&, ConvergenceSettings&);
/// The faults of the table and of each flag that it asks for.
void check(const ConvergenceSettings&, const FlagSettings&, const OutputSettings&, double t_end,
           const FlagParameters&, Faults&);

/// The sentence about too many steps, where there are; `key` is the one that makes them.
void check_steps(const std::string& key, double dt, double t_end, Faults&);

}  // namespace pennon::dns
