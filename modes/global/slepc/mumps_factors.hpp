/// LU factors by MUMPS (Amestoy, Duff, L'Excellent & Koster 2001), which solves many right-hand
/// sides together, through PETSc with complex numbers.
#pragma once

#include <memory>

#include "modes/global/sparse_factors.hpp"

namespace pennon::modes::global {

/// Within a petsc::Session. PETSc's options -global_mat_mumps_icntl_7 and the like reach them. Its
/// factor() throws SolverError that names the memory needed, and by how much a grid has to be
/// smaller, where there is not enough.
std::shared_ptr<SparseFactors> mumps_factors();

}  // namespace pennon::modes::global
