/// The MPI ranks, that is processes, of a parallel run (mpiexec -n N pennon ...), and what they
/// agree on. A program that was not started so has one. Elsewhere in the code, too, a rank is an
/// MPI rank, unless a comment says that it is the rank of a matrix.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pennon::ranks {

int count();
/// The number of this rank, from 0.
int mine();
/// Whether this rank writes the files and speaks to the user.
inline bool is_leading() {
  return mine() == 0;
}

/// Over all ranks, each of which must call. The result is the same on every rank, to the last bit.
double sum(double);
double largest(double);
double least(double);
bool any(bool);
void sum(std::span<double> values);  ///< entry by entry, in place

/// The values of all ranks one behind the other, in the order of the ranks, on the leading rank;
/// nothing on the others. Each rank must call, here and below.
std::vector<double> gather(std::span<const double> values);

/// The values of all ranks on every rank.
std::vector<double> gather_all(std::span<const double> values);
void gather_all(std::span<const double> values, std::vector<double>& all);

/// Ends all ranks at once with an exit code: for a fault that one of them alone has met.
[[noreturn]] void abandon(int exit_code);

}  // namespace pennon::ranks
