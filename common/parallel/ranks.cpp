#include "common/parallel/ranks.hpp"

#include <mpi.h>

#include <cstdlib>
#include <numeric>

namespace pennon::ranks {
namespace {

bool is_parallel() {
  int is_initialized = 0, is_finalized = 0;
  MPI_Initialized(&is_initialized);
  MPI_Finalized(&is_finalized);
  return is_initialized && !is_finalized;
}

double reduced(double value, MPI_Op operation) {
  if (count() == 1) return value;
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, operation, MPI_COMM_WORLD);
  return value;
}

}  // namespace

int count() {
  int count = 1;
  if (is_parallel()) MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

int mine() {
  int rank = 0;
  if (is_parallel()) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

double sum(double value) {
  return reduced(value, MPI_SUM);
}
double largest(double value) {
  return reduced(value, MPI_MAX);
}
double least(double value) {
  return reduced(value, MPI_MIN);
}
bool any(bool claim) {
  return largest(claim ? 1 : 0) > 0;
}

void sum(std::span<double> values) {
  if (count() > 1)
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD);
}

std::vector<double> gather(std::span<const double> values) {
  if (count() == 1) return {values.begin(), values.end()};
  int size = static_cast<int>(values.size());
  std::vector<int> sizes(static_cast<std::size_t>(count())), offsets(sizes.size());
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::exclusive_scan(sizes.begin(), sizes.end(), offsets.begin(), 0);
  std::vector<double> all;
  if (is_leading())
    all.resize(static_cast<std::size_t>(offsets.back()) + static_cast<std::size_t>(sizes.back()));
  MPI_Gatherv(values.data(), size, MPI_DOUBLE, all.data(), sizes.data(), offsets.data(), MPI_DOUBLE,
              0, MPI_COMM_WORLD);
  return all;
}

std::vector<double> gather_all(std::span<const double> values) {
  std::vector<double> all;
  gather_all(values, all);
  return all;
}

void gather_all(std::span<const double> values, std::vector<double>& all) {
  if (count() == 1) {
    all.assign(values.begin(), values.end());
    return;
  }
  all = gather(values);
  auto size = static_cast<int>(all.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
  all.resize(static_cast<std::size_t>(size));
  MPI_Bcast(all.data(), size, MPI_DOUBLE, 0, MPI_COMM_WORLD);
}

void abandon(int exit_code) {
  if (is_parallel()) MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::exit(exit_code);
}

}  // namespace pennon::ranks
