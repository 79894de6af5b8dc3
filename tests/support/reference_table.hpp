/// Tables of results that are kept under data/reference/pennon, and computed anew to be compared.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/io/csv.hpp"
#include "tests/support/source_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {

/// Numbers by row and column. With PENNON_WRITE_REFERENCE in the environment it becomes the file;
/// otherwise every number must agree with the file's to `tolerance`, relative to the larger of it
/// and 1e-3, and what is no number must be none there.
inline void expect_reference(const std::string& file_name, const std::string& comment,
                             const std::vector<std::string>& columns,
                             const std::vector<std::vector<double>>& rows, double tolerance) {
  const std::string file = (test::source_folder() / "data/reference/pennon" / file_name).string();
  if (std::getenv("PENNON_WRITE_REFERENCE")) {
    CsvText text(comment, columns);
    for (const std::vector<double>& row : rows) text.row(row);
    write_text(file, text.text());
    return;
  }
  const CsvTable table(file);
  ASSERT_EQ(table.rows(), rows.size()) << file;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double kept = table.number(r, table.column(columns[c])).value_or(NAN);
      if (std::isnan(kept) && std::isnan(rows[r][c])) continue;
      EXPECT_NEAR(rows[r][c], kept, tolerance * std::max(std::abs(kept), 1e-3))
          << table.place(r) << ' ' << columns[c];
    }
}

}  // namespace pennon::test
