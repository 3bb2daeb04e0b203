// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Lines of an input file of CalculiX or Abaqus: keywords with parameters, and data between commas.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "addons/text/text_reader.hpp"

namespace signorini {

/// \param name  of a keyword, a parameter or a set
/// \return its key: in capital letters, without quotes, as input files do not tell small letters from large ones
[[nodiscard]] std::string inp_key(std::string_view name);

/// An input file, line by line; comments are passed over.
class InpText : public TextReader {
 public:
  /// \param content  the whole text; must outlive this
  /// \param name     of the file, for messages
  InpText(std::string_view content, const std::string& name) : TextReader(content, name, "") {}

  /// Goes on to the next line. \return whether there is one
  bool next();
  /// \return the keyword, if the line is one, and those that it goes on in; empty for a line of data
  [[nodiscard]] const std::string& keyword() const { return keyword_; }
  /// \return what stands between the commas of a line of data; nothing behind the last one
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }

  /// \param parameter  its key \return whether the last keyword has it
  [[nodiscard]] bool has(const char* parameter) const { return parameters_.count(parameter) != 0; }
  /// \param parameter  its key \return its value, as it is written
  /// \throws ProblemError if the last keyword has none, or one with control characters
  [[nodiscard]] const std::string& value(const char* parameter) const;

 private:
  std::string keyword_;
  std::map<std::string, std::string> parameters_;
  std::vector<std::string_view> fields_;
};

}  // namespace signorini
