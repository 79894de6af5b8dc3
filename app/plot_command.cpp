#include <fmt/format.h>

#include <algorithm>

#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"
#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::app {
namespace {

namespace fs = std::filesystem;

void add_files_of(const fs::path& folder, std::vector<fs::path>& files) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".h5" &&
        !entry.path().filename().string().starts_with(".") &&
        !analysis::has_no_picture(entry.path()))
      files.push_back(entry.path());
}

// Of a case's folder or a command's.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  add_files_of(folder, files);
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) add_files_of(entry.path(), files);
  std::ranges::sort(files);
  if (files.empty())
    throw InputError(folder.string(), "holds no HDF5 files, nor do the folders in it");
  return files;
}

}  // namespace

void run_plot(const std::vector<std::string>& names, bool quiet) {
  if (!ranks::is_leading()) return;
  for (const std::string& name : names) {
    const std::vector<fs::path> files =
        fs::is_directory(name) ? files_in(name) : std::vector<fs::path>{name};
    for (const fs::path& file : files)
      for (const fs::path& picture : analysis::plot(file))
        if (!quiet) print(picture.string() + "\n");
  }
}

}  // namespace pennon::app
