#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/equations/take_equations.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/step_loop.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

/// A spring k times as stiff as what it joins differs from the equation in its place by 1 / k. Entries of K are rounded by epsilon
/// times themselves, so that k epsilon of the forces do not balance. The sum of both errors is least where k is this: beyond it
/// a spring only gets farther from what it stands for.
const double stiffest = 1 / std::sqrt(epsilon);

/// T, which gives all unknowns by those that are not eliminated, or E, which tells what the eliminated ones differ by from
/// what the equations say.
Sparse part_of(const Eliminated& solved, Index unknowns, bool of_difference) {
  const Index count = static_cast<Index>(solved.unknown.size());
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<bool> eliminated(at(unknowns), false);
  const auto add = [&](Index row, Index column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (Index k = 0; k < count; ++k) {
    const Index own = solved.unknown[at(k)];
    eliminated[at(own)] = true;
    if (of_difference) add(k, own, 1);
    for (NodalRows::InnerIterator entry(solved.by, k); entry; ++entry)
      add(of_difference ? k : own, entry.col(), of_difference ? -entry.value() : entry.value());
  }
  for (Index i = 0; !of_difference && i < unknowns; ++i)
    if (!eliminated[at(i)]) add(i, i, 1);
  Sparse rows(of_difference ? count : unknowns, unknowns);
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

/// Exactly symmetric, as K is: of two sums in another order the lower one counts.
Sparse symmetric(const Sparse& matrix) {
  const Sparse lower = matrix.triangularView<Eigen::Lower>();
  return lower.selfadjointView<Eigen::Lower>();
}

class Taking {
 public:
  explicit Taking(Model& model)
      : model_(model),
        all_(*model.equations),
        T_(part_of(all_.solved, model.unknowns.count, false)),
        E_(part_of(all_.solved, model.unknowns.count, true)),
        C_(free_columns(all_.matrix, model.unknowns)),
        stiffness_(static_cast<Index>(all_.rows.size())) {
    for (Index k = 0; k < stiffness_.size(); ++k)
      stiffness_(k) = all_.rows[at(k)].stiffness.value_or(0);
    Sparse& K = model.programme.stiffness;
    if (stiffness_.size() > static_cast<Index>(all_.held.size()))
      K += symmetric(Sparse(C_.transpose()) * Sparse(stiffness_.asDiagonal() * C_));
    springs_ = VectorXd(K.diagonal())(all_.solved.unknown);
  }

  /// Changes p and g. \param right  h `m` \param load  p, which gets what drives rigid sides \param movement  g
  /// \param factors  of histories
  void take(const VectorXd& right, const Factors& factors, VectorXd& load, VectorXd& movement) const {
    const QuadraticProgramme& programme = model_.programme;
    const VectorXd given = all_.solved.right * right;
    VectorXd shift = VectorXd::Zero(load.size());
    shift(all_.solved.unknown) = given;
    for (const Bond& bond : all_.bonds)
      for (const BondLoad& push : bond.loads)
        if (const Index k = model_.unknowns.number(push.component / 2, push.component % 2); k >= 0)
          load(k) += factors(push.history) * push.force;
    load += C_.transpose() * stiffness_.cwiseProduct(right);
    const VectorXd rest = load - programme.stiffness * shift;
    load = T_.transpose() * rest + E_.transpose() * springs_.cwiseProduct(given);
    movement -= programme.A * shift;
  }

  void take_matrices() {
    QuadraticProgramme& programme = model_.programme;
    programme.A = on_free_unknowns(programme.A, T_);
    const Sparse moved = programme.stiffness * T_;
    const Sparse pulled = springs_.asDiagonal() * E_;
    programme.stiffness = symmetric(Sparse(T_.transpose() * moved) + Sparse(E_.transpose() * pulled));
    programme.stiffness.makeCompressed();
  }

 private:
  Model& model_;
  const Equations& all_;
  Sparse T_, E_;
  NodalRows C_;         // on the unknowns
  VectorXd stiffness_;  // of rows that are springs
  VectorXd springs_;    // on the differences of eliminated unknowns from what the equations say
};

}  // namespace

Sparse by_free_unknowns(const Eliminated& solved, Index unknowns) {
  return part_of(solved, unknowns, false);
}

void check_springs(Model& model) {
  const Equations& all = *model.equations;
  const NodalRows rows = free_columns(all.matrix, model.unknowns);
  const VectorXd bodies = model.programme.stiffness.diagonal();
  for (Index k = 0; k < rows.rows(); ++k) {
    double spring = 0;
    double own = 0;
    for (NodalRows::InnerIterator it(rows, k); it; ++it) {
      spring = std::max(spring, all.rows[at(k)].stiffness.value_or(0) * it.value() * it.value());
      own = std::max(own, bodies(it.col()));
    }
    const auto bond = std::find_if(all.bonds.begin(), all.bonds.end(),
                                   [&](const Bond& one) { return at(k) < one.end; });
    require_input(spring <= stiffest * own, bond->what, ": a spring of it has the stiffness ", spring,
                  " [force/length], ", spring / own, " times that of what it joins: above ", stiffest,
                  " times, rounding spoils the balance more than stiffness helps. Leave out "
                  "stiffness: then it holds exactly");
  }
}

void take_equations(Model& model) {
  if (model.loop) {
    auto kept = std::make_shared<Equations>(*model.equations);
    kept->bodies = model.programme.stiffness;
    model.equations = std::move(kept);
  }
  Taking taking(model);
  QuadraticProgramme& programme = model.programme;
  const Factors all_there = [](const std::string&) { return 1.0; };
  taking.take(right_sides(*model.equations, model.unknowns.held, all_there), all_there, programme.load,
              programme.initial_gap);
  for (LoadPart& part : model.parts) {
    const Factors own = [&part](const std::string& history) { return history == part.history ? 1.0 : 0.0; };
    NodeArray held(count_nodes(model.bodies), 2);
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
      held.middleRows(model.bodies[b].first_node, part.held[b].rows()) = part.held[b];
    taking.take(right_sides(*model.equations, held, own), own, part.load, part.movement);
  }
  taking.take_matrices();
}

VectorXd lacking_at(const Displaced& place, const Model& model) {
  const Equations& all = *model.equations;
  const Factors factors = factors_at(model.path.histories, model.time);
  VectorXd lacking(all.matrix.rows());
  for (Index row = 0; row < lacking.size(); ++row) {
    ExactSum sum;
    sum.add_product(factors(all.rows[at(row)].history), all.rows[at(row)].right);
    for (NodalRows::InnerIterator it(all.matrix, row); it; ++it) {
      const Index node = it.col() / 2, axis = it.col() % 2;
      const bool held = model.unknowns.number(node, axis) < 0;
      sum.add_product(-it.value(),
                      held ? model.unknowns.held(node, axis) : place.high(node, axis));
      if (!held) sum.add(-it.value() * place.low(node, axis));
    }
    lacking(row) = sum.value();
  }
  return lacking;
}

void take_equations_of_rows(const Displaced& at, Model& model) {
  const Eliminated& solved = model.equations->solved;
  QuadraticProgramme& programme = model.programme;
  VectorXd shift = VectorXd::Zero(model.unknowns.count);
  shift(solved.unknown) = VectorXd(solved.right * lacking_at(at, model));
  programme.initial_gap -= programme.A * shift;
  programme.A = on_free_unknowns(programme.A, by_free_unknowns(solved, model.unknowns.count));
}

// Rows are without equations' unknowns already, so that g stays what it is.
void take_equations_of_forces(const Displaced& at, bool tangent, Model& model) {
  const Eliminated& solved = model.equations->solved;
  QuadraticProgramme& programme = model.programme;
  Sparse reduced;
  if (!tangent) {
    reduced = model.equations->bodies;
    reduced.swap(programme.stiffness);
  }
  Taking taking(model);
  taking.take(lacking_at(at, model), factors_at(model.path.histories, model.time), programme.load, programme.initial_gap);
  if (tangent)
    taking.take_matrices();
  else
    reduced.swap(programme.stiffness);
  VectorXd& terms = programme.reached.terms;
  const VectorXd own = terms(solved.unknown);
  terms = by_free_unknowns(solved, terms.size()).cwiseAbs().transpose() * terms;
  terms(solved.unknown) = own;
}

const Sparse& stiffness_of_bodies(const Model& model) {
  return model.equations ? model.equations->bodies : model.programme.stiffness;
}

}  // namespace signorini
