/// Open MPI on a machine without ssh.
#pragma once

namespace pennon {

/// Open MPI looks for ssh or rsh whenever it starts, also where all its processes are of one
/// machine, and ends the program where it finds neither, as in a bare container. Where there is
/// none, this says that none is needed (OMPI_MCA_plm_rsh_agent), unless the environment says
/// something already. To be called before MPI starts and before a child that uses MPI does.
void need_no_ssh();

}  // namespace pennon
