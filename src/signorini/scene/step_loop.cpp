// # Steps that are loops
//
// A load step is one linear problem, as long as pairs and forces do not depend on where the bodies are. Where they do, an
// effect hands a loop to the plan, and the add-on steps asks it for each step. The library itself has no such effect.
//
// Pairs are found anew in such a loop. The pairs of nodes 3, 4 and 5 may become those of 4, 5 and 6: then what
// the first one knew is lost, the second and the third go on as the first and the second, and the last one is new.
// As numbers among the others that is 1, 2, -1.

#include "signorini/scene/step_loop.hpp"

#include <map>

namespace signorini {

using Eigen::Index;

// What supports give is exact, and has no second part.
Displaced displaced(const Unknowns& unknowns, const PrimalDual& solution) {
  Displaced all(expand(unknowns, solution.displacement));
  if (solution.displacement_low.size() == 0) return all;
  for (Index node = 0; node < all.low.rows(); ++node)
    for (const int axis : {0, 1})
      if (const Index k = unknowns.number(node, axis); k >= 0)
        all.low(node, axis) = solution.displacement_low(k);
  return all;
}

// Pairs come and go as bodies move. What a pair knows goes on with the node of its source, and with
// the contact, since a node may be in two of them.
std::vector<PairName> names_of_pairs(const Model& model) {
  std::vector<PairName> names;
  for (std::size_t pair = 0; pair < model.contact_of.size(); ++pair)
    names.emplace_back(model.contact_of[pair], model.pairs.node[pair]);
  return names;
}

// Slips are rows of their own, in the order of the law, which leaves out pairs without friction.
std::vector<PairName> names_of_slips(const Model& model) {
  const std::vector<PairName> all = names_of_pairs(model);
  std::vector<PairName> names;
  for (const Index pair : model.law.pair) names.push_back(all[static_cast<std::size_t>(pair)]);
  return names;
}

// A list of names is searched once for each of the others: as a map, since a side may have a thousand
// nodes.
std::vector<Index> numbers_among(const std::vector<PairName>& others,
                                 const std::vector<PairName>& these) {
  std::map<PairName, Index> known;
  for (const PairName& name : others) known.emplace(name, static_cast<Index>(known.size()));
  std::vector<Index> numbers;
  for (const PairName& name : these) {
    const auto found = known.find(name);
    numbers.push_back(found == known.end() ? -1 : found->second);
  }
  return numbers;
}

}  // namespace signorini
