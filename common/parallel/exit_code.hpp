/// How a program of pennon ends: its exit codes, and the one place where exceptions become a
/// message and a code.
#pragma once

#include <functional>
#include <string>

namespace pennon {

enum ExitCode : int { exit_done = 0, exit_other = 1, exit_bad_input = 2, exit_not_converged = 3 };

/// Says a sentence on standard error, after the program's name; the leading rank alone.
void say(const std::string& text);

/// Calls `program` and returns its exit code; where it throws, says why on standard error and
/// returns
///
///   InputError               exit_bad_input       each fault on its line
///   SolverError              exit_not_converged
///   Interrupted, any other   exit_other
///
/// All MPI ranks throw the first three, so that only the leading one speaks. Any other exception
/// may be one rank's alone (a full disk, a bug): that rank speaks and, as the others would wait for
/// it, ends them all.
int exit_code_of(const std::function<int()>& program);

}  // namespace pennon
