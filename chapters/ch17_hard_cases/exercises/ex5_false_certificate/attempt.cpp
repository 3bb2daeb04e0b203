#include "exercise.hpp"

namespace ex17_5 {

std::vector<std::string> understated(const signorini::QuadraticProgramme& /*posed*/,
                                     const Document& /*document*/) {
  return {};  // your code here
}

Opinion read(const signorini::QuadraticProgramme& /*posed*/, const std::vector<Document>& pile) {
  Opinion opinion;
  for (std::size_t k = 0; k < pile.size(); ++k)
    (pile[k].printed.holds() ? opinion.believed : opinion.bad).push_back(k);
  return opinion;  // your code here: this believes whatever is printed
}

}  // namespace ex17_5
