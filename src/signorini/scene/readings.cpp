// # What a solution is read for
//
// Most programs want a scene solved, and then to know what friction cost. An example: a block is
// pushed along its floor by 0.2, with a friction force of 3. The slip is 0.2, the work that is lost
// 0.6. Forces on nodes and in supports have a file of their own, [node_forces.cpp](node_forces.cpp),
// and so have [slips](slips.cpp) that are read from displacements.

#include "signorini/scene/readings.hpp"

#include <utility>

namespace signorini {

// A pair that sticks has slip 0 by definition, but the refined displacements leave a rest
// like \f$ 10^{-18} \f$. Sums over many steps should not collect it.
Eigen::VectorXd increment(const ContactState& contact) {
  Eigen::VectorXd slip = contact.slip;
  for (Eigen::Index k = 0; k < slip.size(); ++k)
    if (status_of_slip(contact, k) == ContactStatus::Stick) slip(k) = 0;
  return slip;
}

// A friction force of 3 that acts over a slip of 0.2 takes 0.6 of the energy. Friction acts
// against the slip, so the work is lost in both directions and the absolute value counts it.
Eigen::VectorXd dissipated(const ContactState& contact) {
  return contact.friction.cwiseProduct(increment(contact)).cwiseAbs();
}

// From a scene to its solution in four lines. Many programs of the chapters begin with it.
// [solved]
SolvedScene solved(const Scene& scene, const std::string& what) {
  Ledger ledger;
  Model model = build(scene, ledger);             // K, p, A, g of the quadratic programme
  Condensed condensed = condense(model, ledger);  // G = A K^-1 A^T and d = g - A u0
  Solution solution = solve(model, condensed, ledger);
  require_solved(solution, what);
  return {std::move(model), std::move(condensed), std::move(solution)};
}
// [solved]

}  // namespace signorini
