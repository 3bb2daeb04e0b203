// Chapter 8 - Contact as complementarity (Lin et al., secs. 2.1 and 2.2, eqs. 1-19).
// Run:  make ch08     Reads: nothing     Writes: ch08.results, functions.md, newton.md, path.md,
//       split.md, methods.md, units.md, fig_8_1.csv, fig_8_2.csv, fig_8_3.csv
#include <algorithm>
#include <cmath>

#include "functions.hpp"
#include "one_pair.hpp"
#include "problems.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/solvers.hpp"

namespace {

using namespace signorini;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

std::string small(double x) { return x < 1e-12 ? "below 1e-12" : number(x, "%.0e"); }

// 1. What acts on a face of the source, and whether Coulomb's law lets it stick.
/// \PaperEq{LinEtAl, 5} to \PaperEq{LinEtAl, 10}
// [face]
void face(Results& results) {
  const double mu = 0.3, cohesion = 0;
  const Traction on = traction(Vector3d(-2, -6, 1), Vector2d(0.6, -0.8));  // sigma [MPa], n
  const double bound = cohesion - mu * on.normal;                          // (6)
  const bool sticks = on.tangential.norm() < bound;                        // (9), else (10)
  // [face]
  results.add("normal_stress", on.normal, "MPa");
  results.add("pressure", -on.normal, "MPa");
  results.add("shear_stress", on.tangential.norm(), "MPa");
  results.add("bound", bound, "MPa");
  results.add("sticks", sticks ? 1 : 0, "-");
}

// 2. Complementarity functions: zero where they should be, slopes, level lines.
void compare_functions(const ProgramOptions& run) {
  Table table({"", "both 1", "-1 and 1", "both -1", "from (−1, −1) to (−2, −2)", "slope at (2, 0)",
               "slope at (0, 0)"});
  const auto pair = [](const ComplementaritySlope& s) {
    return text("(", number(s.a + 0.0, "%.3g"), ", ", number(s.b + 0.0, "%.3g"), ")");
  };
  for (const ComplementarityFunction& phi : functions) {
    require_zeros(phi);
    table.row({phi.name, number(phi.value(1, 1), "%.3f"), number(phi.value(-1, 1), "%.3f"),
               number(phi.value(-1, -1), "%.3f"),
               text("times ", phi.value(-2, -2) / phi.value(-1, -1)), pair(phi.slope(2, 0)),
               pair(phi.slope(0, 0))});
  }
  write_file(run.out / "functions.md", table.markdown());
  Table levels({"a", "b", "phi"});
  for (int i = -20; i <= 20; ++i) {
    for (int j = -20; j <= 20; ++j)
      levels.row({0.1 * i, 0.1 * j, fischer_burmeister(0.1 * i, 0.1 * j)});
    levels.blank_line();
  }
  write_file(run.out / "fig_8_1.csv", levels.csv());
}

// 3. Newton's method with each of them, from no force.
/// \PaperEq{LinEtAl, 11}, \PaperEq{LinEtAl, 12}
void compare_newton(const ProgramOptions& run, Results& results) {
  Table table({"", "one pair", "touching", "in a circle", "string", "half-plane"});
  for (const ComplementarityFunction& phi : functions) {
    std::vector<std::string> row = {phi.name};
    for (const Named& on : problems) {
      const NewtonRun way = newton(on.problem, phi, 0 * on.problem.free_gap, {1e-10, 0});
      row.push_back(way.ended ? std::to_string(way.steps()) : "-");
    }
    table.row(row);
  }
  std::vector<std::string> row = {"the library's method"};
  for (const Named& on : problems) {
    const ContactState state = fischer_burmeister(on.problem);
    if (state.report.status != Status::Solved) throw NotSolved(text(on.name, ": not solved"));
    row.push_back(std::to_string(state.report.iterations));
  }
  table.row(row);
  write_file(run.out / "newton.md", table.markdown());
  const NewtonRun touch = newton(problems[1].problem, functions.back(), Vector2d(0, 0), {1e-10, 0});
  results.add("smooth_residual", touch.residuals.back(), "-");
  results.add("smooth_error", (touch.forces.back() - Vector2d(1, 0)).norm(), "-");

  Table path({"step", "Fischer-Burmeister", "minimum", "between the two", "penalised", "smooth"});
  std::vector<NewtonRun> ways;
  for (const ComplementarityFunction& phi : functions)
    ways.push_back(newton(problems[0].problem, phi, VectorXd::Constant(1, 4), {1e-10, 0}));
  for (std::size_t k = 0; k <= 6; ++k) {
    std::vector<std::string> cells = {std::to_string(k)};
    for (const NewtonRun& way : ways)
      cells.push_back(k <= way.steps() ? number(way.forces[k](0), "%.6f") : "");
    path.row(cells);
  }
  write_file(run.out / "path.md", path.markdown());
}

// 4. Friction of one pair by the split, from two starts, and by one equation.
/// \PaperEq{LinEtAl, 13} to \PaperEq{LinEtAl, 19}
void friction(const ProgramOptions& run, Results& results) {
  Table table({"pair", "start u⁺ = u⁻", "steps", "gap", "normal force", "friction", "u⁺", "u⁻",
               "smallest singular value", "of one equation"});
  const auto cell = [](double x) { return number(std::abs(x) < 1e-9 ? 0 : x, "%.3f"); };
  for (const NamedPair& on : one_pairs)
    for (const double parts : {0.0, 1.0}) {
      const End end = solved(split, on.pair, Vector4d(1, 0, parts, parts));
      const End one = solved(one_equation, on.pair, Vector2d(1, 0));
      if ((end.x.head(2) - one.x).norm() > 1e-10) throw NotSolved(text(on.name, ": two answers"));
      table.row({on.name, number(parts), std::to_string(end.steps),
                 cell(on.pair.free_gap + end.x(0)), cell(end.x(0)), cell(end.x(1)), cell(end.x(2)),
                 cell(end.x(3)), cell(end.smallest), cell(one.smallest)});
    }
  write_file(run.out / "split.md", table.markdown());
  const OnePair open = one_pairs[3].pair;
  results.add("free_part_1", solved(split, open, Vector4d(1, 0, 1, 1)).x(3), "-");
  results.add("free_part_2", solved(split, open, Vector4d(1, 0, 2, 2)).x(3), "-", Repeats::No);
  const OnePair lifted = one_pairs[4].pair;
  results.add("lifted_gap", lifted.free_gap, "-");
  results.add("lifted_friction", solved(split, lifted, Vector4d(1, 0, 0, 0)).x(1), "-");
  Table dots({"free_slip", "slip", "friction"});
  for (const double s : {-1.5, -1.1, -0.4, 0.0, 0.4, 1.1, 1.5}) {
    const VectorXd x = solved(split, {-1, s, 0.5, 0.2}, Vector4d(1, 0, 0, 0)).x;
    dots.row({s, x(2) - x(3), x(1)});
  }
  write_file(run.out / "fig_8_2.csv", dots.csv());
}

// 5. The library's methods for friction, on the lifted pair and on 40 pairs, of which many are open.
void compare_friction(const ProgramOptions& run, Results& results) {
  const auto one = [](double x) { return VectorXd::Constant(1, x); };
  const OnePair& lifted = one_pairs.back().pair;
  const std::vector<ContactProblem> all = {
      {Eigen::MatrixXd::Identity(2, 2), one(lifted.free_gap), one(lifted.free_slip),
       law_of_all(one(lifted.mu), one(lifted.cohesion))},
      sheared(0.02),
      sheared(0.05),
      sheared(0.1)};
  Table table({"", "open, cohesion", "shift 0.02", "shift 0.05", "shift 0.1"});
  std::vector<std::string> counts = {"open, stick, slide"};
  for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister",
                           "friction_split", "friction_split_literal"}) {
    const Solver& solver = find_solver(name);
    std::vector<std::string> row = {name};
    for (const ContactProblem& problem : all) {
      const ContactState state = solver.solve(problem, {});
      const bool solved = state.report.status == Status::Solved;
      row.push_back(solved ? std::to_string(state.report.iterations)
                           : to_string(state.report.status));
      if (counts.size() > all.size()) continue;  // the first member is enough
      const auto of = [&](Motion s) {
        return std::count(state.motion.begin(), state.motion.end(), s);
      };
      counts.push_back(text(of(Motion::Open), ", ", of(Motion::Stick), ", ",
                            of(Motion::Forward) + of(Motion::Backward)));
      results.add(text("open_pairs_", counts.size() - 1), static_cast<double>(of(Motion::Open)),
                  "-");
    }
    table.row(row);
  }
  table.row(counts);
  write_file(run.out / "methods.md", table.markdown());
}

// 6. Units: the same cylinder in lengths and stresses of other sizes.
// [units]
struct Units {
  const char* name;
  double length, force;  // a mm and a N are so many of them
};
const std::vector<Units> systems = {{"mm, MPa", 1, 1},      {"mm, GPa", 1, 1e-3},
                                    {"m, Pa", 1e-3, 1},     {"m, kPa", 1e-3, 1e-3},
                                    {"m, MPa", 1e-3, 1e-6}, {"m, GPa", 1e-3, 1e-9}};

ContactProblem measured_in(const Units& u, const ContactProblem& problem) {
  return {problem.compliance * (u.length / u.force), problem.free_gap * u.length};
}

double reach_of(const ContactProblem& problem) {  // the gap that forces 1 everywhere make
  return problem.compliance.cwiseAbs().rowwise().sum().maxCoeff();
}
// [units]

void units(const ProgramOptions& run, Results& results) {
  const VectorXd exact = find_solver("quasi_active_set").solve(pressed_cylinder(), {}).force;
  const VectorXd none = VectorXd::Zero(exact.size());
  Table table({"units", "largest overlap", "largest force", "steps to 1e-8", "error of the forces",
               "steps to 1e-8 of the first", "their error", "steps, scaled", "their error"});
  Table figure({"step", "residual", "error"});
  Eigen::Vector3d worst(0, 0, 0);
  for (const Units& u : systems) {
    const ContactProblem problem = measured_in(u, pressed_cylinder());
    const NewtonRun ways[] = {newton(problem, functions[0], none, {1e-8, 0}),
                              newton(problem, functions[0], none, {0, 1e-8}),
                              newton(problem, functions[0], none, {0, 1e-8}, reach_of(problem))};
    const auto error = [&](const VectorXd& force) {
      return (force / u.force - exact).cwiseAbs().maxCoeff() / exact.maxCoeff();
    };
    std::vector<std::string> row = {u.name, number(-problem.free_gap.minCoeff(), "%.1e"),
                                    number(u.force * exact.maxCoeff(), "%.1e")};
    for (int k = 0; k < 3; ++k) {
      row.push_back(std::to_string(ways[k].steps()));
      row.push_back(small(error(ways[k].forces.back())));
      worst(k) = std::max(worst(k), error(ways[k].forces.back()));
    }
    table.row(row);
    if (&u == &systems.back())
      results.add("largest_force", ways[2].forces.back().maxCoeff() / u.force, "N");
    if (&u != &systems.front() && &u != &systems.back() && &u != &systems[4]) continue;
    for (const double reach : {1.0, reach_of(problem)}) {
      const NewtonRun way = newton(problem, functions[0], none, {0, 1e-12}, reach);
      for (std::size_t k = 0; k <= way.steps(); ++k)
        figure.row({static_cast<double>(k), way.residuals[k], error(way.forces[k])});
      figure.blank_line();
    }
  }
  write_file(run.out / "units.md", table.markdown());
  write_file(run.out / "fig_8_3.csv", figure.csv("rel 1e-3 abs 1e-9"));
  results.headline("largest_force", exact.maxCoeff(), "the same in mm and N, by an active set");
  results.add("worst_error", worst(0), "-");
  results.add("worst_error_relative_test", worst(1), "-");
  results.add("worst_error_scaled", worst(2), "-", Repeats::No);
}

Status chapter(const ProgramOptions& run) {
  Results results("ch08");
  face(results);
  compare_functions(run);
  compare_newton(run, results);
  friction(run, results);
  compare_friction(run, results);
  units(run, results);
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch08", "Contact as complementarity", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
