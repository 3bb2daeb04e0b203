#include "signorini/problem/contact_equations.hpp"

#include "signorini/core/rounding.hpp"
#include "signorini/problem/complementarity_functions.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// P F P, or F if there are no modes.
MatrixXd in_balance(const ScaledProblem& problem) {
  const MatrixXd& U = problem.rigid;
  const MatrixXd& F = problem.compliance;
  if (U.cols() == 0) return F;
  MatrixXd projected = F - U * (U.transpose() * F);
  projected -= (projected * U).eval() * U.transpose();
  const double rounding = static_cast<double>(F.rows() + 1) * epsilon;
  if (force_scale(projected) <= rounding * force_scale(F))
    projected.setZero();  // only rigid motions
  return projected;
}

/// The factor on forces; where no force strains anything, that of the grounded body.
double force_scale_of(const ScaledProblem& problem, const MatrixXd& compliance) {
  return force_scale(compliance.isZero(0) ? problem.compliance : compliance);
}

// The law: phi(tau + b, phi(b - tau, -slip)) = 0.
void evaluate_nested(const ContactEquations& equations, const VectorXd& x, VectorXd& residual) {
  for (Index k = 0; k < equations.slips(); ++k) {
    const Index row = equations.pairs() + k;
    const double b = equations.bound(x, k);
    const double inner = fischer_burmeister(b - x(row), -equations.movement()(row));
    residual(row) = fischer_burmeister(x(row) + b, inner);
  }
}

void differentiate_nested(const ContactEquations& equations, const VectorXd& x, MatrixXd& J) {
  for (Index k = 0; k < equations.slips(); ++k) {
    const Index row = equations.pairs() + k;
    const double b = equations.bound(x, k);
    const double tau = x(row);
    const double slip = equations.movement()(row);
    const ComplementaritySlope in = fischer_burmeister_slope(b - tau, -slip);
    const ComplementaritySlope out =
        fischer_burmeister_slope(tau + b, fischer_burmeister(b - tau, -slip));
    J.row(row) *= -out.b * in.b;
    J(row, row) += out.a - out.b * in.a;
    J(row, equations.pair(k)) += (out.a + out.b * in.a) * equations.bound_slope(x, k);
  }
}

}  // namespace

const Formulation nested_friction = {0, nullptr, evaluate_nested, differentiate_nested};

ContactEquations::ContactEquations(const ScaledProblem& problem, const Formulation& form)
    : problem_(problem),
      form_(form),
      in_balance_(problem.rigid.cols() > 0 && form.reading == Reading::Mended),
      compliance_(in_balance_ ? in_balance(problem) : problem.compliance),
      free_(problem.free),
      force_scale_(form.reading == Reading::Mended ? force_scale_of(problem, compliance_) : 1),
      movement_(problem.free.size()),
      cohesion_(VectorXd::Zero(slips())) {
  compliance_ /= force_scale_;
  if (!in_balance_) return;
  const MatrixXd& U = problem.rigid;
  free_ += problem.compliance * (U * problem.resultant);
  free_ -= U * (U.transpose() * free_);
}

VectorXd ContactEquations::unknowns(const ActiveSetSolution& solution) {
  VectorXd x = VectorXd::Zero(size());
  x.head(rows()) = force_scale_ * solution.force;
  x.segment(rows(), modes()) = solution.amplitude;
  if (in_balance_)
    x.segment(rows(), modes()) +=
        problem_.rigid.transpose() * (problem_.free + problem_.compliance * solution.force);
  choose_closed(x);
  if (form_.start != nullptr) form_.start(*this, x);
  return x;
}

void ContactEquations::read(const VectorXd& x, ActiveSetSolution& solution) const {
  solution.force = x.head(rows()) / force_scale_;
  solution.movement = movement_;
  solution.amplitude = x.segment(rows(), modes());
  if (in_balance_)
    solution.amplitude -=
        problem_.rigid.transpose() * (problem_.free + problem_.compliance * solution.force);
  solution.movement_rounding.resize(0);
}

void ContactEquations::move(const VectorXd& x) {
  movement_ = free_;
  movement_.noalias() += compliance_ * x.head(rows());
  if (modes() > 0) movement_.noalias() += problem_.rigid * x.segment(rows(), modes());
}

void ContactEquations::choose_closed(const VectorXd& x) {
  move(x);
  for (Index k = 0; k < slips(); ++k) {
    const bool carries = form_.reading == Reading::AsPrinted || x(pair(k)) > movement_(pair(k));
    cohesion_(k) = carries ? force_scale_ * problem_.law.cohesion(k) : 0;
  }
}

double ContactEquations::bound(const VectorXd& x, Index k) const {
  return bound_slope(x, k) * x(pair(k)) + cohesion_(k);
}

double ContactEquations::bound_slope(const VectorXd& x, Index k) const {
  const bool pulls = form_.reading == Reading::Mended && !(x(pair(k)) > 0);
  return pulls ? 0 : problem_.law.coefficient(k);
}

void ContactEquations::evaluate(const VectorXd& x, VectorXd& residual) {
  move(x);
  for (Index i = 0; i < pairs(); ++i) residual(i) = fischer_burmeister(movement_(i), x(i));
  if (modes() > 0) {
    auto balance = residual.segment(rows(), modes());
    balance = -force_scale_ * problem_.resultant;
    balance.noalias() += problem_.rigid.transpose() * x.head(rows());
  }
  form_.evaluate(*this, x, residual);
}

void ContactEquations::differentiate(const VectorXd& x, MatrixXd& J) const {
  J.setZero();
  J.topLeftCorner(rows(), rows()) = compliance_;
  if (modes() > 0) {
    J.block(0, rows(), rows(), modes()) = problem_.rigid;
    J.block(rows(), 0, modes(), rows()) = problem_.rigid.transpose();
  }
  for (Index i = 0; i < pairs(); ++i) {
    const ComplementaritySlope slope = fischer_burmeister_slope(movement_(i), x(i));
    J.row(i) *= slope.a;
    J(i, i) += slope.b;
  }
  form_.differentiate(*this, x, J);
}

}  // namespace signorini
