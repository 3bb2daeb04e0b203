// What contact costs: everything after assembly, over one plain linear solve of the same mesh.
// Run:  make bench     Reads: nothing     Writes: price.md, price.csv, saddle_point.md, saddle_point.csv
// Without --full on small meshes: a test of this program and of what it judges, not a measurement.
#include <algorithm>
#include <chrono>
#include <iostream>

#include "bench/measure.hpp"
#include "signorini/as_printed/saddle_point_newton.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/report/program.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/scene.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;

/// The cantilever of chapter 6: ten times longer than high, its whole lower side a candidate.
Scene cantilever(Eigen::Index cells_y) {
  Scene scene;
  Body& body = scene.bodies[0];
  BlockSpec spec;
  spec.name = "cantilever";
  spec.size = {50, 5};
  spec.cells_x = 10 * cells_y;
  spec.cells_y = cells_y;
  body.mesh = make_block(spec);
  body.material = {2.1e4, 0.29, PlaneState::Stress, 1};
  body.supports = {fixed("left")};
  body.loads.edges = {{"top", 3.6, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, -1}, {0, 1})}};
  return scene;
}

/// Seconds of runs, and the work of one.
struct Cost {
  std::vector<double> seconds;
  double fill = 0;
  double operations = 0;
};

/// Ordering, factor and one solve, as without contact.
void plain_run(const Model& model, const Eigen::SparseMatrix<double>& K, Cost& cost) {
  Ledger unused;
  const auto begin = std::chrono::steady_clock::now();
  const FrontalFactor factor(K, separator_tree(K, unknown_positions(model)), unused);
  const Eigen::VectorXd u = factor.solve(model.programme.load);
  cost.seconds.push_back(seconds_since(begin));
  cost.fill = static_cast<double>(factor.nonzeros());
  cost.operations = factor.operations();
  pose(u.allFinite(), "price: the plain solve failed");
}

/// Ordering, factor, condensation, solver, refinement and certificate.
Solution contact_run(const Model& model, const Scene& scene, Cost& cost) {
  Ledger ledger;
  const auto begin = std::chrono::steady_clock::now();
  const Condensed condensed = condense(model, ledger);
  Solution solution = solve(model, condensed, scene.solver, std::move(ledger));
  cost.seconds.push_back(seconds_since(begin));
  cost.fill = static_cast<double>(condensed.factor.nonzeros());
  cost.operations = condensed.factor.operations();
  return solution;
}

bool is_certified(const Solution& solution) {
  return solution.contact.report.status == Status::Solved && solution.certificate.holds();
}

/// Times both ways in turn, so that a change of the machine's speed meets both.
/// \return whether every run is certified and takes as many steps as the first
bool price(const std::string& name, const Scene& scene, int runs, Table& table) {
  Ledger setup;
  const Model model = build(scene, setup);
  const Eigen::SparseMatrix<double> K = grounded_stiffness(model);
  Cost plain, contact;
  std::vector<double> ratio;
  Solution solution;
  bool good = true;
  for (int run = 0; run < runs; ++run) {
    const Eigen::Index steps = solution.contact.report.iterations;
    plain_run(model, K, plain);
    solution = contact_run(model, scene, contact);
    ratio.push_back(contact.seconds.back() / plain.seconds.back());
    good =
        good && is_certified(solution) && (run == 0 || solution.contact.report.iterations == steps);
  }
  table.row({name, text(model.unknowns.count), text(model.programme.A.rows()),
             number(median(plain.seconds), "%.3f"), number(median(contact.seconds), "%.3f"),
             number(median(ratio), "%.2f"), number(plain.fill / 1e6, "%.2f"),
             number(contact.fill / 1e6, "%.2f"), number(plain.operations / 1e9, "%.2f"),
             number(contact.operations / 1e9, "%.2f"), text(solution.contact.report.iterations),
             number(solution.certificate.worst(), "%.0e")});
  return good;
}

/// The condensed method and the uncondensed Newton method on the same two bodies.
/// \param least_ratio  how many times faster the first must be
/// \param most_steps   of either; finer meshes take more
/// \return whether both end in so few steps at the same forces, and the first is as fast as asked
bool saddle_point(const Scene& scene, double least_ratio, Eigen::Index most_steps, Table& table) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  Cost condensed;
  const Solution ours = contact_run(model, scene, condensed);
  const auto begin = std::chrono::steady_clock::now();
  SaddlePointOptions options;  // at rest nothing holds the disc: an equal share of the load
  options.start_force = ours.contact.force.sum() * model.pairs.weight / model.pairs.weight.sum();
  const SaddlePointSolution paper = saddle_point_newton(model.programme, options);
  const double seconds = seconds_since(begin);
  const double ratio = seconds / condensed.seconds.back();
  const double difference =
      (paper.solution.force - ours.contact.force).norm() / ours.contact.force.norm();
  table.row({text(model.unknowns.number.rows()), number(condensed.seconds.back(), "%.3f"),
             text(ours.contact.report.iterations), number(seconds, "%.3f"),
             text(paper.report.iterations), number(ratio, "%.1f"), number(difference, "%.0e")});
  return is_certified(ours) && paper.report.status == Status::Solved && difference <= 1e-11 &&
         std::max(ours.contact.report.iterations, paper.report.iterations) <= most_steps &&
         ratio >= least_ratio;
}

bool price_all(bool full, Table& table) {
  if (!full) {
    bool good = price("block", pressed_block(20, 20), 2, table);
    good = price("cantilever", cantilever(4), 2, table) && good;
    return price("hertz", hertz(16, 12, 15), 2, table) && good;
  }
  bool good = true;
  for (const auto& [cells, runs] : {std::pair{99, 15}, {199, 7}, {299, 5}})
    good = price("block", pressed_block(cells, cells), runs, table) && good;
  for (const auto& [cells, runs] : {std::pair{31, 15}, {63, 7}, {94, 5}})
    good = price("cantilever", cantilever(cells), runs, table) && good;
  for (const auto& [part, runs] : {std::pair{1, 15}, {2, 7}, {3, 5}})
    good = price("hertz", hertz(46 * part, 34 * part, 44 * part - 1), runs, table) && good;
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    Table prices({"scene", "unknowns", "pairs", "plain s", "contact s", "ratio", "fill plain",
                  "fill contact", "work plain", "work contact", "steps", "certificate"});
    const bool certified = price_all(options.full, prices);
    std::cout << "contact: ordering, factor, condensation, solver, refinement, certificate; plain: "
                 "ordering, factor,\none solve. Medians of runs in turn; fill in millions of "
                 "entries, work in 1e9 operations.\n\n"
              << prices.markdown();
    Table methods({"nodes", "condensed s", "steps", "uncondensed s", "factors", "ratio",
                   "difference of forces"});
    const bool equal = options.full ? saddle_point(hertz(64, 48, 60), 10, 15, methods)
                                    : saddle_point(hertz(16, 12, 15), 0, 10, methods);
    std::cout << "\nThe cylinder on a plate, condensed and not: at least 10 times faster where "
                 "there are 20 000 nodes,\nthe same forces to 1e-11.\n\n"
              << methods.markdown()
              << "\ncertified in as many steps each time: " << (certified ? "yes" : "NO")
              << "; same forces, few steps, as fast as asked: " << (equal ? "yes" : "NO") << '\n';
    write_file(options.out / "price.md", prices.markdown());
    write_file(options.out / "price.csv", prices.csv());
    write_file(options.out / "saddle_point.md", methods.markdown());
    write_file(options.out / "saddle_point.csv", methods.csv());
    return certified && equal ? Status::Solved : Status::Breakdown;
  };
  return run_program("price", "What contact costs over one plain linear solve; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}
