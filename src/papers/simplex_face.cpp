// # The best point of a face
//
// The vertices of the simplex are single pairs, and some of them span a face: weights that are zero
// for all other pairs. At the best point of the face with the vertices W every pair of W is closed
// and presses,
// \f[ G_{WW}\lambda_W = b_W, \qquad \lambda_W > 0, \f]
// because a pair with a gap would give weight away and a pair with an overlap would want more.
// These are the equations that the dual active set solves when one pair more is closed. So a face
// is a DualActiveSet that is told which pair comes next.
//
// In the example with \f$ b = (7, 5) \f$ the face of the first vertex has the force 7/2. The second
// vertex joins: its force grows from 0 to 1, the first one yields from 7/2 to 3, and both gaps are
// closed.

#include "papers/simplex_face.hpp"

#include <algorithm>
#include <limits>

#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

struct SimplexFace::Numbers {
  explicit Numbers(const ContactProblem& problem)
      : scaled(equilibrate(problem)),
        ones(VectorXd::Ones(scaled.free.size())),
        rows(rows_of(scaled, ones)),
        method(rows, ActiveSetFactor(0, rows.count), report, std::numeric_limits<Index>::max(),
               DualActiveSet::Step::Single) {}

  ScaledProblem scaled;
  VectorXd ones;
  ConstraintRows rows;
  Report report;
  DualActiveSet method;
};

// `method` refers to `rows`, and `rows` to `scaled`. So the numbers stand on the heap, where they
// keep their place when the face is moved.
SimplexFace::SimplexFace(const ContactProblem& problem)
    : numbers_(std::make_shared<Numbers>(problem)) {}

bool SimplexFace::add(Index vertex) {
  return numbers_->method.take_in(vertex) != SolveStatus::Infeasible;
}

// A force that rounding has made negative is zero.
VectorXd SimplexFace::forces() const {
  const ActiveSetFactor& basis = numbers_->method.basis();
  VectorXd solved;
  basis.solve(solved);
  VectorXd force = VectorXd::Zero(numbers_->rows.count);
  for (Index k = 0; k < basis.size(); ++k) {
    const Index pair = basis.rows()[static_cast<std::size_t>(k)];
    force(pair) = std::max(0.0, solved(k)) * numbers_->scaled.scale(pair);
  }
  return force;
}

VectorXd SimplexFace::farkas_certificate() const {
  return numbers_->scaled.scale.cwiseProduct(numbers_->method.proof());
}

Index SimplexFace::factorisations() const { return numbers_->method.basis().size() > 0 ? 1 : 0; }

}  // namespace signorini
