#include "papers/simplex_face.hpp"

#include <algorithm>
#include <limits>

#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

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

SimplexFace::SimplexFace(const ContactProblem& problem)
    : numbers_(std::make_shared<Numbers>(problem)) {}

bool SimplexFace::add(Index vertex) {
  return numbers_->method.take_in(vertex) != SolveStatus::Infeasible;
}

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
