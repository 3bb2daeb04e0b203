/// \file
/// The numbers a program reports: key, value and unit, for the text and for other programs.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace signorini {

/// Whether a value is the same in every run of the same program.
enum class Repeats {
  Yes,  ///< compared with the committed value and quoted in the text
  No,   ///< a time or a number of the size of rounding: written, never compared or quoted
};

/// Collects `key value unit` lines and writes them as one file.
///
/// Nothing is written before write(), so that a program that fails leaves no half-made file.
class Results {
 public:
  /// \param program  short name such as `ch06`; the file is called `<program>.results`
  explicit Results(std::string program);

  /// Adds one line.
  /// \param key      what the text refers to; one word
  /// \param value    the number
  /// \param unit     one word, `-` if none
  /// \param repeats  whether another run gives the same value
  /// \throws std::invalid_argument if `key` is empty, holds a blank or was added before
  void add(const std::string& key, double value, const std::string& unit,
           Repeats repeats = Repeats::Yes);
  /// Names the number that stands for the whole program, and what it is compared with.
  /// \param key        of a line, added before or after
  /// \param reference  what the value should be, in the unit of that line
  /// \param source     where the reference comes from; any number of words
  void headline(const std::string& key, double reference, const std::string& source);
  /// A number that was added.
  /// \param key  of the line
  /// \return its value
  /// \throws std::invalid_argument if no such line was added
  [[nodiscard]] double value(const std::string& key) const;

  /// Prints the lines to the terminal with 6 digits.
  void print() const;
  /// Writes `<folder>/<program>.results` with 17 digits, the headline first.
  /// \param folder  must exist
  /// \throws ProblemError if the file cannot be written
  void write(const std::filesystem::path& folder) const;

 private:
  struct Line {
    std::string key;
    double value;
    std::string unit;
    Repeats repeats;
  };
  std::string program_;
  std::vector<Line> lines_;
  std::string headline_;
};

/// Writes a file in one go: first as `<file>.part` next to it, then renamed.
/// \param file     is replaced if it exists
/// \param content  all of it
/// \throws ProblemError if that fails; then `file` is as it was
void write_file(const std::filesystem::path& file, const std::string& content);

/// Sends on what std::cout still holds. Every program calls this last, because results that were
/// printed to a full disk are lost.
/// \throws ProblemError if a part of what was printed could not be written
void finish_printing();

/// Creates a folder if needed and tries to write there.
/// \param folder  with any folders above it that are missing
/// \throws ProblemError naming the folder if it cannot be made or written to
void prepare_output_folder(const std::filesystem::path& folder);

}  // namespace signorini
