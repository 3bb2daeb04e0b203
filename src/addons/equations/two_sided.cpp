// Pairs that never lift off, with friction. Of a pair in tension the other side presses: turned round, its gap is minus its gap
// and its force minus its force, and all laws of contact hold again, friction with the magnitude of the force too. So a
// solution of the turned problem in which none of these pairs is open is one of the problem that was posed.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "addons/equations/equations.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/pair_up.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// The first guess has these pairs stuck, so few turn round later. A loop that needs more solutions does not end.
constexpr int most_solutions = 25;

ContactStatus turned(ContactStatus status) {
  if (status == ContactStatus::SlipForward) return ContactStatus::SlipBackward;
  if (status == ContactStatus::SlipBackward) return ContactStatus::SlipForward;
  return status;
}

/// The largest displacement of a body less its rigid motion: how far it moves as a whole says nothing of gaps.
double strained(const BodyModel& body, const NodeArray& u) {
  const NodeArray x = body.mesh.nodes.rowwise() - body.mesh.nodes.colwise().mean();
  NodeArray left = u.rowwise() - u.colwise().mean();
  if (is_axial(body)) {
    left.col(0) = u.col(0);  // a radial shift strains
    return left.cwiseAbs().maxCoeff();
  }
  const double turn = (x.col(0).dot(left.col(1)) - x.col(1).dot(left.col(0))) / x.squaredNorm();
  left.col(0) += turn * x.col(1);
  left.col(1) -= turn * x.col(0);
  return left.cwiseAbs().maxCoeff();
}

/// What gaps of a solution are compared with [length].
struct Lengths {
  double strained = 0;  // by how much bodies move in themselves
  double rounding = 0;  // of positions, and of displacements that are given
};

Lengths lengths_of(const Model& model, const Solution& solution) {
  Lengths lengths;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    lengths.strained = std::max(lengths.strained, strained(model.bodies[b], solution.displacements[b]));
  const NodeArray& held = model.unknowns.held;
  lengths.rounding = gap_rounding(model.pairs) + 64 * epsilon * held.cwiseAbs().maxCoeff();
  return lengths;
}

/// Such a pair must not be open either, which a certificate of pairs that may be does not ask.
void add_gaps(const Model& model, const std::vector<Index>& pairs, Solution& solution) {
  const Lengths lengths = lengths_of(model, solution);
  const double open = largest(VectorXd(solution.contact.gap(pairs)));
  double& penetration = solution.certificate.penetration;
  penetration = std::max(penetration, ratio(std::max(0.0, open - lengths.rounding), lengths.strained));
}

/// A model of which some pairs are turned round, their slips with them.
class Turned {
 public:
  Turned(const Model& model, const Condensed& condensed)
      : model_(model),
        condensed_(condensed),
        sign_(VectorXd::Ones(model.programme.A.rows())),
        pairs_(condensed.problem.free_gap.size()) {
    if (!model_.followed) return;
    std::vector<FollowedContact> followed = *model_.followed;
    for (const Index pair : model_.two_sided)  // found again, they would face the other way
      followed[model_.contact_of[at(pair)]].linear = true;
    model_.followed = std::make_shared<const std::vector<FollowedContact>>(std::move(followed));
  }

  void turn(const std::vector<Index>& some);
  /// \return 1 of each row that stands as it was posed, -1 of each that is turned
  [[nodiscard]] std::vector<double> sides() const { return {sign_.begin(), sign_.end()}; }
  [[nodiscard]] Solution solved(SolveCondensed way, const Solver& solver, Ledger ledger,
                                SolverOptions options) const;
  /// Turns the numbers of a solution back.
  void turn_back(Solution& solution) const;
  /// Those of the pairs that are open in a solution, by more than rounding.
  [[nodiscard]] std::vector<Index> open(const Solution& solution,
                                        const std::vector<Index>& pairs) const;

 private:
  void turn_row(Index row);

  Model model_;
  Condensed condensed_;
  VectorXd sign_;  // of each row of A
  Index pairs_;
};

void Turned::turn_row(Index row) {
  ContactProblem& problem = condensed_.problem;
  problem.compliance.row(row) *= -1;
  problem.compliance.col(row) *= -1;
  if (problem.rigid.rows() > 0) problem.rigid.row(row) *= -1;
  (row < pairs_ ? problem.free_gap(row) : problem.free_slip(row - pairs_)) *= -1;
  model_.programme.A.row(row) *= -1;
  model_.programme.initial_gap(row) *= -1;
  sign_(row) *= -1;
}

void Turned::turn(const std::vector<Index>& some) {
  Pairs& pairs = model_.pairs;
  for (const Index pair : some) {
    turn_row(pair);
    pairs.opening.row(pair) *= -1;
    if (pairs.sliding.rows() > pair) pairs.sliding.row(pair) *= -1;
    pairs.initial_gap(pair) *= -1;
    for (NodeArray* means : {&pairs.normal, &pairs.moment, &pairs.target_moment})
      means->row(pair) *= -1;
  }
  const std::vector<Index>& frictional = model_.law.pair;
  for (std::size_t k = 0; k < frictional.size(); ++k)
    if (std::find(some.begin(), some.end(), frictional[k]) != some.end())
      turn_row(pairs_ + static_cast<Index>(k));
}

Solution Turned::solved(SolveCondensed way, const Solver& solver, Ledger ledger,
                        SolverOptions options) const {
  for (std::size_t pair = 0; pair < options.start.size(); ++pair)
    if (sign_(static_cast<Index>(pair)) < 0) options.start[pair] = turned(options.start[pair]);
  return way(model_, condensed_, solver, std::move(ledger), options);
}

void Turned::turn_back(Solution& solution) const {
  ContactState& state = solution.contact;
  if (state.force.size() != pairs_) return;
  const VectorXd of_slips = sign_.tail(sign_.size() - pairs_);
  for (VectorXd* numbers : {&state.force, &state.gap, &solution.pressure})
    if (numbers->size() == pairs_) *numbers = numbers->cwiseProduct(sign_.head(pairs_));
  for (VectorXd* numbers : {&state.friction, &state.slip})
    *numbers = numbers->cwiseProduct(of_slips);
  for (std::size_t k = 0; k < state.contact_status.size(); ++k)
    if (sign_(static_cast<Index>(k)) < 0) state.contact_status[k] = turned(state.contact_status[k]);
  if (solution.refined.force.size() == sign_.size())
    solution.refined.force = solution.refined.force.cwiseProduct(sign_);
}

std::vector<Index> Turned::open(const Solution& solution, const std::vector<Index>& pairs) const {
  const Lengths lengths = lengths_of(model_, solution);
  std::vector<Index> found;
  const double closed = certificate_tolerance * lengths.strained + lengths.rounding;
  for (const Index pair : pairs)
    if (std::abs(solution.contact.gap(pair)) > closed) found.push_back(pair);
  return found;
}

/// Pairs that would be in tension if nothing else touched, and all of them stuck.
std::vector<Index> in_tension(const ContactProblem& problem, const FrictionLaw& law,
                              const std::vector<Index>& pairs) {
  std::vector<Index> rows = pairs;
  for (std::size_t k = 0; k < law.pair.size(); ++k)
    if (std::binary_search(pairs.begin(), pairs.end(), law.pair[k]))
      rows.push_back(problem.free_gap.size() + static_cast<Index>(k));
  const Index n = static_cast<Index>(rows.size());
  const Index modes = problem.resultant.size();
  MatrixXd matrix = MatrixXd::Zero(n + modes, n + modes);
  matrix.topLeftCorner(n, n) = problem.compliance(rows, rows);
  VectorXd right(n + modes);
  right.head(n) = -free_movement(problem)(rows);
  if (modes > 0) {
    const MatrixXd R = problem.rigid(rows, Eigen::all);
    const double unit = largest(VectorXd(matrix.diagonal())) / R.cwiseAbs().maxCoeff();
    matrix.topRightCorner(n, modes) = unit * R;
    matrix.bottomLeftCorner(modes, n) = unit * R.transpose();
    right.tail(modes) = unit * problem.resultant;
  }
  const VectorXd force = least_norm_solution(matrix, right);
  std::vector<Index> found;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (force(static_cast<Index>(k)) < 0) found.push_back(pairs[k]);
  return found;
}

/// Turns pairs that are open, so that no set of sides comes twice. Where nothing presses, all pairs of a body may open together, to
/// either side in turn, and what holds it are pairs that face different ways. So a set that was seen is left, and one pair is turned.
/// \return whether there is a set that was not seen
bool turn_anew(const std::vector<Index>& open, Turned& side, std::set<std::vector<double>>& seen) {
  side.turn(open);
  if (seen.insert(side.sides()).second) return true;
  side.turn(open);
  for (const Index pair : open) {
    side.turn({pair});
    if (seen.insert(side.sides()).second) return true;
    side.turn({pair});
  }
  return false;
}

}  // namespace

Solution solve_two_sided(SolveCondensed way, const Model& model, const Condensed& condensed,
                         const Solver& solver, Ledger ledger, const SolverOptions& options) {
  const std::vector<Index>& pairs = model.two_sided;
  if (pairs.empty()) return way(model, condensed, solver, std::move(ledger), options);
  Turned side(model, condensed);
  side.turn(in_tension(condensed.problem, model.law, pairs));
  std::set<std::vector<double>> seen = {side.sides()};
  for (int count = 1;; ++count) {
    Solution solution = side.solved(way, solver, ledger, options);
    ledger = solution.ledger;
    const bool solved = solution.contact.report.status == SolveStatus::Solved;
    const std::vector<Index> open = solved ? side.open(solution, pairs) : std::vector<Index>();
    if (!open.empty() && count < most_solutions && turn_anew(open, side, seen)) continue;
    side.turn_back(solution);
    if (solved) add_gaps(model, pairs, solution);
    if (open.empty()) return solution;
    solution.contact.report.status = SolveStatus::IterationLimit;
    solution.contact.reason = "pairs that never lift off did not settle on which side presses";
    return solution;
  }
}

}  // namespace signorini
