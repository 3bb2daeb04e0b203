// Chapter 2 - The surrogate dual (Xuan & Li 2002, sec. 2.1, eqs. 14-24).
// Run:  make ch02     Reads: nothing     Writes: ch02.results, vertices.md, fig_2_1.csv,
//                                                fig_2_1_path.csv, fig_2_1_best.csv,
//                                                fig_2_1_top.csv, fig_2_2.csv
#include <algorithm>
#include <cmath>

#include "constraint.hpp"
#include "signorini/as_printed/weight_iteration.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/program.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// 1. The rubber block of chapter 1 on a flatter obstacle, with two cells: three candidates.
// [scene]
Scene three_candidates() {
  Scene scene;
  Body& body = scene.bodies[0];
  BlockSpec block;
  block.corner = {-20, 0};
  block.size = {40, 20};
  block.cells_x = 2;
  block.cells_y = 1;
  body.mesh = make_block(block);
  body.material = {/*E [N/mm^2]*/ 10, /*nu*/ 0.3, PlaneState::Strain, /*thickness [mm]*/ 1};
  body.supports = {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -1.0)};
  scene.contacts = {{{"bottom"}, disc({5, -400}, 400)}};
  return scene;
}
// [scene]

struct Block {
  Model model;          // K, p, A, g
  Condensed condensed;  // factor of K, u0, G, d
  Solution solution;    // by the solver of chapter 1
  [[nodiscard]] const QuadraticProgramme& programme() const { return model.programme; }
  [[nodiscard]] const ContactProblem& problem() const { return condensed.problem; }
  [[nodiscard]] double free_energy() const {  // -1/2 p.K^-1 p, the constant of (24)
    return lagrangian(programme(), condensed.free_displacement, VectorXd::Zero(3));
  }
  [[nodiscard]] VectorXd pushed_back(const VectorXd& force) const {  // (22)
    return condensed.factor.solve(programme().load - programme().A.transpose() * force);
  }
};

Block solve_block() {
  const Scene scene = three_candidates();
  Ledger ledger;
  Model model = build(scene, ledger);
  Condensed condensed = condense(model, ledger);
  Solution solution = solve(model, condensed, scene.solver, ledger);
  require_solved(solution, "the block");
  return {std::move(model), std::move(condensed), std::move(solution)};
}

VectorXd random_weights(Random& random) {  // on the simplex
  Vector3d weights;
  for (double& weight : weights) weight = random.uniform(0, 1);
  return weights / weights.sum();
}

// A number that must vanish but for rounding.
void must_vanish(Results& results, const std::string& key, double value, double size) {
  if (!(value <= 1e-12 * size)) throw NotSolved(key + " is larger than rounding");
  results.add(key, value / size, "-", Repeats::No);
}

// 2. Weak duality (14)-(16): no weighted gap holds more energy than any admissible shape.
// [weak]
void weak_duality(const Block& block, Results& results) {
  const QuadraticProgramme& programme = block.programme();
  Random random(1);
  double highest_dual = -1e300;
  double lowest_primal = 1e300;
  for (int sample = 0; sample < 1000; ++sample) {
    const VectorXd weights = random_weights(random);
    const VectorXd force = random.uniform(0, 40) * weights;  // eta xi [N]
    highest_dual = std::max(highest_dual, lagrangian(programme, block.pushed_back(force), force));
    VectorXd w = block.solution.refined.displacement;
    for (double& entry : w) entry += random.uniform(-0.5, 0.5);  // [mm]
    const VectorXd overlap = (programme.A * w - programme.initial_gap).cwiseMax(0.0);
    w -= programme.A.transpose() * overlap;  // one unit normal per row of A: admissible now
    lowest_primal = std::min(lowest_primal, lagrangian(programme, w, VectorXd::Zero(3)));
  }
  // [weak]
  if (highest_dual >= lowest_primal) throw NotSolved("weak duality fails");
  results.add("highest_dual", highest_dual, "N*mm");
  results.add("lowest_primal", lowest_primal, "N*mm");
}

// 3. Strong duality and the conditions (17), (19), (21) at the solution.
// [strong]
void strong_duality(const Block& block, Results& results) {
  const VectorXd& force = block.solution.contact.force;
  const VectorXd weights = force / force.sum();
  const double eta = total_contact_force(block.problem(), weights);  // (23)
  const double s = surrogate_dual_value(block.problem(), weights);   // (24)
  const VectorXd u = block.pushed_back(eta * weights);               // (21), (22)
  const VectorXd overlap = block.programme().A * u - block.programme().initial_gap;
  const double energy = lagrangian(block.programme(), u, VectorXd::Zero(3));
  must_vanish(results, "total_force_error", std::abs(eta - force.sum()), eta);
  must_vanish(results, "weighted_gap", std::abs(weights.dot(overlap)), 1);  // (17), (19) [mm]
  must_vanish(results, "duality_gap", std::abs(s + block.free_energy() - energy), s);
  // [strong]
  results.add("energy", energy, "N*mm");
  results.add("free_energy", block.free_energy(), "N*mm");
  results.add("best_s", s, "N*mm");
  results.add("total_contact_force", eta, "N");
  for (Index i = 0; i < 3; ++i) results.add(text("weight_", i + 1), weights(i), "-");
}

// 4. (22)-(24) and the gradient at random weights, against the Lagrangian and central differences.
// [formulas]
void check_formulas(const Block& block, Results& results) {
  Random random(2);
  double saddle_error = 0;
  double gradient_error = 0;
  for (int sample = 0; sample < 100; ++sample) {
    const VectorXd weights = random_weights(random);
    const VectorXd force = total_contact_force(block.problem(), weights) * weights;
    const double s = surrogate_dual_value(block.problem(), weights);
    const double saddle = lagrangian(block.programme(), block.pushed_back(force), force);
    saddle_error = std::max(saddle_error, std::abs(s + block.free_energy() - saddle));
    const VectorXd gradient = surrogate_dual_gradient(block.problem(), weights);
    for (Index i = 0; i < 3; ++i) {
      const VectorXd h = 1e-5 * VectorXd::Unit(3, i);
      const double rise = surrogate_dual_value(block.problem(), weights + h) -
                          surrogate_dual_value(block.problem(), weights - h);
      gradient_error = std::max(gradient_error, std::abs(rise / 2e-5 - gradient(i)));
    }
  }
  // [formulas]
  must_vanish(results, "saddle_error", saddle_error, results.value("best_s"));
  if (gradient_error > 1e-6 * results.value("best_s")) throw NotSolved("the gradient is wrong");
  results.add("gradient_error", gradient_error, "N*mm", Repeats::No);
}

// 5. The landscape s over the triangle of weights, and the way of the line search of chapter 3.
void landscape(const ProgramOptions& run, const Block& block, Results& results) {
  const auto place = [](const VectorXd& xi) {
    return Vector2d(xi(1) + xi(2) / 2, std::sqrt(0.75) * xi(2));
  };
  Table grid({"x", "y", "s"});
  for (int row = 0; row <= 60; ++row) {  // from the side 1-2 up to vertex 3
    for (int column = 0; column <= 60; ++column) {
      const double a = row / 60.0;
      const double b = column / 60.0;
      const Vector3d xi((1 - a) * (1 - b), (1 - a) * b, a);
      grid.row({place(xi).x(), place(xi).y(), surrogate_dual_value(block.problem(), xi)});
    }
    grid.blank_line();
  }
  write_file(run.out / "fig_2_1.csv", grid.csv());
  Table path({"x", "y", "s"});
  WeightIteration line_search(block.problem(), WeightRule::LineSearch);
  for (int k = 0; k <= 20; ++k, (void)line_search.step())
    path.row(
        {place(line_search.weights()).x(), place(line_search.weights()).y(), line_search.value()});
  write_file(run.out / "fig_2_1_path.csv", path.csv());
  results.add("path_share_20", line_search.value() / results.value("best_s"), "-");
  Table best({"x", "y"});
  const Vector2d top = place(block.solution.contact.force / block.solution.contact.force.sum());
  best.row({top.x(), top.y()});
  write_file(run.out / "fig_2_1_best.csv", best.csv());
  Table vertices({"all weight on", "gap without contact [mm]", "$`\\eta`$ [N]", "$`s`$ [N mm]"});
  const auto row = [&](const char* name, const VectorXd& xi) {
    vertices.row({name, number(block.problem().free_gap.dot(xi), "%.3f"),
                  number(total_contact_force(block.problem(), xi), "%.3f"),
                  number(surrogate_dual_value(block.problem(), xi), "%.3f")});
  };
  row("left", Vector3d(1, 0, 0));
  row("middle", Vector3d(0, 1, 0));
  row("right", Vector3d(0, 0, 1));
  row("each a third", start_weights(block.problem()));
  row("as the forces", block.solution.contact.force / block.solution.contact.force.sum());
  write_file(run.out / "vertices.md", vertices.markdown());
}

// The part of figure 2.1 around the maximum, on a finer grid.
void top_of_the_hill(const ProgramOptions& run, const Block& block) {
  Table grid({"x", "y", "s"});
  for (int row = 0; row <= 52; ++row) {
    for (int column = 0; column <= 72; ++column) {
      const Vector2d at(0.66 + column / 400.0, 0.13 + row / 400.0);
      const double third = at.y() / std::sqrt(0.75);
      const Vector3d xi(1 - at.x() - third / 2, at.x() - third / 2, third);
      grid.row({at.x(), at.y(), surrogate_dual_value(block.problem(), xi)});
    }
    grid.blank_line();
  }
  write_file(run.out / "fig_2_1_top.csv", grid.csv());
}

// 7. Grazing contact: a free gap of exactly zero.
void grazing_contact(const Block& block, Results& results) {
  const ContactProblem grazing{block.problem().compliance, Vector3d(0, 0.2, 0.3)};
  results.add("grazing_force", total_contact_force(grazing, Vector3d(1, 0, 0)), "N");
}

Status chapter(const ProgramOptions& run) {
  Results results("ch02");
  const Block block = solve_block();
  weak_duality(block, results);
  strong_duality(block, results);
  check_formulas(block, results);
  landscape(run, block, results);
  top_of_the_hill(run, block);
  ch02::constraint_on_weights(run.out, results);  // 6. The condition eta >= 0 of (24).
  grazing_contact(block, results);
  results.headline("best_s", results.value("energy") - results.value("free_energy"),
                   "energy of the solution above that without contact");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch02", "The surrogate dual", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
