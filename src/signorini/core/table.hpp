/// \file
/// Small tables that a program writes for its text and its figures.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// A number as text.
/// \param value   the number
/// \param format  printf format with one conversion of a double, such as `%.3f`
/// \return at most 63 characters
/// \throws std::invalid_argument if the text would be longer
[[nodiscard]] std::string number(double value, const char* format = "%.10g");

/// A number in as few digits as give it back exactly.
/// \param value  the number
/// \return such as `0.1`, `1e-12` or `inf`
[[nodiscard]] std::string shortest(double value);

/// Rows of cells under named columns.
class Table {
 public:
  /// An empty table. \param columns  their names, in order
  explicit Table(std::vector<std::string> columns);

  /// Adds a row. \param cells  one per column
  /// \throws std::invalid_argument if there are more or fewer
  void row(std::vector<std::string> cells);
  /// Adds a row of numbers with 10 digits. \param values  one per column
  /// \throws std::invalid_argument if there are more or fewer
  void row(const std::vector<double>& values);
  /// Adds an empty line, which separates the blocks of a figure's data.
  void blank_line();

  /// The table for a chapter text, all columns flush right.
  /// \return Markdown
  [[nodiscard]] std::string markdown() const;
  /// The table for gnuplot.
  /// \param tolerance  what a fresh run may differ by, such as `rel 1e-6 abs 1e-9`
  /// \return comma separated lines under a comment with the tolerance and a line of column names
  [[nodiscard]] std::string csv(const std::string& tolerance = "rel 1e-6 abs 1e-9") const;

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// One column of numbers.
struct Column {
  std::string name;              ///< over it
  Eigen::VectorXd values;        ///< one per row
  const char* format = "%.10g";  ///< as for number()
};

/// A table from its columns.
/// \param columns  of equal length, at least one
/// \return one row per number
/// \throws std::invalid_argument if their lengths differ or there is none
[[nodiscard]] Table table_of(const std::vector<Column>& columns);

}  // namespace signorini
