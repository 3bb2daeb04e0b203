// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How a load step is solved that is no linear problem: what an effect hands to the plan, and the add-on steps calls.
#pragma once
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// Displacements of all nodes in two doubles: of a body that is carried far, one would round its strains away.
struct Displaced {
  /// \param all  `n_nodes x 2` [length], exact
  Displaced(NodeArray all) : high(std::move(all)), low(NodeArray::Zero(high.rows(), 2)) {}
  /// \param leading  `n_nodes x 2` [length] \param rest  `n_nodes x 2` what that lacks [length]
  Displaced(NodeArray leading, NodeArray rest) : high(std::move(leading)), low(std::move(rest)) {}

  NodeArray high;  ///< `n_nodes x 2` rounded to double [length]
  NodeArray low;   ///< `n_nodes x 2` what rounding took [length]
};

/// A step whose pairs, or forces, depend on where the bodies are.
struct StepLoop {
  /// Finds the pairs of a model anew and writes `pairs`, `law`, A and g, linear about there in all that the bodies have moved
  /// from the scene. Throws ProblemError if that cannot be, and then leaves the model as it was.
  std::function<void(const Displaced& displacement, const Displaced& before, Model& model)> place;
  /// Solves a step of a model that has its loads and is placed where the step before ended, at `before`; `expected` is the way
  /// of its unknowns if they go on as in that step, empty if nothing is known. It
  /// is then placed where the solution is, which is certified there. `condensed` has the factor and the free
  /// displacements; its compliance, gaps and law become those of the last iteration.
  std::function<Solution(const Displaced& before, const Eigen::VectorXd& expected,
                         const SolverOptions& options, Model& model, Condensed& condensed,
                         Ledger ledger)>
      solve;
  /// The certificate of a claim, with u from the scene, of a model that has its loads and is placed there. \return of the equations at that place, not
  /// of linear ones
  std::function<Certificate(const PrimalDual& claim, const Model& model)> certify;
};

/// \param unknowns  `n` of all bodies, with what supports give
/// \param solution  u in two parts
/// \return displacements of all nodes
[[nodiscard]] Displaced displaced(const Unknowns& unknowns, const PrimalDual& solution);

/// Which pair is which, wherever it stands among the others: the number of its contact and the node of its source.
using PairName = std::pair<std::size_t, Eigen::Index>;

/// \param model  with pairs that have nodes
/// \return `n_c` names of its pairs
[[nodiscard]] std::vector<PairName> names_of_pairs(const Model& model);

/// \param model  with pairs that have nodes
/// \return `n_s` names of the pairs that can slide
[[nodiscard]] std::vector<PairName> names_of_slips(const Model& model);

/// Which of other pairs is which of these.
/// \param others  names, each once
/// \param these   names
/// \return for each of these the number that it has among the others; -1 where it is not among them
[[nodiscard]] std::vector<Eigen::Index> numbers_among(const std::vector<PairName>& others,
                                                      const std::vector<PairName>& these);

}  // namespace signorini
