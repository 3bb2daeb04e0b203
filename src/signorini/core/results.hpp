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

  /// Adds one line. \param key what the text refers to, without blanks; \param unit `-` if none
  /// \throws std::invalid_argument if `key` is empty, holds a blank or was added before
  void add(const std::string& key, double value, const std::string& unit,
           Repeats repeats = Repeats::Yes);
  /// Names the number that stands for the whole program, and what it is compared with.
  void headline(const std::string& key, double reference, const std::string& source);
  /// The value added under `key`. \throws std::invalid_argument if there is none
  [[nodiscard]] double value(const std::string& key) const;

  /// Prints the lines to the terminal with 6 digits.
  void print() const;
  /// Writes `<folder>/<program>.results` with 17 digits.
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

/// Writes `content` to `file` in one go: first next to it, then renamed.
/// \throws ProblemError if that fails; then `file` is as it was
void write_file(const std::filesystem::path& file, const std::string& content);

/// Creates `folder` if needed and tries to write there.
/// \throws ProblemError naming the folder if it cannot be made or written to
void prepare_output_folder(const std::filesystem::path& folder);

}  // namespace signorini
