/// The command line of pennon: reads it and runs one command. Exit codes: 0 done, 2 bad input, 3
/// not converged or blown up, 1 anything else (common/parallel/exit_code.hpp).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <string>

#include "app/commands.hpp"
#include "app/completion.hpp"
#include "app/manual_page.hpp"
#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/parallel/exit_code.hpp"
#include "common/petsc/petsc.hpp"
#include "common/process/local_mpi.hpp"
#include "common/record/version.hpp"
#include "common/standard_streams.hpp"

namespace {

using namespace pennon;

std::string version_text() {
  std::string text = fmt::format("pennon {} (commit {})\n", version(), commit());
  for (const auto& [name, number] : library_versions())
    text += fmt::format("  {} {}\n", name, number);
  return text;
}

void add_case_options(CLI::App& command, app::Options& options) {
  command.add_option("CASE", options.case_file, "the case file (TOML)")->required();
  command.add_option("--output", options.output,
                     "folder for the results [results/<case name>/<command>]");
  command.add_flag("--force", options.force,
                   "replace what the folder holds of another case or command");
  command
      .add_option("--set", options.overrides, "table.key=value in place of the file's; repeatable")
      ->allow_extra_args(false);
  command.add_flag("--check", options.check,
                   "validate, print the resolved case with every default, compute nothing");
  command.add_flag("--json", options.json, "one JSON object on standard output");
  command.add_flag("--quiet", options.quiet, "no progress and no summary");
}

void add_analyze_options(CLI::App& command, app::AnalyzeOptions& options) {
  command
      .add_option("RUN", options.run, "the folder of a coupled run of pennon dns, or of its case")
      ->required();
  command.add_option("--output", options.output,
                     "folder for the results [analysis, beside or in the run's folder]");
  command.add_flag("--force", options.force, "replace what the folder holds of another analysis");
  command.add_option("--from", options.from, "begin of the linear phase, in L/V [sought]");
  command.add_option("--to", options.to, "its end [sought]");
  command.add_flag("--json", options.json, "one JSON object on standard output");
  command.add_flag("--quiet", options.quiet, "no summary");
}

void add_decompose_options(CLI::App& command, app::DecomposeOptions& options) {
  command
      .add_option(
          "SOURCE", options.source,
          "the folder of a run of pennon dns, or of its case; an HDF5 file of snapshots; a CSV "
          "file of signals")
      ->required();
  command.add_option(
      "--output", options.output,
      "folder for the results [decompose, beside the run's, or results/<file>/decompose]");
  command.add_flag("--force", options.force,
                   "replace what the folder holds of other data or settings");
  command
      .add_option("--set", options.overrides,
                  "decompose.key=value in place of the case's; repeatable")
      ->allow_extra_args(false);
  command.add_flag("--json", options.json, "one JSON object on standard output");
  command.add_flag("--quiet", options.quiet, "no summary");
}

std::string command_line(int argc, char** argv) {
  std::string text = "pennon";
  for (int i = 1; i < argc; ++i) text += fmt::format(" {}", argv[i]);
  return text;
}

// What the documentation and the installation are made of.
void add_commands_without_case(CLI::App& app) {
  CLI::App* reference = app.add_subcommand("reference", "every key of a case file, in Markdown");
  reference->footer("Example: pennon reference > docs/case-file.md");
  reference->callback([] { app::run_reference(); });

  // For the installation: without a group, so that help does not show them.
  app.add_subcommand("completion", "the completion of these commands by bash")
      ->group("")
      ->callback([&app] { app::print(app::bash_completion(app)); });
  app.add_subcommand("manual", "the manual page")->group("")->callback([&app] {
    app::print(app::manual_page(app, version()));
  });
}

int run(int argc, char** argv) {
  CLI::App app("pennon: the flutter of flags and thin membranes in a stream", "pennon");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app::Options options;
  options.command_line = command_line(argc, argv);
  std::vector<std::string> files;

  CLI::App* lsa = app.add_subcommand("lsa", "local stability: points, curves, maps");
  add_case_options(*lsa, options);
  lsa->footer("Example: pennon lsa data/cases/table1/C2D.toml --set flag.mu=0.05");
  lsa->callback([&] { app::run_lsa(options); });

  CLI::App* modes = app.add_subcommand("modes", "normal and global modes of the flag");
  add_case_options(*modes, options);
  modes->footer(
      "Example: pennon modes data/cases/table1/C2D.toml --set modes.normal.family=in_vacuo");
  modes->callback([&] { app::run_modes(options); });

  app::RestartOptions restart;
  CLI::App* dns =
      app.add_subcommand("dns",
                         "direct simulation of flag and flow together, of the flag by itself, or "
                         "of the flow about a flag that moves as prescribed");
  add_case_options(*dns, options);
  dns->add_option("--restart", restart.checkpoint, "go on from this checkpoint");
  dns->add_flag("--change", restart.change,
                "go on with other physics than the checkpoint's, knowingly; the record says so");
  dns->footer("Example: pennon dns data/cases/table1/C2D.toml");
  dns->callback([&] { app::run_dns(options, restart); });

  app::AnalyzeOptions analyze_options;
  analyze_options.command_line = options.command_line;
  CLI::App* analyze = app.add_subcommand(
      "analyze", "what a coupled run says: growth, limit cycle, phases, energies, pictures");
  add_analyze_options(*analyze, analyze_options);
  analyze->footer("Example: pennon analyze results/C2D --from 2 --to 8");
  analyze->callback([&] { app::run_analyze(analyze_options); });

  app::DecomposeOptions decompose_options;
  decompose_options.command_line = options.command_line;
  CLI::App* decompose = app.add_subcommand(
      "decompose", "modal decomposition of a run's output, or of the snapshots of another code");
  add_decompose_options(*decompose, decompose_options);
  decompose->footer("Example: pennon decompose results/C2D --set decompose.method=pod");
  decompose->callback([&] { app::run_decompose(decompose_options); });

  std::string compared_run;
  CLI::App* compare = app.add_subcommand(
      "compare", "local theory, global modes and simulation of the same flag, side by side");
  add_case_options(*compare, options);
  compare->add_option("--run", compared_run,
                      "folder of the simulation, or of its case [results/<case name>]");
  compare->footer("Example: pennon compare data/cases/table1/C2D.toml --run results/C2D");
  compare->callback([&] { app::run_compare(options, compared_run); });

  CLI::App* plot = app.add_subcommand("plot", "pictures of output files, beside them");
  plot->add_option("FILE", files, "HDF5 files that pennon wrote, or folders of them")->required();
  plot->add_flag("--quiet", options.quiet, "do not print the pictures' names");
  plot->footer("Example: pennon plot results/C2D/lsa/map.h5");
  plot->callback([&] { app::run_plot(files, options.quiet); });

  add_commands_without_case(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    const int status = app.exit(fault);
    // What --help and --version have said must have come out.
    if (!std::cout.flush()) throw FileError("the answer cannot be written to standard output");
    app::print("");
    return status == 0 ? exit_done : exit_bad_input;
  }
  return exit_done;
}

// Started by mpiexec: only then do all commands begin with MPI, which takes its time.
bool is_parallel() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMI_SIZE") != nullptr;
}

}  // namespace

int main(int argc, char** argv) {
  keep_standard_streams();
  need_no_ssh();
  watch_for_interrupts();
  return exit_code_of([&] {
    if (is_parallel()) petsc::start();
    return run(argc, argv);
  });
}
