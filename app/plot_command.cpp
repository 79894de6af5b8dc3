#include <fmt/format.h>

#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"

namespace pennon::app {

void run_plot(const std::vector<std::string>& files, bool quiet) {
  for (const std::string& file : files)
    for (const std::filesystem::path& picture : analysis::plot(file))
      if (!quiet) fmt::print("{}\n", picture.string());
}

}  // namespace pennon::app
