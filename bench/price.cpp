// What contact costs: each phase of a solution, over one plain linear solve of the same mesh by our factor and by those of others.
// Run:  make bench     Reads: nothing     Writes: price, phases, exponents, saddle_point and steps, each as .md and .csv
// Without --full on small meshes: a test of this program and of what it judges, not a measurement.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>

#include "addons/steps/steps.hpp"
#include "bench/measure.hpp"
#include "bench/rounds.hpp"
#include "papers/saddle_point_newton.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/scene.hpp"
#include "support/cantilever.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;
using Eigen::Index;

/// The cantilever of chapter 6: ten times longer than high, its whole lower side a candidate.
Scene cantilever(Index cells_y) {
  return signorini_test::cantilever("q4_incompatible", 10 * cells_y, cells_y);
}

/// The same on a rough plane.
Scene rough(Index cells_y) {
  Scene scene = cantilever(cells_y);
  scene.contacts[0].friction = Friction{0.3, 0};
  return scene;
}

/// Scenes that differ in size.
struct Family {
  std::string name;
  std::function<Scene(Index)> scene;
  std::vector<Index> sizes;  // rising
};

std::vector<Family> families(bool full) {
  const auto square = [](Index cells) { return pressed_block(cells, cells); };
  const auto cylinder = [](Index part) { return hertz(46 * part, 34 * part, 44 * part - 1); };
  const auto few_close = [](Index cells) { return pressed_block(1999, cells, 0.4, 0.001); };
  if (!full)
    return {
        {"block", square, {12, 20}},
        {"cantilever", cantilever, {3, 5}},
        {"with friction", rough, {3, 5}},
        {"hertz", [](Index part) { return hertz(8 * part, 6 * part, 8 * part - 1); }, {1, 2}},
        {"few close", [](Index cells) { return pressed_block(99, cells, 0.4, 0.001); }, {2, 4}}};
  return {{"block", square, {99, 199, 299, 706}},
          {"cantilever", cantilever, {31, 63, 94, 223}},
          {"with friction", rough, {31, 63, 94, 223}},
          {"hertz", cylinder, {1, 2, 3, 7}},
          {"few close", few_close, {4, 19, 44, 249}}};
}

/// \return exponent of seconds against unknowns, fitted over all sizes, "-" where one was left out
std::string exponent(const std::vector<Cost>& costs, const std::string& way) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Cost& cost : costs) {
    if (cost.times.count(way) == 0) return "-";
    const double size = std::log(static_cast<double>(cost.unknowns));
    const double seconds = std::log(median(cost.times.at(way)));
    x += size;
    y += seconds;
    xx += size * size;
    xy += size * seconds;
  }
  const double n = static_cast<double>(costs.size());
  return number((n * xy - x * y) / (n * xx - x * x), "%.2f");
}

const std::vector<std::string> phases = {
    "plan",         "assembly", "factor/ordering", "factor/symbolic", "factor/numeric",
    "condensation", "contact",  "refinement",      "recovery"};

struct Tables {
  Table price{{"scene", "unknowns", "pairs", "closed", "steps", "solves", "plain s",
               "condensed / plain", "contact / plain", "set-up / plain", "contact / SimplicialLLT",
               "plain / CHOLMOD", "contact / CHOLMOD", "certificate"}};
  Table phases{{"scene", "unknowns", "plan", "assembly", "tree", "symbolic", "numeric",
                "condensation", "contact", "refinement", "recovery", "fill", "work", "MB"}};
  Table exponents{{"scene", "plain", "contact", "SimplicialLLT", "CHOLMOD"}};
};

void note(const std::string& name, const Cost& cost, Tables& tables) {
  const Solution& solution = cost.first;
  tables.price.row({name, text(cost.unknowns), text(solution.contact.force.size()),
                    text(solution.contact.active().size()), text(solution.contact.report.iterations),
                    text(solution.ledger.counted("refinement", "solves")),
                    number(median(cost.times.at("plain")), "%.3f"),
                    ratio(cost, "condense", "plain"), ratio(cost, "whole", "plain"),
                    ratio(cost, "set-up", "plain"), ratio(cost, "whole", "SimplicialLLT"),
                    ratio(cost, "plain", "CHOLMOD"), ratio(cost, "whole", "CHOLMOD"),
                    number(solution.certificate.worst(), "%.0e")});
  std::vector<std::string> row = {name, text(cost.unknowns)};
  for (const std::string& phase : phases)
    row.push_back(number(median(cost.times.at(phase)), "%.4f"));
  row.insert(row.end(), {number(cost.fill / 1e6, "%.2f"), number(cost.operations / 1e9, "%.2f"),
                         number(cost.megabytes, "%.0f")});
  tables.phases.row(std::move(row));
}

/// \return whether all is as it should be
bool price(const Family& family, const std::vector<int>& rounds, Tables& tables) {
  std::vector<Cost> costs;
  bool good = true;
  for (std::size_t k = 0; k < family.sizes.size(); ++k) {
    costs.push_back(measure(family.scene(family.sizes[k]), rounds[k],
                            costs.empty() ? nullptr : &costs.back(), yardsticks()));
    note(family.name, costs.back(), tables);
    good = good && costs.back().good;
  }
  tables.exponents.row({family.name, exponent(costs, "plain"), exponent(costs, "whole"),
                        exponent(costs, "SimplicialLLT"), exponent(costs, "CHOLMOD")});
  return good;
}

/// The condensed method and the uncondensed Newton method on the same two bodies.
/// \param least_ratio  how many times faster the first must be
/// \param most_steps   of either; finer meshes take more
/// \return whether both end in so few steps at the same forces, and the first is as fast as asked
bool saddle_point(const Scene& scene, double least_ratio, Index most_steps, Table& table) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  const double start = processor_seconds();
  const Condensed condensed = condense(model, ledger);
  const Solution ours = solve(model, condensed, ledger);
  const double middle = processor_seconds();
  SaddlePointOptions options;  // at rest nothing holds the disc: an equal share of the load
  options.start_force = ours.contact.force.sum() * model.pairs.weight / model.pairs.weight.sum();
  const SaddlePointSolution paper = saddle_point_newton(model.programme, options);
  const double end = processor_seconds();
  const double ratio = (end - middle) / (middle - start);
  const double difference =
      (paper.solution.force - ours.contact.force).norm() / ours.contact.force.norm();
  table.row({text(model.unknowns.number.rows()), number(middle - start, "%.3f"),
             text(ours.contact.report.iterations), number(end - middle, "%.3f"),
             text(paper.report.iterations), number(ratio, "%.1f"), number(difference, "%.0e")});
  return is_certified(ours) && paper.report.status == SolveStatus::Solved && difference <= 1e-11 &&
         std::max(ours.contact.report.iterations, paper.report.iterations) <= most_steps &&
         ratio >= least_ratio;
}

/// A path of the cantilever whose load grows in equal steps, one that ends with the first or all.
struct Walk {
  double seconds = 0;
  Index solves = 0;
  Index closed = 0;
  bool certified = true;
};

Walk walk(Index cells_y, double friction, int steps, int last) {
  Scene scene = cantilever(cells_y);
  if (friction > 0) scene.contacts[0].friction = Friction{friction, 0};
  scene.bodies[0].loads.edges[0].history = "press";
  scene.path = Path{equal_steps(steps), {proportional("press")}};
  scene.path->times.resize(static_cast<std::size_t>(last));
  Walk walk;
  const double start = processor_seconds();
  const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
    walk.solves += step.solution.ledger.counted("refinement", "solves");
    walk.closed = static_cast<Index>(step.solution.contact.active().size());
    walk.certified = walk.certified && is_certified(step.solution);
  });
  walk.seconds = processor_seconds() - start;
  walk.certified = walk.certified && end.status == SolveStatus::Solved;
  return walk;
}

/// \param most  how many times the first step all of them may take
/// \return whether all steps are certified, and take no more than that
bool load_steps(Index cells_y, int steps, int rounds, double most, Table& table) {
  bool good = true;
  for (const double friction : {0.0, 0.3}) {
    std::vector<double> first, all, ratios;
    Walk last;
    for (int round = 0; round < rounds; ++round) {
      const Walk one = walk(cells_y, friction, steps, 1);
      last = walk(cells_y, friction, steps, steps);
      first.push_back(one.seconds);
      all.push_back(last.seconds);
      ratios.push_back(last.seconds / one.seconds);
      good = good && one.certified && last.certified;
    }
    good = good && median(ratios) <= most;
    table.row({text(20 * cells_y * (cells_y + 1)), number(friction, "%.1f"), text(steps),
               text(last.closed), number(median(first), "%.3f"), number(median(all), "%.3f"),
               number(median(ratios), "%.1f"),
               number(static_cast<double>(last.solves) / steps, "%.1f")});
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    Tables tables;
    const std::vector<int> rounds =
        options.full ? std::vector<int>{9, 5, 3, 5} : std::vector<int>{2, 2};
    bool good = true;
    for (const Family& family : families(options.full))
      good = price(family, rounds, tables) && good;
    Table methods({"nodes", "condensed s", "steps", "uncondensed s", "factors", "ratio",
                   "difference of forces"});
    const bool equal = options.full ? saddle_point(hertz(64, 48, 60), 10, 15, methods)
                                    : saddle_point(hertz(16, 12, 15), 0, 10, methods);
    Table paths({"unknowns", "friction", "steps", "closed at the end", "first step s", "all s",
                 "all / first", "solves of a step"});
    const double any = std::numeric_limits<double>::infinity();
    bool cheap = options.full ? load_steps(20, 100, 5, 15, paths) : load_steps(3, 5, 1, any, paths);
    if (options.full) cheap = load_steps(40, 100, 5, 15, paths) && cheap;
    std::cout
        << "Medians of processor seconds, all ways in turn. Plain: tree, factor, one solve. "
           "Condensed: tree, factor,\ncompliance. Contact: all from K, p, A, g to the certificate. "
           "Set-up: plan and assembly. SimplicialLLT of Eigen and\nCHOLMOD, which order by minimum "
           "degree, are not repeated beyond 5 s; - where they are not installed or,\nby the size "
           "before, would need more than 45 s. Dense kernels of CHOLMOD: "
        << dense_kernels() << ".\n";
    write_table(options.out, "price", tables.price);
    std::cout << "\nPhases in seconds; entries of the factor in millions, operations in 1e9, "
                 "largest memory.\n";
    write_table(options.out, "phases", tables.phases);
    std::cout << "\nExponents of seconds against unknowns, over all sizes.\n";
    write_table(options.out, "exponents", tables.exponents);
    std::cout << "\nThe cylinder on a plate, condensed and not: at least 10 times faster where "
                 "there are 20 000 nodes,\nthe same forces to 1e-11.\n";
    write_table(options.out, "saddle_point", methods);
    std::cout << "\nThe cantilever in load steps, from the scene on: all of them, and the first alone.\n";
    write_table(options.out, "steps", paths);
    std::cout << "\ncertified in few steps, to the same bits each time: " << (good ? "yes" : "NO")
              << "; same forces, few steps, as fast as asked: " << (equal ? "yes" : "NO")
              << "; load steps certified, and cheap beside the first: " << (cheap ? "yes" : "NO") << '\n';
    return good && equal && cheap ? SolveStatus::Solved : SolveStatus::Breakdown;
  };
  return run_program("price", "What contact costs over one plain linear solve; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}
