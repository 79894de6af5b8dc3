#include "app/case.hpp"

namespace pennon::app {
namespace {

// A path given in a case counts from the case file's folder; the resolved case holds it whole.
void resolve(std::string& path, const std::string& key, const std::filesystem::path& case_file,
             Faults& faults) {
  if (path.empty()) return;
  path = std::filesystem::absolute(case_file.parent_path() / path).lexically_normal().string();
  if (!std::filesystem::is_regular_file(path))
    faults.about(key, key + " names " + path + ", where there is no file");
}

modes::global::Discretisation discretisation_of(const dns::Settings& settings) {
  const dns::FluidSettings& fluid = settings.fluid;
  return {.n_rho = fluid.n_rho,
          .n_theta = fluid.n_theta,
          .n_x = settings.n_x,
          .R = fluid.R,
          .wall_spacing = fluid.wall_spacing,
          .wake_clustering = fluid.wake_clustering,
          .dt = settings.dt,
          .convection = fluid.convection};
}

}  // namespace

Case::Case() {
  declare(schema, flag);
  declare(schema, flow, has_flow);
  declare(schema, lsa);
  declare(schema, modes);
  declare(schema, global_modes);
  declare(schema, dns);
  declare(schema, analysis);
  declare(schema, decompose);
  declare(schema, compare);
}

Case::Case(const std::filesystem::path& file, std::span<const std::string> overrides,
           const Asked& asked)
    : Case() {
  name = file.stem().string();
  Faults faults = read_case_file(file, overrides, schema);
  global_modes = modes::global::resolve(global_modes, flag, discretisation_of(dns));
  resolve(lsa.marks.table, "lsa.marks.table", file, faults);
  resolve(lsa.verdicts.table, "lsa.verdicts.table", file, faults);
  resolve(modes.decompose.samples, "modes.decompose.samples", file, faults);
  resolve(dns.loads.traction, "dns.loads.traction", file, faults);
  resolve(decompose.global_modes, "decompose.global_modes", file, faults);
  resolve(dns.initial.global_modes, "dns.initial.global_modes", file, faults);
  if (asked.flow && !has_flow)
    faults.about("flow", "[flow] is missing: Re, the Reynolds number V L/nu, has no default");
  check(lsa, flag, flow, faults);
  check(modes, flag, flow, asked.modes, faults);
  check(global_modes, flag, has_flow, asked.global_modes, faults);
  check(dns, flag, has_flow, asked.dns, faults);
  if (const auto mode = dns::normal_mode_of(dns, has_flow))
    check_family(modes, mode->m, mode->table, flag, flow, faults);
  check(analysis, faults);
  check(decompose, faults);
  check(compare, flag, faults);
  faults.raise();
  faults_ = std::move(faults);
  lsa.is_given = lsa.is_given || asked.lsa;
  modes.is_given = modes.is_given || asked.modes;
  global_modes.is_given = global_modes.is_given || asked.global_modes;
  dns.is_given = dns.is_given || asked.dns;
  compare.is_given = compare.is_given || asked.compare;
}

}  // namespace pennon::app
