// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// JSON documents, for programs that read what a program of this book says.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// Writes one JSON document, value by value, two blanks per level, numbers so that they come back
/// exactly.
///
/// JSON has no infinity and no "not a number": both become null.
class Json {
 public:
  /// Begins `{`. \return this
  Json& object();
  /// Begins `[`. \return this
  Json& array();
  /// Ends what was begun last. \return this
  /// \throws std::invalid_argument if nothing is open
  Json& end();
  /// Names the next value of an object. \param name  any text \return this
  Json& key(const std::string& name);

  /// Adds a text. \param value  in UTF-8; signs that cannot be printed, and bytes that are none of UTF-8, are escaped one by one
  /// \return this
  Json& value(const std::string& value);
  /// Adds a text. \param value  as above \return this
  Json& value(const char* value) { return this->value(std::string(value)); }
  /// Adds a number. \param value  any \return this
  Json& value(double value);
  /// Adds a whole number. \param value  any \return this
  Json& value(Eigen::Index value);
  /// Adds true or false. \param value  which \return this
  Json& value(bool value);
  /// Adds an array of numbers on one line. \param values  any \return this
  Json& value(const Eigen::VectorXd& values);
  /// Adds an array of texts on one line. \param values  as above; an empty one becomes null \return this
  Json& value(const std::vector<std::string>& values);

  /// The document.
  /// \return its text, with a line end
  /// \throws std::invalid_argument if something is still open
  [[nodiscard]] std::string text() const;

 private:
  void place();
  Json& put(const std::string& literal);

  std::string out_;
  std::vector<char> open_;  // the bracket that will close, for each level
  bool first_ = true;       // of its level
  bool named_ = false;      // a key was written, its value is next
};

}  // namespace signorini
