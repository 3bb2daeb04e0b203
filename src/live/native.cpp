// The live figures in a terminal: an answer for each line of the input, for tests that compare with what a browser
// says.
#include <iostream>

#include "live/figure.hpp"

int main() {
  std::vector<Eigen::VectorXd> arrays;
  for (std::string words; std::getline(std::cin, words);) {
    std::string answer = live::answer(words, arrays);
    for (char& c : answer)
      if (c == '\n') c = ' ';
    std::cout << answer << '\n';
  }
}
