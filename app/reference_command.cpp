#include <fmt/format.h>

#include "app/case.hpp"
#include "app/commands.hpp"

namespace pennon::app {

void run_reference() {
  const Case defaults;
  print(fmt::format(
      "# The case file\n\n"
      "One TOML file describes a case for every command. This page is generated from the "
      "declarations\nin the code (`pennon reference`); a test keeps it in step. Scales: chord L, "
      "inflow V, fluid\ndensity rho_f. A range is `{{ from = a, to = b, points = n, scale = "
      "\"log\" }}` "
      "(scale \"linear\" if\nleft out); where a range is asked for, a list of numbers will do "
      "unless "
      "said otherwise.\n{}",
      reference_text(defaults.schema)));
}

}  // namespace pennon::app
