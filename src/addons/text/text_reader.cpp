// # Reading a file that nobody has checked
//
// A mesh or a scene comes from elsewhere. The reader believes nothing: it never asks for memory
// because a file announces a size, and each complaint names the line, what was expected and what
// was found, such as
//
//     plate.problem:7: d, number 3: expected a finite number, got 'abc'
//
// The text is kept as a whole. Words are views into it, so nothing is copied. What reads a format
// is then a list of what the format says:
//
//     reader.expect_line("d");
//     reader.expect_row("d", free_gap);
//     const std::int64_t n = reader.whole(reader.word_anywhere(), "n", 1, reader.largest_size);
//
// Lines and words can be asked for (next_line(), word()) or demanded (the functions that begin with
// `expect_`); what is demanded and not there ends the reading with a ProblemError.

#include "addons/text/text_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {
namespace {

// All of `digits` as a number. \param digits  any text \param[out] result  the number \return why there is none
// Only decimal numbers count. `strtod` alone would also read `0x1p3`, `inf` and numbers with blanks
// before them.
std::errc read_number(std::string_view digits, double& result) {
#ifdef __cpp_lib_to_chars
  const char* const end = digits.data() + digits.size();
  const auto [last, error] = std::from_chars(digits.data(), end, result);
  return last == end && !digits.empty() ? error : std::errc::invalid_argument;
#else  // a library that reads only whole numbers so, as emscripten's
  if (digits.empty() || digits.find_first_not_of("0123456789+-.eE") != std::string_view::npos ||
      digits[0] == '+')
    return std::errc::invalid_argument;
  const std::string text(digits);
  char* last = nullptr;
  result = std::strtod(text.c_str(), &last);
  if (last != text.c_str() + text.size()) return std::errc::invalid_argument;
  return std::isfinite(result) ? std::errc() : std::errc::result_out_of_range;
#endif
}

using Eigen::Index;

constexpr std::string_view blanks = " \t\r\v\f";

// Number of the words of a line. \param line  without its comment
// The message about a row with too few or too many numbers says how many there are.
std::size_t words_in(std::string_view line) {
  std::size_t count = 0;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos; ++count)
    at = line.find_first_not_of(blanks, std::min(line.size(), line.find_first_of(blanks, at)));
  return count;
}

}  // namespace

// Some editors put three invisible bytes before a text, the mark of UTF-8. They are no part of its
// first word.
TextReader::TextReader(std::string_view content, std::string name, std::string_view comment)
    : text_(content), name_(std::move(name)), comment_(comment) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.substr(0, byte_order_mark.size()) == byte_order_mark)
    text_.remove_prefix(byte_order_mark.size());
}

// The text becomes shorter from its front: `present_` is the line at hand, `text_` what stands
// below it. Lines that hold only blanks or a comment are passed over and counted, so that messages
// have the number an editor shows.
bool TextReader::next_line() {
  while (!text_.empty()) {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    present_ = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++line_;
    present_ = present_.substr(0, present_.find_first_of(comment_));
    if (present_.find_first_not_of(blanks) != std::string_view::npos) return true;
  }
  present_ = {};
  return false;
}

// A carriage return counts as a blank, so that files of Windows read like others. At the end of a
// line the word is empty: no word of a file can be that.
std::string_view TextReader::word() {
  present_.remove_prefix(std::min(present_.find_first_not_of(blanks), present_.size()));
  const std::string_view result = present_.substr(0, present_.find_first_of(blanks));
  present_.remove_prefix(result.size());
  return result;
}

// Some formats end lines where they like; others mean something by the end of a line. Each has its
// own question.
std::string_view TextReader::word_anywhere() {
  const std::string_view here = word();
  return here.empty() && next_line() ? word() : here;
}

// Names may have blanks in them; they are what is left of a line.
std::string_view TextReader::rest_of_line() {
  present_.remove_prefix(std::min(present_.find_first_not_of(blanks), present_.size()));
  const std::string_view result = present_.substr(0, present_.find_last_not_of(blanks) + 1);
  present_ = {};
  return result;
}

// The next functions say what has to stand here. They are short because every complaint is worded
// in one place, fail().
void TextReader::expect_line(const std::string& keyword) {
  const std::string wanted = "a line with the single word '" + keyword + "'";
  next_line();
  const std::string_view first = word();
  if (first != keyword) fail(wanted, first);
  const std::string_view more = word();
  if (!more.empty()) fail(wanted, more);
}

// A word too many is refused as well. It may be a number that the user believes to be read.
void TextReader::expect_end_of_line(const std::string& after) {
  const std::string_view more = word();
  if (!more.empty()) fail("the end of the line after " + after, more);
}

// A row of a matrix is one line. If a number is missing, its place is unknown, and all that can be
// said is how many there are.
// A row of no numbers has no line.
void TextReader::expect_row(const std::string& what, Eigen::Ref<Eigen::RowVectorXd> row) {
  if (row.size() == 0) return;
  next_line();
  const std::size_t count = words_in(present_);
  for (Index j = 0; j < row.size(); ++j) {
    const std::string_view entry = word();
    if (entry.empty())
      fail(text(what, ": expected ", row.size(), " numbers on one line, got ", count));
    row(j) = number(entry, text(what, ", number ", j + 1));
  }
  if (!word().empty())
    fail(text(what, ": expected ", row.size(), " numbers on one line, got ", count, " words"));
}

// `from_chars` reads as much as it can. A word such as `12abc` leaves something over, and is
// refused.
std::int64_t TextReader::whole(std::string_view word, const std::string& what, std::int64_t least,
                               std::int64_t most) const {
  std::int64_t result = 0;
  const char* const end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, result);
  if (word.empty() || last != end || error != std::errc() || result < least || result > most)
    fail(text(what, ": expected a whole number from ", least, " to ", most), word);
  return result;
}

// `from_chars` refuses a plus sign, which people write. `+5` is read, `+-5` is not.
// A number that is too large, such as `1e999`, has a message of its own: it is a number, but no
// double.
double TextReader::number(std::string_view word, const std::string& what) const {
  double result = 0;
  std::string_view digits = word;
  if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-') digits.remove_prefix(1);
  const std::errc error = read_number(digits, result);
  if (error == std::errc::result_out_of_range)
    fail(what + ": expected a number that a double can hold", word);
  if (error != std::errc() || !std::isfinite(result))
    fail(what + ": expected a finite number", word);
  return result;
}

// A file of 20 bytes may announce a matrix of \f$ 10^6 \times 10^6 \f$. A number takes at least one
// digit, and a blank parts it from the next: m numbers need \f$ 2m - 1 \f$ characters. What cannot
// fit is refused before memory is asked for.
void TextReader::check_room(Index rows, Index columns, const std::string& what) const {
  const Index count = rows * columns;  // both are at most 10^6
  const auto left = static_cast<Index>(present_.size() + text_.size());
  if (count > 0 && 2 * count - 1 > left)  // a digit for each, and a blank between them
    fail(text(what, ": expected ", rows, " x ", columns, " numbers, but only ", left,
              " characters are left in the file"));
}

// Some callers say "x: expected ...", others only what they expect. Nothing found means the end of
// the line, or of the file.
void TextReader::fail(const std::string& expected, std::string_view got) const {
  const bool ended =
      got.empty() && text_.find_first_not_of(" \t\r\v\f\n") == std::string_view::npos;
  const bool tells = expected.find("expected ") != std::string::npos;
  fail((tells ? "" : "expected ") + expected + ", got " +
       (!got.empty() ? in_quotes(got)
        : ended      ? "the end of the file"
                     : "the end of the line"));
}

// Before the first line is read the number is 0. A message then says line 1.
void TextReader::fail(const std::string& why) const {
  throw ProblemError(text(name_, ":", std::max<std::size_t>(line_, 1), ": ", why));
}

// A folder can be opened as a file, and a device may never end. So we ask what it is and how long,
// before we read.
std::string file_content(const std::filesystem::path& file, std::size_t most) {
  std::error_code failed;
  const std::filesystem::file_status status = std::filesystem::status(file, failed);
  require_input(std::filesystem::exists(status), file.string(), ": there is no such file");
  require_input(!std::filesystem::is_directory(status), file.string(),
                ": this is a folder; name a file in it");
  require_input(std::filesystem::is_regular_file(status), file.string(),
                ": this is not a plain file");
  const std::uintmax_t bytes = std::filesystem::file_size(file, failed);
  require_input(!failed && bytes <= most, file.string(), ": expected at most ", most,
                " bytes, got ", failed ? failed.message() : std::to_string(bytes));
  std::ifstream in(file, std::ios::binary);
  std::string content(static_cast<std::size_t>(bytes), '\0');
  in.read(content.data(), static_cast<std::streamsize>(bytes));
  require_input(static_cast<bool>(in), file.string(), ": cannot be read; look at its permissions");
  return content;
}

}  // namespace signorini
