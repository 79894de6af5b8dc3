#include "tests/support/foreign_files.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "analysis/decomposition/foreign_file.hpp"
#include "analysis/decomposition/study.hpp"
#include "analysis/figures/plot.hpp"
#include "analysis/signal/run_study.hpp"
#include "analysis/signal/series.hpp"
#include "app/case.hpp"
#include "common/errors.hpp"
#include "common/io/output_folder.hpp"
#include "dns/run/flag_run.hpp"
#include "dns/run/flow_mode_file.hpp"
#include "dns/run/fluid_run.hpp"
#include "dns/run/restart.hpp"
#include "modes/global/study/neutral_report.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/global_findings.hpp"
#include "tests/support/synthetic_run.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {
namespace {

namespace fs = std::filesystem;

long peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

constexpr const char* flow_case =
    "[flag]\nmu = 0.3\nK_B = 1e-3\ndamping = 0.02\ngamma = 2\n[flow]\nRe = 100\n"
    "[dns]\nn_x = 4\nn_rho = 8\nn_theta = 16\nR = 3\nwall_spacing = 0.1\ndt = 0.02\nt_end = 0.2\n"
    "[dns.initial]\nA = [0.01, 0.005]\n[dns.probes]\ny = [1.5]\nz = [0.1]\n"
    "[dns.output]\nshape_interval = 0.1\nfield_interval = 0.2\n";
constexpr const char* flag_case =
    "[flag]\nmu = 1\nK_B = 0.1\ngamma = 1\n[dns]\nn_x = 5\ndt = 0.01\nt_end = 0.1\n"
    "[dns.flag]\nn_y = 6\n[dns.initial]\nangle = 0.2\n[dns.output]\nshape_interval = 0.05\n";
constexpr const char* modes_case =
    "[flag]\nmu = 0.3\nK_B = 1e-3\ndamping = 0.02\n[flow]\nRe = 100\n"
    "[modes.global]\nn_modes = 2\ntarget = [0.4, 2.6]\nadjoint = true\nn_rho = 12\nn_theta = 24\n"
    "R = 3\nwall_spacing = 0.1\n";

// One to three words changed, or some inserted, taken out, or cut off.
std::string damage_bytes(std::string bytes, std::uint64_t seed, const fs::path& copy) {
  std::mt19937_64 engine(seed);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(engine() % count); };
  std::string what;
  for (std::size_t changes = 1 + below(3); changes > 0 && !bytes.empty(); --changes) {
    const std::size_t place = below(bytes.size()), length = 1 + below(40);
    const std::size_t kind = below(5);
    what += fmt::format("change {} of {} bytes at {}; ", kind, length, place);
    if (kind == 0) bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
    if (kind == 1) bytes.insert(place, length, static_cast<char>(below(256)));
    if (kind == 2) bytes.erase(place, length);
    if (kind == 3) bytes.resize(place);
    if (kind == 4) bytes += std::string(length, static_cast<char>(below(256)));  // a torn tail
  }
  write_text(copy, bytes);
  return what;
}

}  // namespace

ForeignFiles::ForeignFiles() {
  add_lsa();
  add_modes();
  add_flag();
  add_flow();
  add_oblique_run();
  add_snapshots();
}

fs::path ForeignFiles::run(const std::string& command, const std::string& name,
                           const std::string& case_text) {
  const fs::path file = write_text(folder_ / (name + ".toml"), case_text);
  const pid_t child = start_program(
      {PENNON_EXECUTABLE, command, file.string(), "--quiet", "--output", (folder_ / name).string()},
      folder_ / "out.txt", folder_ / "err.txt");
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(command + " " + name + ": " + read_text(folder_ / "err.txt"));
  return folder_ / name;
}

void ForeignFiles::add(const std::string& name, const fs::path& file, Read read) {
  read(file);  // as it is, it is taken
  kinds_.push_back({name, folder_ / "damaged.h5",
                    [mutator = Hdf5Mutator(file)](std::uint64_t seed, const fs::path& copy) {
                      return mutator.write(seed, copy);
                    },
                    std::move(read)});
}

// The history beside the checkpoint, damaged, with the checkpoint as it is; and the checkpoint,
// damaged, with the history beside it.
void ForeignFiles::add_records(const std::string& name, const fs::path& checkpoint,
                               const Read& restart) {
  fs::path records;
  for (const auto& entry : fs::directory_iterator(checkpoint.parent_path()))
    if (entry.path().extension() == ".rows") records = entry.path();
  fs::copy_file(records, folder_ / records.filename().string());
  add("restart of " + name, checkpoint, restart);
  const fs::path apart = folder_ / (name + " apart");
  fs::create_directory(apart);
  const fs::path copy = apart / "checkpoint.h5";
  fs::copy_file(checkpoint, copy);
  kinds_.push_back({"history of " + name, apart / records.filename(),
                    [bytes = read_text(records)](std::uint64_t seed, const fs::path& damaged) {
                      return damage_bytes(bytes, seed, damaged);
                    },
                    [copy, restart](const fs::path&) { restart(copy); }});
}

void ForeignFiles::add_pictures(const fs::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    add(folder.filename().string() + " " + name, folder / (name + ".h5"),
        [](const fs::path& file) { (void)analysis::pictures_of(file); });
}

void ForeignFiles::add_lsa() {
  add_pictures(run("lsa", "lsa",
                   "[flag]\nmu = 0.1\ngamma = 2\n[flow]\nRe = 1000\n"
                   "[lsa.curve]\nmu = { from = 0.01, to = 1, points = 6 }\n"
                   "[lsa.map]\nmu = { from = 0.01, to = 1, points = 6 }\n"
                   "k_x = { from = 0, to = 4, points = 5 }\n"),
               {"curve", "map"});
  add_pictures(
      run("lsa", "verdicts",
          fmt::format("[flag]\nmu = 0.1\n[flow]\nRe = 1000\n[lsa.verdicts]\nk_y = {{ from = "
                      "0.5, to = 6, points = 50 }}\ntable = "
                      "\"{}\"\n",
                      (source / "data/reference/table1.csv").string())),
      {"verdicts"});
}

void ForeignFiles::add_modes() {
  const fs::path folder = run("modes", "modes", modes_case);
  add_pictures(folder, {"modes", "global_modes"});
  modes::global::NeutralPicture picture;
  picture.local_theory.push_back({"wu", {1, 2, 3}, {0.1, 0.2, 0.3}});
  picture.outcomes.add(1, 0.2, true);
  modes::global::write_hdf5(*global_findings().neutral, picture, folder / "global_neutral.h5");
  add_pictures(folder, {"global_neutral"});
  add("start in a global mode", folder / "global_modes.h5", [](const fs::path& file) {
    const dns::Fluid fluid(dns::OGrid({.n_rho = 12,
                                       .n_theta = 24,
                                       .R = 3,
                                       .wall_spacing = 0.1,
                                       .wake_clustering = dns::FluidSettings().wake_clustering}),
                           dns::Span(1, 1.0), {100, 0}, {});
    FlagParameters flag;
    flag.mu = 0.3;
    flag.K_B = 1e-3;
    (void)dns::read_flow_mode(file, 1, fluid, flag);
  });
}

void ForeignFiles::add_flag() {
  const fs::path folder = run("dns", "flag", flag_case);
  add_pictures(folder, {"history", "shapes"});
  add_records("a flag", folder / "checkpoint.h5", [this, folder](const fs::path& file) {
    const app::Case the_case(folder / "case.resolved.toml", {}, {.dns = true});
    const dns::Beginning beginning =
        dns::beginning_at(file, resolved_text(the_case.schema), 0.105, false);
    dns::Settings settings = the_case.dns;
    settings.t_end = 0.105;
    (void)dns::run_flag(settings, the_case.flag, {}, beginning, OutputFolder(folder_ / "again"),
                        false);
  });
}

void ForeignFiles::add_flow() {
  const fs::path folder = run("dns", "flow", flow_case);
  add_pictures(folder, {"history", "shapes", "fields_00001"});
  add_records("flag and flow", folder / "checkpoint.h5", [this, folder](const fs::path& file) {
    const app::Case the_case(folder / "case.resolved.toml", {}, {.dns = true});
    const dns::Beginning beginning =
        dns::beginning_at(file, resolved_text(the_case.schema), 0.21, false);
    dns::Settings settings = the_case.dns;
    settings.t_end = 0.21;
    (void)dns::run_fluid(settings, the_case.flag, the_case.flow, {}, beginning,
                         OutputFolder(folder_ / "again"), false);
  });
}

// A run in which a wave grows, travels along the span and saturates, so that all of it is read.
void ForeignFiles::add_oblique_run() {
  const fs::path folder = folder_ / "oblique";
  fs::create_directory(folder);
  constexpr double span = 2, to = 24;
  const auto z = [](double x, double y, double t) {
    return 0.1 * y * std::min(1.0, 1e-3 * std::exp(t)) *
           std::cos(std::numbers::pi * x + 5 * y - 5.3 * t);
  };
  analysis::RunHistory history = synthetic_run(unequal_times(to, 0.05), span, 4,
                                               [&](double x, double t) { return z(x, 1, t); });
  for (const double y : {2.0, 3.0})
    add_probe(
        history, y, 0.25, [](double, double) { return 0.0; },
        [&, y](double x, double t) { return z(x, y, t); });
  write_history(history, folder / "history.h5");
  write_shapes(analysis::equal_times(0, to, 241), span, 4, 9, z, folder / "shapes.h5");
  for (const std::string_view name : {"history.h5", "shapes.h5"})
    add(fmt::format("analysis of {}", name), folder / name,
        [this, folder, name](const fs::path& file) {
          const fs::path run = folder_ / "run";
          fs::create_directories(run);
          for (const std::string_view each : {"history.h5", "shapes.h5"})
            fs::copy_file(each == name ? file : folder / each, run / each,
                          fs::copy_options::overwrite_existing);
          (void)analysis::analyze_run(run, analysis::Settings(), analysis::RunContext());
        });
}

// Snapshots of another code, and what they are decomposed into.
void ForeignFiles::add_snapshots() {
  const std::vector<double> t = analysis::equal_times(0, 3, 31);
  std::vector<double> q, z;
  for (const double time : t)
    for (int i = 0; i < 24; ++i) {
      q.push_back(std::cos(0.3 * i - 4 * time));
      z.push_back(0.1 * std::cos(0.5 * i + 5 * time));
    }
  const std::vector<double> ones(24, 1.0), y = analysis::equal_times(0, 1, 6);
  hdf5::Writer field(folder_ / "field.h5");
  field.write("/t", {31}, t);
  field.write("/q", {31, 2, 12}, q);
  field.write("/weight", {12}, std::span(ones).first(12));
  field.write("/coordinates", {12, 2}, ones);
  field.finish();
  hdf5::Writer flag(folder_ / "foreign_flag.h5");
  flag.write("/t", {31}, t);
  flag.write("/z", {31, 4, 6}, z);
  flag.write("/y", {6}, y);
  flag.write("/x", {4}, std::vector<double>{0, 0.5, 1, 1.5}, {{"span", 2.0}});
  flag.finish();
  using decomposition::Method;
  const auto decomposed = [this](const fs::path& file, Method method) {
    decomposition::Settings settings;
    settings.method = method;
    settings.block = 10;
    fs::create_directories(folder_ / "decomposed");
    (void)decomposition::decompose(
        decomposition::open_foreign_file(file, decomposition::Foreign::flag, {}), settings,
        OutputFolder(folder_ / "decomposed"));
  };
  for (const auto& [name, file] :
       {std::pair("field", "field.h5"), std::pair("shape", "foreign_flag.h5")})
    for (const Method method : {Method::pod, Method::dmd, Method::spod}) {
      add(fmt::format("{} decomposed by {}", name, static_cast<int>(method)), folder_ / file,
          [=](const fs::path& damaged) { decomposed(damaged, method); });
    }
  add("waves of a shape", folder_ / "foreign_flag.h5",
      [=](const fs::path& damaged) { decomposed(damaged, Method::waves); });
  for (const auto& [name, method] :
       {std::pair("pod", Method::pod), std::pair("dmd", Method::dmd),
        std::pair("spod", Method::spod), std::pair("waves", Method::waves)}) {
    decomposed(folder_ / "foreign_flag.h5", method);
    const fs::path kept = folder_ / fmt::format("{}.h5", name);
    fs::rename(folder_ / "decomposed/decomposition.h5", kept);
    add(fmt::format("picture of {}", name), kept,
        [](const fs::path& file) { (void)analysis::pictures_of(file); });
  }
}

Answers ForeignFiles::damage(std::int64_t count, std::uint64_t first) {
  // The longest that a file may take, in seconds; a longer one ends the process.
  constexpr unsigned patience = 60;
  Answers answers;
  const long before = peak_kilobytes();
  for (std::int64_t k = 0; k < count; ++k) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(k);
    const Kind& kind = kinds_[seed % kinds_.size()];
    const std::string what =
        fmt::format("seed {}, {}: {}", seed, kind.name, kind.damage(seed, kind.damaged));
    alarm(patience);
    try {
      kind.read(kind.damaged);
      ++answers.taken[kind.name];
    } catch (const InputError&) {
      ++answers.refused[kind.name];
    } catch (const SolverError&) {  // a state that is finite and nonsense
      ++answers.refused[kind.name];
    } catch (const std::exception& fault) {
      answers.faults.push_back(fmt::format("{}{}", what, fault.what()));
    }
    alarm(0);
  }
  answers.memory_kilobytes = peak_kilobytes() - before;
  return answers;
}

}  // namespace pennon::test
