// # Dual active sets, step by step
//
// Pairs W are closed and press. One more pair p overlaps and is to close. If its force grows by 1
// and W stays closed, the forces of W change by -r and the gap of p by a,
// \f[ r = G_{WW}^{-1}G_{Wp}, \qquad a = G_{pp} - G_{pW}\,r \ge 0. \f]
// p closes when its force has grown by \f$ -g_p/a \f$. On the way the force of a pair of W may
// vanish, first where \f$ \lambda_k/r_k \f$ is least among \f$ r_k > 0 \f$. That pair opens, r and
// a are computed for the smaller set, and the pressing goes on. No force becomes negative, and the
// energy rises all the way.
//
// The carts, G = [1 1 1; 1 2 2; 1 2 3] with cart 1 closed by the force 2: cart 3 overlaps by 1.
// Here r = 1 and a = 3 - 1 = 2. It closes at the force 1/2, before the force of cart 1 would vanish
// at 2. The forces are (1.5, 0, 0.5).
//
// If p depends on W, a is 0: pressing p does not open its gap. Either a pair leaves, or r has no
// positive entry. In the second case forces may grow for ever along (-r, 1) and move nothing. Then
// nothing solves the problem: cannot_close() in
// [dual_active_set_rounding.cpp](dual_active_set_rounding.cpp).

#include <algorithm>

#include "signorini/core/index.hpp"
#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// Drops rows and their entries in the forces.
void DualActiveSet::open_vanished(const std::vector<Index>& positions) {
  for (auto k = positions.rbegin(); k != positions.rend(); ++k)
    for (Index i = *k + 1; i < force_.size(); ++i) force_(i - 1) = force_(i);
  drop(positions);
}

// The closed row whose force vanishes first when the forces change by -response, and the step to
// there; -1 if none does. A response so small that without this row the new one would still depend
// on the others is rounding. A pair that left for such a response would leave a set behind that is
// singular with the new pair.
std::pair<Index, double> DualActiveSet::first_to_open(const VectorXd& response) const {
  std::vector<Index> yielding;
  for (Index k = 0; k < basis_.size(); ++k)
    if (response(k) > 0 && basis_.rows()[at(k)] >= rows_.equations) yielding.push_back(k);
  const auto step = [&](Index k) { return force_(k) / response(k); };
  std::sort(yielding.begin(), yielding.end(),
            [&](Index a, Index b) { return step(a) < step(b) || (step(a) == step(b) && a < b); });
  for (const Index k : yielding)
    if (response(k) * basis_.distance_from_others(k) > basis_.smallest_distance())
      return {k, step(k)};
  return {-1, 0};
}

// Closes a row that carries a force already. \return false if it depends on the closed ones The
// factor takes the row with its present gap, so the gaps are computed first.
bool DualActiveSet::join(Index row, double force) {
  rows_.gaps(basis_, gap_, rounding_);
  fetch(row);
  if (basis_.append(candidates_, ActiveSetFactor::Choice::All, 1) == 0) return false;
  force_(basis_.size() - 1) = force;
  state_[at(row)] = Row::Closed;
  return true;
}

// Changes the forces of the closed rows by -step * response. Rounding may leave those of rows that
// yield faster than the first to open a little below zero.
void DualActiveSet::yield(const VectorXd& response, double step) {
  force_.head(basis_.size()) -= step * response;
  for (Index k = 0; k < basis_.size(); ++k)
    if (basis_.rows()[at(k)] >= rows_.equations) force_(k) = std::max(0.0, force_(k));
}

// The step of Goldfarb and Idnani. A pair is pressed through as many sets as it takes. The opening
// of its gap is summed up, because the factor knows the gap only for the forces of the basis.
// [press]
/// Presses a violated row until it closes; closed rows whose force vanishes on the way open.
SolveStatus DualActiveSet::press(Index row) {
  double pressed = 0;
  double lifted = 0;  // of the gap of the normalised row
  while (report_.iterations < limit_) {
    fetch(row);
    const double gap = candidates_.gap(0) + lifted;
    const auto [response, opening] = basis_.response(candidates_);
    const auto [first, step] = first_to_open(response);
    const bool closes = opening > 0 && (first < 0 || -gap <= step * opening);
    if (!closes && first < 0) return cannot_close(row, response);
    const double change = closes ? -gap / opening : step;
    yield(response, change);
    pressed += change;
    ++report_.iterations;
    if (closes) {
      if (!join(row, pressed)) return SolveStatus::Breakdown;
      basis_.solve(target_);  // by a factor that is only updated
      force_.head(basis_.size()) = target_.head(basis_.size());
      return SolveStatus::Solved;
    }
    lifted += change * opening;
    open_vanished({first});
  }
  return SolveStatus::IterationLimit;
}
// [press]

// A caller that chooses the row itself, as the faces of the simplex in
// [simplex_face.cpp](../../papers/simplex_face.cpp) do.
SolveStatus DualActiveSet::take_in(Index row) {
  rows_.gaps(basis_, gap_, rounding_);
  return press(row);
}

}  // namespace signorini
