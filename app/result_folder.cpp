#include "app/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <functional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "common/case/case_difference.hpp"
#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"
#include "common/parallel/ranks.hpp"
#include "dns/run/restart.hpp"

namespace pennon::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* case_name = "case.resolved.toml";
constexpr const char* summary_name = "summary.json";
constexpr const char* record_name = "record.json";
constexpr const char* checkpoint_name = "checkpoint.h5";

constexpr std::array<std::string_view, 8> endings = {".h5",  ".csv", ".xdmf", ".png",
                                                     ".pdf", ".svg", ".json", ".rows"};

// Whether a file's name is one that the command gives: the beginning by itself, or followed by an
// underscore.
bool is_of_command(const fs::path& file, const std::vector<std::string>& beginnings) {
  const std::string stem = file.stem().string();
  return std::ranges::find(endings, file.extension().string()) != endings.end() &&
         std::ranges::any_of(beginnings, [&](const std::string& beginning) {
           return stem == beginning || stem.starts_with(beginning + "_");
         });
}

std::vector<fs::path> files_of_command(const fs::path& folder, const ResultRequest& request) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.symlink_status().type() == fs::file_type::regular &&
        is_of_command(entry.path(), request.files))
      files.push_back(entry.path());
  return files;
}

constexpr std::string_view heading = "# pennon ";

// The command that wrote a resolved case: "# pennon lsa: ...".
std::string command_in(const std::string& resolved) {
  if (!resolved.starts_with(heading)) return {};
  const std::size_t colon = resolved.find(':');
  return colon == std::string::npos ? std::string()
                                    : resolved.substr(heading.size(), colon - heading.size());
}

constexpr const char* advice = "choose another folder with --output, or replace them with --force";

// Throws where what is there must not be replaced.
void check_earlier_results(const fs::path& folder, const ResultRequest& request) {
  const std::string earlier = text_of_file(folder / case_name);
  const auto refuse = [&](const std::string& what) {
    throw InputError(folder.string(), fmt::format("{}; {}", what, advice));
  };
  const auto files = files_of_command(folder, request);
  if (earlier.empty()) {
    if (!files.empty())
      refuse(fmt::format("holds {} without the case that it is of",
                         files.front().filename().string()));
    return;
  }
  // A run that failed before it had results keeps nobody from trying another case.
  const std::string command_there = command_in(earlier);
  if (command_there == request.command && files.empty() && !fs::exists(folder / summary_name))
    return;
  if (command_there != request.command)
    refuse(command_there.empty() ? "holds results of another version of pennon"
                                 : fmt::format("holds results of pennon {}", command_there));
  std::error_code ignored;
  const bool goes_on_here =
      request.checkpoint &&
      fs::equivalent(request.checkpoint->parent_path().empty() ? fs::path(".")
                                                               : request.checkpoint->parent_path(),
                     folder, ignored);
  if (goes_on_here) return;
  const auto differences = case_differences(
      earlier, (folder / case_name).string(), request.the_case, [&](const std::string& key) {
        return !request.follows_run || !dns::is_of_simulation(key) ||
               dns::at_restart(key) != dns::AtRestart::free;
      });
  if (!differences.empty()) refuse("holds results of another case: " + text_of(differences));
  if (fs::exists(folder / checkpoint_name) && !fs::exists(folder / summary_name))
    throw InputError(
        folder.string(),
        fmt::format("holds a run that did not come to its end; go on with --restart {}, or start "
                    "anew with --force",
                    (folder / checkpoint_name).string()));
}

// The folder and those above it that are not there, the outermost first.
std::vector<fs::path> missing_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  for (fs::path each = fs::absolute(folder).lexically_normal(); !fs::exists(each);
       each = each.parent_path())
    missing.insert(missing.begin(), each);
  return missing;
}

// Calls on the leading rank alone; where it throws there, all ranks throw.
void on_leading_rank(const std::function<void()>& work) {
  std::exception_ptr fault;
  if (ranks::is_leading()) {
    try {
      work();
    } catch (...) {
      fault = std::current_exception();
    }
  }
  if (!ranks::any(fault != nullptr)) return;
  if (fault) std::rethrow_exception(fault);
  throw InputError("mpiexec", "the leading rank met a fault of the output folder");
}

}  // namespace

std::string text_of_file(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status)) return {};
  if (!fs::is_regular_file(status)) throw InputError(file.string(), "is not a regular file");
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

ResultFolder::ResultFolder(const fs::path& folder, const ResultRequest& request)
    : request_(request) {
  on_leading_rank([&] {
    std::error_code ignored;
    const bool is_there = fs::is_directory(folder, ignored);
    if (is_there && !request.is_forced) check_earlier_results(folder, request);
    made_ = missing_folders(folder);
    output_.emplace(folder);
    lock_.emplace(folder, request.is_forced);
    remove_stale_temporaries(folder);
    if (request.is_forced && !request.checkpoint)
      for (const fs::path& file : files_of_command(folder, request)) fs::remove(file, ignored);
    for (const char* name : {summary_name, record_name}) fs::remove(folder / name, ignored);
    write_file(folder / case_name, fmt::format("{}{}: {}\n{}", heading, request.command,
                                               request.title, request.the_case));
  });
  if (!output_) output_.emplace(folder);
}

void ResultFolder::withdraw() {
  if (!ranks::is_leading()) return;
  std::error_code ignored;
  const fs::path& folder = output_->path();
  if (files_of_command(folder, request_).empty()) fs::remove(folder / case_name, ignored);
  lock_.reset();
  // Those that are not empty stay.
  for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);
}

void ResultFolder::remove_older_files() const {
  if (!ranks::is_leading() || request_.checkpoint) return;
  std::error_code ignored;
  const fs::path& folder = output_->path();
  const fs::file_time_type begin = fs::last_write_time(folder / case_name, ignored);
  for (const fs::path& file : files_of_command(folder, request_))
    if (fs::last_write_time(file, ignored) < begin) fs::remove(file, ignored);
}

}  // namespace pennon::app
