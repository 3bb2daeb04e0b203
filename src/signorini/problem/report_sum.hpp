/// \file
/// The report of a solver that consists of several runs.
#pragma once
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Adds a run to those before it.
/// \param[in,out] total  of the runs before: gets the status of `run`, the sum of the counts and both histories
/// \param run            the last run
inline void append(Report& total, const Report& run) {
  total.status = run.status;
  total.iterations += run.iterations;
  total.factorisations += run.factorisations;
  total.history.insert(total.history.end(), run.history.begin(), run.history.end());
}

}  // namespace signorini
