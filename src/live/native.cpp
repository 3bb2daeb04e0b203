// The live figures in a terminal: an answer for each line of the input, for tests that compare with what a browser
// says. With the word --arrays each answer is followed by a line with the sizes of its arrays, and by their bytes.
#include <cstring>
#include <iostream>

#include "live/figure.hpp"

int main(int argc, char** argv) {
  const bool with_arrays = argc > 1 && std::strcmp(argv[1], "--arrays") == 0;
  std::vector<Eigen::VectorXd> arrays;
  for (std::string words; std::getline(std::cin, words);) {
    std::string answer = live::answer(words, arrays);
    for (char& c : answer)
      if (c == '\n') c = ' ';
    std::cout << answer << '\n';
    if (with_arrays) {
      for (const Eigen::VectorXd& array : arrays) std::cout << array.size() << ' ';
      std::cout << '\n';
      for (const Eigen::VectorXd& array : arrays)
        std::cout.write(reinterpret_cast<const char*>(array.data()),
                        static_cast<std::streamsize>(sizeof(double)) * array.size());
    }
    std::cout.flush();
  }
}
