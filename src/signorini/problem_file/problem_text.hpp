/// \file
/// Words and numbers of a problem file, and errors that name the line.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <string_view>

namespace signorini {

/// The words of a text, line by line.
///
/// Blanks, tabs and carriage returns part words; `#` begins a comment that lasts to the end of its
/// line. Nothing is believed about the text: sizes that it announces are compared with its length
/// before anything is allocated, and every error is one line `NAME:LINE: expected ..., got ...`.
class ProblemText {
 public:
  /// \param content  the whole text; must outlive this
  /// \param name     of the file, for messages
  ProblemText(std::string_view content, std::string name);

  /// Goes on to the next line that holds a word.
  /// \return whether there is one
  bool next_line();
  /// \return the next word of this line; empty at its end
  std::string_view word();
  /// \return the next word of this line or of one below; empty at the end of the text
  std::string_view word_anywhere();

  /// Goes on to the next line, which must hold one given word.
  /// \param keyword  the word
  /// \throws ProblemError if the line holds anything else
  void expect_line(const std::string& keyword);
  /// Goes on to the next line, which must hold a given word and a whole number.
  /// \param keyword  the word
  /// \param least    smallest number that makes sense
  /// \return the number, at most `largest_size`
  /// \throws ProblemError if the line holds anything else
  Eigen::Index expect_size(const std::string& keyword, Eigen::Index least);
  /// Goes on to the next line, which must hold a row of numbers and nothing else.
  /// \param what  name of the row, for messages
  /// \param row   is filled; if it has no entries, no line is read
  /// \throws ProblemError if the line holds fewer or more of them, or what is not a finite number
  void expect_row(const std::string& what, Eigen::Ref<Eigen::RowVectorXd> row);

  /// A word as a whole number.
  /// \param word   the word
  /// \param what   name of the number, for messages
  /// \param least  smallest number that makes sense
  /// \return the number, at most `largest_size`
  /// \throws ProblemError if the word is anything else
  [[nodiscard]] Eigen::Index size(std::string_view word, const std::string& what,
                                  Eigen::Index least) const;
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
};

}  // namespace signorini
