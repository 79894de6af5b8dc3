#include "app/run.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "app/case_notes.hpp"
#include "app/pictures.hpp"
#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"
#include "common/parallel/ranks.hpp"
#include "common/record/version.hpp"
#include "common/utf8.hpp"

namespace pennon::app {

void print(const std::string& text) {
  errno = 0;
  const std::string shown = printable(text);
  if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size() ||
      std::fflush(stdout) != 0)
    throw FileError("the answer cannot be written to standard output: " +
                    std::generic_category().message(errno));
}

void finish(const ResultFolder& folder, const Record& record, const Answer& answer, bool as_json,
            bool quietly) {
  folder.remove_older_files();
  const std::filesystem::path& path = folder.output().path();
  record.write(path / "record.json", ranks::count());
  write_file(path / "summary.json", answer.json.dump(2) + "\n");
  if (as_json)
    print(answer.json.dump() + "\n");
  else if (!quietly)
    print(fmt::format("{}  results in {}\n", answer.text, path.string()));
}

void expect_one_rank(const std::string& command) {
  if (ranks::count() > 1)
    throw InputError("mpiexec",
                     fmt::format("started {} ranks, but {} runs on one", ranks::count(), command));
}

namespace {

void run(const Command& command, const Case& the_case, const Options& options, Record& record) {
  if (command.expect) command.expect(the_case);
  const std::string resolved = resolved_text(the_case.schema);
  const std::string title = fmt::format(
      "{} as version {} understood it: every key, defaults included.", the_case.name, version());
  const std::vector<std::string> notes = notes_on(the_case, command.name);
  if (options.check) {
    std::string text = fmt::format("# {}\n", title);
    for (const std::string& note : notes) text += fmt::format("# Note: {}.\n", note);
    if (ranks::is_leading()) print(text + resolved);
    return;
  }
  if (the_case.name.empty() || the_case.name.starts_with('.'))
    throw InputError(options.case_file,
                     "the name of a case, before its ending, begins with a letter or a number: it "
                     "names the folder of the results");
  if (ranks::is_leading()) warn_without_gnuplot();
  const ResultFolder folder(options.output.empty()
                                ? std::filesystem::path("results") / the_case.name / command.name
                                : std::filesystem::path(options.output),
                            {.command = command.name,
                             .the_case = resolved,
                             .title = title,
                             .files = command.files,
                             .checkpoint = command.checkpoint ? command.checkpoint() : std::nullopt,
                             .is_forced = options.force});
  Answer answer = command.work(the_case, folder.output(), record);
  if (!ranks::is_leading()) return;
  for (const std::string& note : notes) answer.text += fmt::format("  note: {}\n", note);
  if (!notes.empty()) answer.json["notes"] = notes;
  finish(folder, record, answer, options.json, options.quiet);
}

}  // namespace

void run(const Command& command, const Options& options) {
  Record record(options.command_line);
  const Case the_case(options.case_file, options.overrides, command.asked);
  try {
    run(command, the_case, options, record);
  } catch (const InputError& fault) {
    throw the_case.located(fault);
  }
}

}  // namespace pennon::app
