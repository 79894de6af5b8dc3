#include "app/run.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "common/io/atomic_file.hpp"
#include "common/parallel/ranks.hpp"
#include "common/record/version.hpp"

namespace pennon::app {
namespace {

using Json = nlohmann::ordered_json;

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The summary of the folder: what this command found, beside what others found for the same case.
Json merged_summary(const OutputFolder& folder, bool is_same_case, const Json& found) {
  Json summary = Json::object();
  if (is_same_case) {
    summary = Json::parse(contents(folder / "summary.json"), nullptr, false);
    if (!summary.is_object()) summary = Json::object();
  }
  summary.update(found);
  return summary;
}

}  // namespace

void run(const Command& command, const Options& options) {
  Record record(options.command_line);
  const Case the_case(options.case_file, options.overrides, command.asked);
  if (command.expect) command.expect(the_case);
  const std::string resolved =
      fmt::format("# {} as pennon {} understood it: every key, defaults included.\n{}",
                  the_case.name, version(), resolved_text(the_case.schema));
  if (options.check) {
    if (ranks::is_leading()) fmt::print("{}", resolved);
    return;
  }
  const OutputFolder folder(options.output.empty() ? "results/" + the_case.name : options.output);
  const bool is_same_case = contents(folder / "case.resolved.toml") == resolved;
  if (ranks::is_leading()) write_file(folder / "case.resolved.toml", resolved);

  const Answer answer = command.work(the_case, folder, record);
  if (!ranks::is_leading()) return;
  const Json summary = merged_summary(folder, is_same_case, answer.json);
  write_file(folder / "summary.json", summary.dump(2) + "\n");
  record.write(folder / "record.json", ranks::count());
  if (options.json)
    fmt::print("{}\n", answer.json.dump());
  else if (!options.quiet)
    fmt::print("{}  results in {}\n", answer.text, folder.path().string());
}

}  // namespace pennon::app
