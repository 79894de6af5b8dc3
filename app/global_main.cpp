/// pennon-global PROBLEM RESULT: the global modes of the problem that `pennon modes` wrote, into
/// RESULT (wire.hpp), and their fields beside it (fields_file.hpp). A program of its own, because
/// PETSc with complex numbers and PETSc with real ones cannot share a process. Exit codes as those
/// of pennon.
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <new>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/parallel/exit_code.hpp"
#include "common/parallel/ranks.hpp"
#include "common/petsc/petsc.hpp"
#include "common/process/local_mpi.hpp"
#include "common/standard_streams.hpp"
#include "modes/global/solve/slepc/krylov_schur.hpp"
#include "modes/global/solve/slepc/mumps_factors.hpp"
#include "modes/global/study/fields_file.hpp"
#include "modes/global/study/kept_pieces.hpp"
#include "modes/global/study/mode_frames.hpp"
#include "modes/global/study/wire.hpp"

namespace {

using namespace pennon;
using namespace pennon::modes;

// A rank that fails by itself ends all, for the others would wait for it.
void serve() {
  try {
    global::serve_mumps_factors();
  } catch (const std::exception& fault) {
    fmt::print(stderr, "pennon: {}\n", fault.what());
    ranks::abandon(exit_other);
  }
}

void solve(const std::filesystem::path& problem_file, const std::filesystem::path& result_file) {
  global::Problem problem;
  read_case_file(problem_file, {}, problem.schema).raise();
  const auto& [flag, flow, settings] = std::tie(problem.flag, problem.flow, problem.settings);
  const global::EigenSolver eigenpairs = global::coupled_eigensolver(global::mumps_factors());
  global::Result result = global::run(flag, flow, settings, eigenpairs);
  if (!result.found.modes.empty()) write_fields(result, result_file.parent_path());
  global::write_frames(result, static_cast<int>(settings.frames), result_file.parent_path());
  global::Findings findings{.spectrum = std::move(result.found)};
  global::KeptPieces pieces(result_file.parent_path() / "global_pieces.json",
                            resolved_text(problem.schema));
  if (settings.neutral.is_given)
    findings.neutral = global::neutral_curve(flag, flow, settings, eigenpairs,
                                             global::mumps_factors(), pieces.neutral());
  if (settings.map.is_given)
    findings.map = global::growth_map(flag, flow, settings, global::mumps_factors(), pieces.map());
  write_findings(findings, result_file);
  pieces.remove();
}

int run(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: pennon-global PROBLEM RESULT; pennon modes starts it\n");
    return exit_bad_input;
  }
  const petsc::Session session;
  const global::SlepcSession slepc;
  if (!ranks::is_leading()) {
    serve();
    return exit_done;
  }
  const global::MumpsRanks others;
  try {
    solve(argv[1], argv[2]);
  } catch (const std::bad_alloc&) {
    throw SolverError(
        "there is not enough memory for the global modes; a smaller modes.global.n_rho or n_theta "
        "needs less");
  }
  return exit_done;
}

}  // namespace

int main(int argc, char** argv) {
  keep_standard_streams();
  need_no_ssh();
  watch_for_interrupts();
  return exit_code_of([&] { return run(argc, argv); });
}
