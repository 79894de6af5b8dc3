/// LU factors by MUMPS (Amestoy, Duff, L'Excellent & Koster 2001), which solves many right-hand
/// sides together, through PETSc with complex numbers. Started by mpiexec, all ranks share the
/// factors and their work; the matrix and all the rest is the leading rank's.
#pragma once

#include <memory>

#include "modes/global/solve/sparse_factors.hpp"

namespace pennon::modes::global {

/// Within a petsc::Session, on the leading rank. PETSc's options -global_mat_mumps_icntl_7 and the
/// like reach them. Its factor() throws SolverError that names the memory needed, and by how much a
/// grid has to be smaller, where there is not enough.
std::shared_ptr<SparseFactors> mumps_factors();

/// On every other rank: takes part in the leading one's factors until that ends its MumpsRanks.
void serve_mumps_factors();

/// On the leading rank, for as long as it makes factors: lets the others go at the end.
class MumpsRanks {
 public:
  MumpsRanks() = default;
  ~MumpsRanks();
  MumpsRanks(const MumpsRanks&) = delete;
  MumpsRanks& operator=(const MumpsRanks&) = delete;
};

}  // namespace pennon::modes::global
