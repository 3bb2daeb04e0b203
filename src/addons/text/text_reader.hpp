/// \file
/// Words and numbers of a text file, and errors that name the line.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// The words of a text, line by line.
///
/// Blanks, tabs and carriage returns part words. Nothing is believed about the text: sizes that it
/// announces are compared with its length before anything is allocated, and every error is one line
/// `NAME:LINE: expected ..., got ...`.
class TextReader {
 public:
  /// \param content  the whole text; must outlive this
  /// \param name     of the file, for messages
  /// \param comment  character that begins a comment, which lasts to the end of its line; or empty
  TextReader(std::string_view content, std::string name, std::string_view comment = "#");

  /// Goes on to the next line that holds a word.
  /// \return whether there is one
  bool next_line();
  /// \return the next word of this line; empty at its end
  std::string_view word();
  /// \return the next word of this line or of one below; empty at the end of the text
  std::string_view word_anywhere();
  /// \return what is left of this line, without the blanks around it
  std::string_view rest_of_line();

  /// Goes on to the next line, which must hold one given word.
  /// \param keyword  the word
  /// \throws ProblemError if the line holds anything else
  void expect_line(const std::string& keyword);
  /// Checks that nothing is left on this line.
  /// \param after  what stands before its end, for messages
  /// \throws ProblemError if a word is left
  void expect_end_of_line(const std::string& after);
  /// Goes on to the next line, which must hold a row of numbers and nothing else.
  /// \param what  name of the row, for messages
  /// \param row   is filled; if it has no entries, no line is read
  /// \throws ProblemError if the line holds fewer or more of them, or what is not a finite number
  void expect_row(const std::string& what, Eigen::Ref<Eigen::RowVectorXd> row);

  /// A word as a whole number.
  /// \param word   the word
  /// \param what   name of the number, for messages
  /// \param least  smallest number that makes sense
  /// \param most   largest number that makes sense
  /// \return the number
  /// \throws ProblemError if the word is anything else
  [[nodiscard]] std::int64_t whole(std::string_view word, const std::string& what,
                                   std::int64_t least, std::int64_t most) const;
  /// A word as a number of rows or columns: whole(), and at most `largest_size`.
  /// \param word   the word
  /// \param what   name of the number, for messages
  /// \param least  smallest number that makes sense
  /// \return the number
  /// \throws ProblemError if the word is anything else
  [[nodiscard]] Eigen::Index size(std::string_view word, const std::string& what,
                                  Eigen::Index least) const {
    return whole(word, what, least, largest_size);
  }
  /// A word as a number.
  /// \param word  the word
  /// \param what  name of the number, for messages
  /// \return a finite number
  /// \throws ProblemError if the word is anything else, or a number that is no finite double
  [[nodiscard]] double number(std::string_view word, const std::string& what) const;
  /// Checks, before memory is asked for, that so many numbers can stand in the rest of the text.
  /// \param rows     at most `largest_size`
  /// \param columns  at most `largest_size`
  /// \param what     name of the matrix, for messages
  /// \throws ProblemError if the rest is too short
  void check_room(Eigen::Index rows, Eigen::Index columns, const std::string& what) const;
  /// Refuses the text.
  /// \param expected  what should stand here
  /// \param got       the word that stands here; empty for the end of the line or of the text
  /// \throws ProblemError always
  [[noreturn]] void fail(const std::string& expected, std::string_view got) const;
  /// Refuses the text for another reason than one word.
  /// \param why  the rest of the message
  /// \throws ProblemError always
  [[noreturn]] void fail(const std::string& why) const;

  /// \return number of the present line, from 1
  [[nodiscard]] std::size_t line() const { return line_; }
  /// \return name of the file
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Largest number of rows or columns that is read.
  static constexpr Eigen::Index largest_size = 1000000;

 private:
  std::string_view text_;     // not yet looked at: begins after the present line
  std::string_view present_;  // not yet read of the present line
  std::size_t line_ = 0;
  std::string name_;
  std::string_view comment_;
};

/// Reads a whole file.
/// \param file  a plain file
/// \param most  bytes that it may have
/// \return its bytes
/// \throws ProblemError if there is no such file, it is no plain file, too long, or cannot be read
[[nodiscard]] std::string file_content(const std::filesystem::path& file, std::size_t most);

}  // namespace signorini
