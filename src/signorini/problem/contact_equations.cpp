// # Contact as equations
//
// Newton's method solves equations. The conditions of a pair are two inequalities and a product,
// and the function of Fischer and Burmeister makes one equation of them:
// \f[ \varphi(g, \lambda) = \sqrt{g^2 + \lambda^2} - g - \lambda = 0
// \quad\text{exactly if}\quad g \ge 0,\ \lambda \ge 0,\ g\lambda = 0. \f]
// A friction force has two bounds, \f$ -b \le \tau \le b \f$, and the slip s says at which of them
// it is. Billups nested the function for such a *mixed complementarity problem*:
// \f[ \varphi(\tau + b,\ \varphi(b - \tau,\ -s)) = 0. \f]
// A pair with the coefficient 0.5 and the force 4 has b = 2:
//
// - It sticks with \f$ \tau = 1 \f$, s = 0. The inner function is \f$ \varphi(1, 0) = 0 \f$, and
//   the outer one \f$ \varphi(3, 0) = 0 \f$.
// - It slides forward with \f$ \tau = -2 \f$, s = 3. Now \f$ \varphi(4, -3) = 5 - 4 + 3 = 4 \f$ and
//   \f$ \varphi(0, 4) = 0 \f$.
// - With \f$ \tau = 2 \f$, s = 3 friction would push it on. Then \f$ \varphi(0, -3) = 6 \f$ and
//   \f$ \varphi(4, 6) = \sqrt{52} - 10 \f$, which is -2.8: no solution.
//
// The Jacobian of all the equations is that of gaps and slips, row by row times the slopes of these
// functions.

#include "signorini/problem/contact_equations.hpp"

#include "signorini/problem/complementarity_functions.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// The nested function, for all slips. The slip enters with a minus sign, because friction resists it.
void evaluate_nested(const ContactEquations& equations, const VectorXd& x, VectorXd& residual) {
  for (Index k = 0; k < equations.slips(); ++k) {
    const Index row = equations.pairs() + k;
    const double b = equations.bound(x, k);
    const double inner = fischer_burmeister(b - x(row), -equations.movement()(row));
    residual(row) = fischer_burmeister(x(row) + b, inner);
  }
}

// The chain rule. The row of J holds \f$ ds/dx \f$ when the function begins. The bound depends on
// the force of the pair, so the column of that force gets an entry too.
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

// The two readings differ in what the numbers mean. As printed, forces and movements are taken
// as they are. Mended, forces have the unit of gaps, and of the movements only those of balanced
// forces count. The least balanced forces \f$ Ut \f$ move the rows too, which belongs to the free
// movement.
ContactEquations::ContactEquations(const ScaledProblem& problem, const Formulation& form)
    : problem_(problem),
      form_(form),
      in_balance_(problem.rigid.cols() > 0 && form.reading == Reading::Mended),
      compliance_(in_balance_ ? balanced_compliance(problem) : problem.compliance),
      free_(problem.free),
      force_scale_(form.reading == Reading::Mended ? signorini::force_scale(problem, compliance_)
                                                   : 1),
      movement_(problem.free.size()),
      cohesion_(VectorXd::Zero(slips())) {
  compliance_ /= force_scale_;
  if (!in_balance_) return;
  const MatrixXd& U = problem.rigid;
  free_ += problem.compliance * (U * problem.resultant);
  free_ -= U * (U.transpose() * free_);
}

// The amplitude is counted differently here. F has also moved the body along U, on its springs. The
// equations do not know that part, so the amplitude has to contain it. read() takes it out again.
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

// Gaps and slips for given unknowns. Everything else is evaluated at them.
void ContactEquations::move(const VectorXd& x) {
  movement_ = free_;
  movement_.noalias() += compliance_ * x.head(rows());
  if (modes() > 0) movement_.noalias() += problem_.rigid * x.segment(rows(), modes());
}

// A pair loses its cohesion when it opens, at once. Newton's method cannot follow a jump. So which
// pairs have cohesion is decided here, and stays until the next call. Force and gap are compared,
// as in the active set method: of a solution one of the two is zero.
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

// A pair that pulls during an iteration would have a negative bound, and -b would be the larger of
// the two. So its bound is that of the force 0. The printed reading keeps the formula.
double ContactEquations::bound_slope(const VectorXd& x, Index k) const {
  const bool pulls = form_.reading == Reading::Mended && !(x(pair(k)) > 0);
  return pulls ? 0 : problem_.law.coefficient(k);
}

// One equation for each gap, then the balance, then the law of friction. The residual of the
// balance has the factor of the forces, as its unknowns do.
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

// The slope of \f$ \varphi(g_i, \lambda_i) \f$ by all unknowns: its first slope times the row of
// the gap, and its second slope on the diagonal.
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
