// The last step of the paper (Xuan & Li 2002, eqs. 33-35), in exact fractions.
#pragma once
#include "support/exact.hpp"

namespace ch04 {

struct LastStep {
  exact::Rest next;  // u^{k+1}
  exact::Fraction delta = 1;
  exact::Vector end;  // u*
};

// [last step]
inline LastStep last_step(const exact::Programme& q, const exact::Vector& u,
                          const exact::Set& tight) {
  LastStep step;
  step.next = closest(q, tight, q.p);  // (33)
  const exact::Vector way = exact::along(step.next.u, -1, u);
  for (const std::size_t i : rows_with(q, step.next.u, -1)) {
    const exact::Fraction ratio = gap(q, i, u) / dot(q.A[i], way);  // (34)
    step.delta = ratio < step.delta ? ratio : step.delta;
  }
  step.end = exact::along(u, step.delta, way);  // (35)
  return step;
}
// [last step]

/// With the rows that have no gap at u, exactly.
inline LastStep last_step(const exact::Programme& q, const exact::Vector& u) {
  return last_step(q, u, rows_with(q, u, 0));
}

}  // namespace ch04
