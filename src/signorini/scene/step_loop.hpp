// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How a load step is solved that is no linear problem: what an effect hands to the plan, and the add-on steps calls.
#pragma once
#include <functional>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// A step whose pairs depend on where the bodies are.
struct StepLoop {
  /// Finds the pairs of a model anew and writes `pairs`, `law`, A and g, linear about there in all that the bodies have moved
  /// from the scene. Throws ProblemError if that cannot be, and then leaves the model as it was.
  std::function<void(const NodeArray& displacement, const NodeArray& before, Model& model)> place;
  /// Solves a step of a model that has its loads and is placed where the step before ended, at `before`, `n_nodes x 2`. It
  /// is then placed where the solution is, which is certified there. `condensed` has the factor and the free
  /// displacements; its compliance, gaps and law become those of the last iteration.
  std::function<Solution(const NodeArray& before, const SolverOptions& options, Model& model,
                         Condensed& condensed, Ledger ledger)>
      solve;
};

}  // namespace signorini
