/// LU factors by MUMPS (Amestoy, Duff, L'Excellent & Koster 2001), which solves many right-hand
/// sides together, through PETSc with complex numbers. Under mpiexec all ranks share the factors
/// and their work; the leading rank alone has the matrix and does everything else.
#pragma once

#include <memory>

#include "modes/global/solve/sparse_factors.hpp"

namespace pennon::modes::global {

/// Called on the leading rank, within a petsc::Session. PETSc's options such as
/// -global_mat_mumps_icntl_7 reach MUMPS. Where the memory is not enough, factor() throws
/// SolverError that names the memory needed and by how much the grid has to be smaller.
std::shared_ptr<SparseFactors> mumps_factors();

/// Called on every other rank: takes part in the leading rank's factors until that destroys its
/// MumpsRanks.
void serve_mumps_factors();

/// Held by the leading rank as long as it makes factors; its destruction ends serve_mumps_factors()
/// on the other ranks.
class MumpsRanks {
 public:
  MumpsRanks() = default;
  ~MumpsRanks();
  MumpsRanks(const MumpsRanks&) = delete;
  MumpsRanks& operator=(const MumpsRanks&) = delete;
};

}  // namespace pennon::modes::global
