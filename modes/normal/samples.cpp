#include "modes/normal/samples.hpp"

#include <fmt/format.h>

#include "common/errors.hpp"
#include "common/io/csv.hpp"

namespace pennon::modes {

std::vector<Sample> read_samples(const std::filesystem::path& file, bool has_span) {
  const CsvTable table(file);
  table.expect_only(has_span ? std::vector<std::string>{"x", "y", "zeta"}
                             : std::vector<std::string>{"y", "zeta"});
  std::vector<InputFault> faults;
  const auto cell = [&](std::size_t row, const std::string& name) {
    const std::optional<double> number = table.number(row, table.column(name));
    if (!number) faults.push_back({table.place(row), name + " is missing"});
    return number.value_or(0);
  };
  std::vector<Sample> samples;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Sample sample{has_span ? cell(row, "x") : 0, cell(row, "y"), cell(row, "zeta")};
    if (sample.y < 0 || sample.y > 1)
      faults.push_back({table.place(row), fmt::format("y must be 0 to 1, but is {}", sample.y)});
    samples.push_back(sample);
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  table.expect_each_once(
      has_span ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"y"}, "the place");
  return samples;
}

}  // namespace pennon::modes
