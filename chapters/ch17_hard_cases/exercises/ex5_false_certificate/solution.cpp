#include "exercise.hpp"

namespace ex17_5 {

using signorini::Certificate;

std::vector<std::string> understated(const signorini::QuadraticProgramme& posed,
                                     const Document& document) {
  const Certificate really = signorini::certify(posed, document.answer);
  const Certificate& printed = document.printed;
  std::vector<std::string> names;
  const auto compare = [&](const char* name, double Certificate::*figure) {
    // Asked for what is right: no comparison with what is no number is true.
    const bool stated = printed.*figure >= 0;
    const bool small = really.*figure <= 2 * (printed.*figure) || really.*figure <= 1e-15;
    if (!stated || !small) names.emplace_back(name);
  };
  compare("penetration", &Certificate::penetration);
  compare("tension", &Certificate::tension);
  compare("complementarity", &Certificate::complementarity);
  compare("equilibrium", &Certificate::equilibrium);
  compare("duality gap", &Certificate::duality_gap);
  return names;
}

Opinion read(const signorini::QuadraticProgramme& posed, const std::vector<Document>& pile) {
  Opinion opinion;
  for (std::size_t k = 0; k < pile.size(); ++k) {
    if (!understated(posed, pile[k]).empty())
      opinion.untrue.push_back(k);
    else
      (certify(posed, pile[k].answer).holds(1e-12) ? opinion.believed : opinion.bad).push_back(k);
  }
  return opinion;
}

}  // namespace ex17_5
