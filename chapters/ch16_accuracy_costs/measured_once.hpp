/// \file
/// What was measured once, on one machine and one day, and is read from the file that was committed.
#pragma once
#include <cctype>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "signorini/core/errors.hpp"

namespace ch16 {

/// \param name  of a file beside this one \return its text
inline std::string committed(const std::string& name) {
  std::ifstream file(std::string(SIGNORINI_CHAPTER_DATA "/") + name);
  std::ostringstream content;
  content << file.rdbuf();
  signorini::require_input(file && !content.str().empty(), "chapter 16: expected the measurements ",
                           name, " beside its programs");
  return content.str();
}

/// \param name  of a file beside this one \return its rows of numbers; NaN is what was not measured, or failed
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

}  // namespace ch16
