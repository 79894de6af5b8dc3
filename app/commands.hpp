/// The commands of pennon, one function each; app/main.cpp reads the command line and calls them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/run.hpp"

namespace pennon::app {

/// `pennon lsa CASE`: local stability: points, curves, maps.
void run_lsa(const Options&);

/// `pennon modes CASE`: normal modes, and global modes where the case has [modes.global].
void run_modes(const Options&);

struct RestartOptions {
  std::optional<std::string> checkpoint;  ///< from which the run goes on
  bool change = false;                    ///< other physics than there are meant
};

/// `pennon dns CASE`: direct simulation of flag and flow, or of the flag by itself.
void run_dns(const Options&, const RestartOptions&);

struct AnalyzeOptions {
  std::string run;                 ///< the folder of the run, or of its case
  std::string output;              ///< empty: `analysis` beside or in the run's folder
  std::optional<double> from, to;  ///< of the linear phase, in place of the case's
  bool json = false, quiet = false, force = false;
  std::string command_line;
};

/// `pennon analyze RUN`: growth, limit cycle, phases and energies of a coupled run, with pictures.
/// Throws InputError where RUN is none.
void run_analyze(const AnalyzeOptions&);

struct DecomposeOptions {
  std::string source;                  ///< a run's or its case's folder, or a file of another code
  std::string output;                  ///< empty: `decompose` beside the run, or in results/
  std::vector<std::string> overrides;  ///< decompose.key=value
  bool json = false, quiet = false, force = false;
  std::string command_line;
};

/// `pennon decompose SOURCE`: modes of a run's output, or of any snapshots.
/// Throws InputError where SOURCE holds none, or they do not serve.
void run_decompose(const DecomposeOptions&);

/// `pennon compare CASE`: local theory, global modes and simulation of the same flag side by side.
/// `run`: the folder of a run of `pennon dns`, or of its case; empty: results/<case name>, if there
/// is one there.
/// Throws InputError where that run is of another flag.
void run_compare(const Options&, const std::string& run);

/// `pennon plot FILE...`: pictures beside the files; of a folder, those of all files in it and in
/// the commands' folders below it. Prints their names unless quiet.
void run_plot(const std::vector<std::string>& files, bool quiet);

/// `pennon reference`: the reference of the case file, in Markdown, on standard output.
void run_reference();

}  // namespace pennon::app
