#include "signorini/report/shown.hpp"

#include <iostream>

#include "signorini/scene/prediction.hpp"

namespace signorini {

SolvedScene shown(const Scene& scene, const std::string& what) {
  static bool first = true;
  if (!first) return solved(scene, what);
  first = false;
  const Plan planned = plan(scene);
  const Prediction prediction = predict(planned);
  std::cout << "the plan of " << what << '\n' << planned << '\n';
  SolvedScene run = solved(scene, what);
  std::cout << "what it took\n"
            << run.solution.ledger << '\n'
            << confront(prediction, run.solution.ledger) << '\n';
  return run;
}

}  // namespace signorini
