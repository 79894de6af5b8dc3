/// pennon-global PROBLEM RESULT: the global modes of the problem that `pennon modes` wrote, into
/// RESULT (JSON), and their fields beside it (fields_file.hpp). A program of its own, because PETSc
/// with complex numbers and PETSc with real ones cannot share a process. Exit codes as those of
/// pennon.
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/io/atomic_file.hpp"
#include "common/parallel/ranks.hpp"
#include "common/petsc/petsc.hpp"
#include "modes/global/solve/slepc/eigensolver.hpp"
#include "modes/global/solve/slepc/mumps_factors.hpp"
#include "modes/global/study/fields_file.hpp"
#include "modes/global/study/growth_map.hpp"
#include "modes/global/study/neutral_curve.hpp"
#include "modes/global/study/study.hpp"

namespace {

using namespace pennon;
using namespace pennon::modes;

constexpr int exit_done = 0;
constexpr int exit_other = 1;
constexpr int exit_bad_input = 2;
constexpr int exit_not_converged = 3;

// A rank that fails by itself ends all, for the others would wait for it.
void serve() {
  try {
    global::serve_mumps_factors();
  } catch (const std::exception& fault) {
    fmt::print(stderr, "pennon: {}\n", fault.what());
    ranks::abandon(exit_other);
  }
}

void solve(const char* problem_file, const char* result_file) {
  const petsc::Session session;
  const global::SlepcSession slepc;
  if (!ranks::is_leading()) return serve();
  const global::MumpsRanks others;
  global::Problem problem;
  read_case_file(problem_file, {}, problem.schema).raise();
  const global::EigenSolver eigenpairs = global::coupled_eigensolver(global::mumps_factors());
  const global::Result result =
      global::run(problem.flag, problem.flow, problem.settings, eigenpairs);
  if (!result.modes.empty()) write_fields(result, std::filesystem::path(result_file).parent_path());
  nlohmann::ordered_json json = to_json(result);
  if (problem.settings.neutral.is_given)
    json["global"].update(to_json(global::neutral_curve(
        problem.flag, problem.flow, problem.settings, eigenpairs, global::mumps_factors())));
  if (problem.settings.map.is_given)
    json["map"] = to_json(
        global::growth_map(problem.flag, problem.flow, problem.settings, global::mumps_factors()));
  write_file(result_file, json.dump(1) + "\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: pennon-global PROBLEM RESULT; pennon modes starts it\n");
    return exit_bad_input;
  }
  watch_for_interrupts();
  try {
    solve(argv[1], argv[2]);
    return exit_done;
  } catch (const InputError& fault) {
    fmt::print(stderr, "{}\n", fault.what());
    return exit_bad_input;
  } catch (const SolverError& fault) {
    fmt::print(stderr, "pennon: {}\n", fault.what());
    return exit_not_converged;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr,
               "pennon: there is not enough memory for the global modes; a smaller "
               "modes.global.n_rho or n_theta needs less\n");
    return exit_not_converged;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "pennon: {}\n", fault.what());
    return exit_other;
  }
}
