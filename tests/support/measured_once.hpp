// What was measured once, on one machine and one day, and is read from the file that was committed.
#pragma once
#include <cctype>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "signorini/core/errors.hpp"

namespace signorini_test {

/// \param name  of a file that was committed \return its text
inline std::string committed(const std::string& name) {
  std::ifstream file(name);
  std::ostringstream content;
  content << file.rdbuf();
  signorini::require_input(file && !content.str().empty(), "expected the committed measurements ", name);
  return content.str();
}

/// \param name  of a file that was committed \return its rows of numbers; NaN is what was not measured, or failed
inline std::vector<std::vector<double>> measured_once(const std::string& name) {
  std::istringstream lines(committed(name));
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(lines, line);) {
    if (std::isdigit(static_cast<unsigned char>(line[0])) == 0) continue;  // a comment, or names
    std::istringstream words(line);
    rows.emplace_back();
    for (std::string word; std::getline(words, word, ',');) rows.back().push_back(std::stod(word));
  }
  return rows;
}

}  // namespace signorini_test
