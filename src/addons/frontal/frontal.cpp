// The back end `frontal`: ours.
#include <memory>

#include "addons/frontal/backend.hpp"
#include "addons/frontal/frontal_factor.hpp"

namespace signorini {
namespace {

/// A tree serves every matrix whose parts it keeps apart.
EliminationOrder order_of(const Stiffness& K, Ledger& ledger) {
  const Ledger::Phase ordering(ledger, "ordering");
  if (const auto* before = std::any_cast<EliminationOrder>(&K.order))
    if (*before && keeps_apart(**before, K.matrix)) return *before;
  ledger.count("orders", 1);
  return std::make_shared<const SeparatorTree>(
      separator_tree(K.matrix, K.positions ? K.positions() : Positions{}));
}

Factor factored(const Stiffness& K, Ledger& ledger) {
  const auto factor = std::make_shared<const FrontalFactor>(K.matrix, *order_of(K, ledger), ledger,
                                                            K.describe, K.grounded);
  return {[factor](const Eigen::Ref<const Eigen::VectorXd>& load) { return factor->solve(load); },
          [factor](const Factor::Rows& A, Ledger& counts) { return factor->compliance(A, counts); },
          {factor->size(), factor->nonzeros(), factor->operations(), factor->solve_operations()},
          [factor](const std::vector<Eigen::Index>& unknowns) {
            const FrontalFactor::Part part = factor->part(unknowns);
            return Factor::Part{[factor, part](const Eigen::Ref<const Eigen::VectorXd>& load) {
                                  return factor->solve(part, load);
                                },
                                part.solve_operations};
          },
          [factor] { return EliminationOrder(std::make_shared<const SeparatorTree>(factor->tree())); }};
}

}  // namespace

Backend frontal() {
  return {"frontal", "front by front on a tree of separators; ours, needs nothing", factored};
}

}  // namespace signorini
