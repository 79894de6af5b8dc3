/// Tables of numbers and words as CSV: what a spreadsheet, pandas or a published table holds.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pennon {

/// A table read from a file: cells as text, each row with the line it stands on.
class CsvTable {
 public:
  /// Reads comma-separated cells, those in double quotes with what stands between them ("" is one
  /// quote); lines that begin with # and empty lines are skipped, the first other line names the
  /// columns, each once. The mark with which some programs begin UTF-8 is passed over. Throws
  /// InputError where the file cannot be read, has no header, or has a row with another number of
  /// cells, or a quote that is not closed on its line (file:line).
  explicit CsvTable(const std::filesystem::path& file);

  /// Throws InputError that lists them if the table has other columns than these.
  void expect_only(const std::vector<std::string>& columns) const;
  /// Throws InputError (file:line) where a row has the same numbers in these columns as an earlier
  /// one; `meaning`: of the columns, "the place".
  void expect_each_once(const std::vector<std::string>& columns, const std::string& meaning) const;

  std::size_t rows() const { return rows_.size(); }
  /// Of the columns, in their order.
  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& name) const;
  /// Throws InputError that lists the columns there are if this one is not among them.
  std::size_t column(const std::string& name) const;
  const std::string& text(std::size_t row, std::size_t column) const {
    return rows_[row].cells[column];
  }
  /// None for an empty cell. Throws InputError (file:line) where the cell is not a finite number.
  std::optional<double> number(std::size_t row, std::size_t column) const;
  /// A whole column, NaN for an empty cell. Throws as column() and number().
  std::vector<double> numbers(const std::string& name) const;
  /// "file:line" of a row.
  std::string place(std::size_t row) const;

 private:
  struct Row {
    std::size_t line;
    std::vector<std::string> cells;
  };
  std::string file_;
  std::vector<std::string> names_;
  std::vector<Row> rows_;
};

/// A table to be written: one comment line, the column names, then rows of numbers with the fewest
/// digits that read back to the same double. NaN is written as an empty cell.
class CsvText {
 public:
  CsvText(const std::string& comment, const std::vector<std::string>& columns);
  void row(const std::vector<double>& numbers, const std::vector<std::string>& words_first = {});
  const std::string& text() const { return text_; }

 private:
  std::size_t columns_;
  std::string text_;
};

}  // namespace pennon
