#include "app/global_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/kept_modes.hpp"
#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/io/atomic_file.hpp"
#include "common/parallel/exit_code.hpp"
#include "common/parallel/ranks.hpp"
#include "common/process/process.hpp"

namespace pennon::app {
namespace {

std::filesystem::path program_beside_this() {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const auto program = find_program(folder / "pennon-global");
  if (!program)
    throw FileError(fmt::format(
        "pennon-global, the program that finds global modes, is not beside pennon in {}",
        folder.string()));
  return *program;
}

// The sentence without the name of the program before it, and without what mpiexec says, between
// lines of dashes, of a program that failed; where mpiexec alone speaks, what it says.
std::string sentence_of(std::string errors) {
  constexpr std::string_view name = "pennon: ", dashes = "\n-----";
  if (errors.starts_with(dashes.substr(1))) errors.erase(0, errors.find('\n') + 1);
  errors = errors.substr(0, errors.find(dashes));
  while (!errors.empty() && errors.back() == '\n') errors.pop_back();
  return errors.starts_with(name) ? errors.substr(name.size()) : errors;
}

// As it was before it was printed.
InputError input_error(const std::string& sentence) {
  const std::size_t colon = sentence.find(": ");
  if (colon == std::string::npos) return {"modes.global", sentence};
  return {sentence.substr(0, colon), sentence.substr(colon + 2)};
}

// What a failed end of pennon-global says. mpiexec tells of a signal by a status of 128 and more.
void raise(const ChildEnd& end, bool keeps_pieces) {
  const std::string sentence = sentence_of(end.messages);
  stop_if_interrupted(keeps_pieces ? "the finished points of the neutral curve or columns of the "
                                     "map are kept; the same command goes on with them"
                                   : "no global modes were written");
  if (end.exit_status == exit_bad_input) throw input_error(sentence);
  if (end.exit_status == exit_not_converged) throw SolverError(sentence);
  constexpr int signals = 128;
  if (const int signal = end.signal != 0 ? end.signal : end.exit_status - signals; signal >= 0)
    throw std::runtime_error(
        fmt::format("pennon-global was ended by signal {}, perhaps for want of memory; a smaller "
                    "modes.global.n_rho or n_theta needs less. {}",
                    signal, sentence));
  if (!end.is_success()) throw std::runtime_error("pennon-global: " + sentence);
}

// pennon-global with these arguments, shared by so many ranks.
ChildProgram global_program(std::vector<std::string> arguments, std::int64_t shared_by,
                            bool shows_progress) {
  const std::filesystem::path program = program_beside_this();
  const auto takes_progress = [shows_progress](std::string_view line) {
    const bool is_progress = std::ranges::any_of(
        modes::global::names_of_progress,
        [line](std::string_view name) { return line.starts_with(std::string(name) + ": "); });
    if (is_progress && shows_progress) fmt::print(stderr, "{}\n", line);
    return is_progress;
  };
  if (shared_by == 1)
    return {.program = program,
            .arguments = std::move(arguments),
            .is_interruptible = true,
            .takes_line = takes_progress};
  const auto mpiexec = find_program(PENNON_MPIEXEC);
  if (!mpiexec)
    throw InputError("modes.global.ranks",
                     fmt::format("= {} needs {}, which is not there", shared_by, PENNON_MPIEXEC));
  arguments.insert(arguments.begin(), {"-n", std::to_string(shared_by), program.string()});
  return {.program = *mpiexec,
          .arguments = std::move(arguments),
          .is_interruptible = true,
          .takes_line = takes_progress};
}

}  // namespace

void expect_one_rank_for_global_modes() {
  if (ranks::count() > 1)
    throw InputError("mpiexec",
                     fmt::format("started {0} ranks, but pennon itself finds global modes on one; "
                                 "modes.global.ranks = {0} shares the work",
                                 ranks::count()));
}

modes::global::Findings solve_global_modes(const modes::global::Problem& problem,
                                           const OutputFolder& folder, bool shows_progress) {
  const std::filesystem::path asked = folder / "global_problem.toml",
                              answered = folder / "global_modes.json";
  std::error_code ignored;
  std::filesystem::remove(answered, ignored);  // of another problem, perhaps
  write_file(asked, problem_text(problem));
  const modes::global::Settings& settings = problem.settings;
  raise(run_program(
            global_program({asked.string(), answered.string()}, settings.ranks, shows_progress)),
        settings.neutral.is_given || settings.map.is_given);
  return modes::global::read_findings(answered);
}

}  // namespace pennon::app
