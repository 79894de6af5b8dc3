/// The ranks of a parallel run (mpiexec -n N pennon ...), and what they agree on. A program that
/// was not started so has one.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pennon::ranks {

int count();
int mine();
/// Whether this rank writes the files and speaks to the user.
inline bool is_leading() {
  return mine() == 0;
}

/// Over all ranks; each must call. Sums are rounded alike on every rank.
double sum(double);
double largest(double);
double least(double);
bool any(bool);
void sum(std::span<double> values);  ///< each by itself, in place

/// The values of all ranks one behind the other, in the order of the ranks; empty but on the
/// leading one.
std::vector<double> gather(std::span<const double> values);

/// The same on every rank.
std::vector<double> gather_all(std::span<const double> values);
void gather_all(std::span<const double> values, std::vector<double>& all);

/// Ends all ranks at once with an exit code: for a fault that one of them alone has met.
[[noreturn]] void abandon(int exit_code);

}  // namespace pennon::ranks
