// # Numbers for the text
//
// A chapter quotes its numbers from a file that its program writes:
//
//     # headline contact_force 37 closed form
//     contact_force 37.000000000000007 N
//     seconds 0.012 s varies
//
// A line is a key, a value and a unit. Tests compare a fresh file with the committed one, and the
// text is woven from the committed one. What differs from run to run is marked, and never compared
// or quoted.

#include "signorini/report/results.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <system_error>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

/// What the system says about its last error, in brackets; nothing if it says nothing.
// The system often knows why a file cannot be written: no room, no permission.
std::string reason(int error) {
  return error == 0 ? "" : " (" + std::generic_category().message(error) + ")";
}

}  // namespace

Results::Results(std::string program) : program_(std::move(program)) {}

// The text refers to a number by its key. So a key is one word, and there is only one line of it.
void Results::add(const std::string& key, double value, const std::string& unit, Repeats repeats) {
  require_argument(!key.empty() && key.find_first_of(" \t\n") == std::string::npos,
                   "Results::add: a key must be one word, got '", key, "'");
  const bool known =
      std::any_of(lines_.begin(), lines_.end(), [&](const Line& l) { return l.key == key; });
  require_argument(!known, "Results::add: the key '", key, "' was added before");
  lines_.push_back({key, value, unit, repeats});
}

// A chapter stands for one number. The summary of all chapters prints it beside its reference.
void Results::headline(const std::string& key, double reference, const std::string& source) {
  std::ostringstream line;
  line << "# headline " << key << ' ' << std::setprecision(17) << reference << ' ' << source
       << '\n';
  headline_ = line.str();
}

// A program may want its own number again, to compare it.
// A key that was never added is a mistake of the program.
double Results::value(const std::string& key) const {
  const auto known =
      std::find_if(lines_.begin(), lines_.end(), [&](const Line& l) { return l.key == key; });
  require_argument(known != lines_.end(), "Results::value: no key '", key, "' was added");
  return known->value;
}

// A person gets 6 digits, the file 17, with which a double is read back as it was.
void Results::print() const {
  std::ostringstream out;
  for (const Line& line : lines_)
    out << std::left << std::setw(40) << line.key << ' ' << std::setprecision(6) << line.value
        << ' ' << line.unit << '\n';
  std::cout << out.str();
}

// The headline stands first, where the summary looks for it. Nothing is in the folder before the
// program knows all its numbers.
void Results::write(const std::filesystem::path& folder) const {
  std::ostringstream out;
  out << headline_ << std::setprecision(17);
  for (const Line& line : lines_)
    out << line.key << ' ' << line.value << ' ' << line.unit
        << (line.repeats == Repeats::No ? " varies" : "") << '\n';
  write_file(folder / (program_ + ".results"), out.str());
}

// A program that is stopped while it writes leaves half a file. So the content goes into a file
// beside it, which then gets the name of the old one, in one step that succeeds or fails as a
// whole.
//
// A full disk may be noticed as late as in close(), so the stream is asked after that.
void write_file(const std::filesystem::path& file, const std::string& content) {
  const std::filesystem::path draft = file.string() + ".part";
  errno = 0;
  std::ofstream out(draft, std::ios::binary);
  out << content;
  out.close();
  int error = errno;
  std::error_code failed;
  if (out) std::filesystem::rename(draft, file, failed);
  if (out && !failed) return;
  if (failed) error = failed.value();
  std::error_code ignored;
  std::filesystem::remove(draft, ignored);
  throw ProblemError(text("cannot write '", file.string(), "'", reason(error),
                          ": give a folder that exists, has room and may be written to"));
}

// The same for what is printed: the last part may not have left the program yet.
void finish_printing() {
  errno = 0;
  std::cout.flush();
  require_input(std::cout.good(), "cannot write all that is to be printed", reason(errno),
                ": send the output to a terminal, or to a file on a disk that has room");
}

// The only sure answer to whether a folder can be written to is to write. A program learns it
// before it computes, not after.
void prepare_output_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  require_input(!failed && std::filesystem::is_directory(folder), "cannot make the output folder '",
                folder.string(), "' (", failed ? failed.message() : "it is a file",
                "): give another one with --out FOLDER");
  const std::filesystem::path probe = folder / ".writable";
  write_file(probe, "");
  std::filesystem::remove(probe, failed);
}

}  // namespace signorini
