/// What a coupled run of `pennon dns` left in its folder, read by the names of columns and arrays.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pennon::analysis {

/// Velocities at a point of the wake: [station][row].
struct ProbeHistory {
  double y = 0, z = 0;
  std::vector<std::vector<double>> v, w;
};

struct RunHistory {
  double span = 1;        ///< gamma; 1 in two dimensions
  std::vector<double> t;  ///< increasing, not necessarily equally spaced
  std::map<std::string, std::vector<double>> columns;  ///< each with a value for each of t
  std::vector<std::vector<double>> z;                  ///< of the trailing edge, [station][row]
  std::vector<ProbeHistory> probes;                    ///< those inside the grid all the time

  std::size_t planes() const { return z.size(); }
  bool has_span() const { return planes() > 1; }
  const std::vector<double>& column(const std::string& name) const { return columns.at(name); }
};

/// A history with fewer rows than this cannot be analysed.
inline constexpr std::size_t fewest_rows = 16;

/// Throws InputError where there is no such folder, or no history in it.
void require_run_folder(const std::filesystem::path& folder);

/// Reads `folder`/history.h5. Throws InputError as require_run_folder(), and where the file is not
/// the history of a coupled run, lacks a column or array, is too short, has a time that does not
/// increase or a value that is not a number.
RunHistory read_run_history(const std::filesystem::path& folder);

}  // namespace pennon::analysis
