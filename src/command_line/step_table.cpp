#include "command_line/step_table.hpp"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "addons/text/text_reader.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/results.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;
namespace fs = std::filesystem;

/// What a table of steps has until some time.
struct TableUntil {
  std::string lines;  // a last one that is not whole is left out
  std::string head;   // names of the columns
  Index steps = 0;
  Index rows = 0;
  double time = 0;  // of the last step
};

TableUntil table_until(double time, const std::string& table) {
  constexpr std::string_view comment = "# time ";
  TableUntil found;
  for (std::size_t at = 0, end = 0; (end = table.find('\n', at)) != std::string::npos;
       at = end + 1) {
    const std::string_view line(table.data() + at, end - at);
    const bool told = line.substr(0, comment.size()) == comment;
    double now = 0;
    const auto read =
        std::from_chars(line.data() + (told ? comment.size() : 0), line.data() + line.size(), now);
    if (read.ec == std::errc()) {
      if (now > time) break;
      if (found.steps == 0 || now != found.time) ++found.steps;
      found.time = now;
      if (!told) ++found.rows;
    } else if (found.head.empty() && line.substr(0, 1) != "#") {
      found.head = line;
    }
    found.lines.append(line).append(1, '\n');
  }
  return found;
}

void append(const std::string& file, const std::string& lines) {
  std::ofstream out(file, std::ios::binary | std::ios::app);
  out << lines;
  out.close();
  require_input(static_cast<bool>(out), "cannot write '", file,
                "': give a folder that has room and may be written to");
}

}  // namespace

std::string content_if_any(const std::string& file) {
  std::error_code unseen;
  return fs::is_regular_file(file, unseen)
             ? file_content(file, std::numeric_limits<std::size_t>::max())
             : "";
}

void check_begun(bool right, const std::string& file, const PathState& from) {
  require_input(right, file, ": this file has not the ", from.steps, " steps until time ",
                shortest(from.time),
                " after which --from goes on; give the one that they were written to, "
                "or a name that is new");
}

bool StepTable::keep(const PathState& from, std::optional<Index> rows) {
  const std::string content = content_if_any(file_);
  if (content.empty()) return false;
  TableUntil kept = table_until(from.time, content);
  check_begun(kept.steps == from.steps && (!rows || kept.rows == *rows) && kept.time == from.time,
              file_, from);
  from_ = from;
  head_ = std::move(kept.head);
  lines_ = std::move(kept.lines);
  return true;
}

void StepTable::add(double time, const std::string& table) {
  if (!wanted()) return;
  const std::string at = shortest(time);
  bool named = false;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind('#', 0) == 0) {
      lines_ += text("# time ", at, ": ", line.substr(2), '\n');
    } else if (named) {
      lines_ += text(at, ',', line, '\n');
    } else {
      named = true;
      line = "time," + line;
      if (head_.empty()) lines_ += line + '\n';
      check_begun(head_.empty() || head_ == line, file_, from_);
      head_ = line;
    }
  }
  if (begun_) append(file_, std::exchange(lines_, ""));
}

void StepTable::begin(Drafts& drafts) {
  if (!wanted() || std::exchange(begun_, true)) return;
  write_file(drafts.begin(file_), std::exchange(lines_, ""));
}

}  // namespace command_line
