#include "common/process/local_mpi.hpp"

#include <cstdlib>

#include "common/process/process.hpp"

namespace pennon {

void need_no_ssh() {
  constexpr int keep_what_is_set = 0;
  if (!find_program("ssh") && !find_program("rsh"))
    setenv("OMPI_MCA_plm_rsh_agent", "", keep_what_is_set);
}

}  // namespace pennon
