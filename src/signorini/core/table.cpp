// # Numbers as text
//
// A program writes its numbers twice: as Markdown for the text of its chapter and as comma
// separated values for its figures. Both come from one table. A fresh run is compared with the
// committed numbers, so the first line of the second kind says how far two runs may differ.

#include "signorini/core/table.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {

// Ten digits are enough for a figure, and few enough that rounding in the last bits is not seen.
std::string number(double value, const char* format) {
  std::array<char, 64> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), format, value);
  require_argument(length >= 0 && length < static_cast<int>(buffer.size()),
                   "number: cannot print with the format '", format, "'");
  return buffer.data();
}

// A number that is read again has to be the same number: so as few digits as identify it, which are
// never more than 17. 0.1 is written as `0.1`, but 0.1 + 0.2 as `0.30000000000000004`, because it
// is another double than 0.3.
std::string shortest(double value) {
  std::array<char, 32> buffer{};  // "-2.2250738585072014e-308" is the longest
#ifdef __cpp_lib_to_chars
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
#else  // a library that converts only whole numbers, as emscripten's
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
    if (std::strtod(buffer.data(), nullptr) == value) break;
  }
  return buffer.data();
#endif
}

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}

// A table is filled row by row or, with table_of() below, column by column.
//
// A row that is too short would shift every cell behind it. So it is refused where it is written.
void Table::row(std::vector<std::string> cells) {
  require_argument(cells.size() == columns_.size(), "Table::row: need ", columns_.size(),
                   " cells (", joined(columns_, ", "), "), got ", cells.size());
  rows_.push_back(std::move(cells));
}

// Numbers become text here and not when the table is written, because a cell may also hold a word.
void Table::row(const std::vector<double>& values) {
  std::vector<std::string> cells;
  cells.reserve(values.size());
  for (const double value : values) cells.push_back(number(value));
  row(std::move(cells));
}

// gnuplot lifts its pen at an empty line.
void Table::blank_line() { rows_.emplace_back(); }

// For the text. The colons set all columns flush right, so that numbers stand below each other:
//
//     | x | gap |
//     |---:|---:|
//     | 0 | 0.3 |
std::string Table::markdown() const {
  std::string text = "| " + joined(columns_, " | ") + " |\n|";
  for (std::size_t k = 0; k < columns_.size(); ++k) text += "---:|";
  text += '\n';
  for (const std::vector<std::string>& cells : rows_) text += "| " + joined(cells, " | ") + " |\n";
  return text;
}

// For gnuplot, which takes a line with `#` for a comment and the next one for the names of columns:
//
//     # tolerance rel 1e-6 abs 1e-9
//     x,gap
//     0,0.3
std::string Table::csv(const std::string& tolerance) const {
  std::string text = "# tolerance " + tolerance + '\n' + joined(columns_, ",") + '\n';
  for (const std::vector<std::string>& cells : rows_) text += joined(cells, ",") + '\n';
  return text;
}

// Results are vectors more often than rows. Each column has its own format.
Table table_of(const std::vector<Column>& columns) {
  require_argument(!columns.empty(), "table_of: need at least one column");
  std::vector<std::string> names;
  for (const Column& column : columns) {
    require_argument(column.values.size() == columns.front().values.size(), "table_of: column '",
                     column.name, "' has ", column.values.size(), " rows, '", columns.front().name,
                     "' has ", columns.front().values.size());
    names.push_back(column.name);
  }
  Table table(std::move(names));
  for (Eigen::Index row = 0; row < columns.front().values.size(); ++row) {
    std::vector<std::string> cells;
    for (const Column& column : columns) cells.push_back(number(column.values(row), column.format));
    table.row(std::move(cells));
  }
  return table;
}

}  // namespace signorini
