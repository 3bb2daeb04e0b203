// What contact costs: everything after assembly, over one plain linear solve of the same mesh.
// Run:  make bench     Reads: nothing     Writes: price.csv, saddle_point.csv (in the folder of --out)
#include <chrono>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "bench/measure.hpp"
#include "signorini/complementarity/saddle_point_newton.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
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

/// Times both ways in turn, so that a change of the machine's speed meets both.
std::string price_line(const std::string& name, const Scene& scene, int runs) {
  Ledger setup;
  const Model model = build(scene, setup);
  const Eigen::SparseMatrix<double> K = grounded_stiffness(model);
  std::vector<double> plain;
  std::vector<double> contact;
  std::vector<double> ratio;
  double fill[2] = {0, 0};
  double operations[2] = {0, 0};
  Solution solution;
  for (int run = 0; run < runs; ++run) {
    Ledger unused;
    auto begin = std::chrono::steady_clock::now();
    {
      const EliminationOrder order = nested_dissection(K, unknown_positions(model));
      const ContactLastFactor factor(K, order, 0, unused);
      const Eigen::VectorXd u = factor.solve(model.programme.load);
      plain.push_back(seconds_since(begin));
      fill[0] = static_cast<double>(factor.nonzeros());
      operations[0] = factor.operations();
      pose(u.allFinite(), "price: the plain solve of ", name, " failed");
    }
    begin = std::chrono::steady_clock::now();
    {
      Ledger ledger;
      const Condensed condensed = condense(model, ledger);
      solution = solve(model, condensed, scene.solver, std::move(ledger));
      contact.push_back(seconds_since(begin));
      fill[1] = static_cast<double>(condensed.factor.nonzeros());
      operations[1] = condensed.factor.operations();
    }
    ratio.push_back(contact.back() / plain.back());
    pose(solution.contact.report.status == Status::Solved, "price: ", name, " was not solved");
  }
  std::cout << std::left << std::setw(11) << name << std::right << std::fixed << std::setw(9)
            << model.unknowns.count << std::setw(6) << model.programme.A.rows()
            << std::setprecision(3) << std::setw(10) << median(plain) << std::setw(10)
            << median(contact) << std::setprecision(2) << std::setw(8) << median(ratio)
            << std::setprecision(2) << std::setw(9) << fill[0] / 1e6 << std::setw(9)
            << fill[1] / 1e6 << std::setw(9) << operations[0] / 1e9 << std::setw(9)
            << operations[1] / 1e9 << std::scientific << std::setprecision(0) << std::setw(8)
            << solution.certificate.worst() << '\n';
  std::ostringstream line;
  line << name << ',' << model.unknowns.count << ',' << model.programme.A.rows() << ','
       << median(plain) << ',' << median(contact) << ',' << median(ratio) << ',' << fill[0] << ','
       << fill[1] << ',' << operations[0] << ',' << operations[1] << '\n';
  return line.str();
}

/// The condensed method and the uncondensed Newton method on the same two bodies.
std::string saddle_point_line(const Scene& scene) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  auto begin = std::chrono::steady_clock::now();
  const Condensed condensed = condense(model, ledger);
  const Solution ours = solve(model, condensed, scene.solver, ledger);
  const double seconds = seconds_since(begin);
  begin = std::chrono::steady_clock::now();
  SaddlePointOptions options;  // at rest nothing holds the disc: an equal share of the load
  options.start_force = ours.contact.force.sum() * model.pairs.weight / model.pairs.weight.sum();
  const SaddlePointSolution paper = saddle_point_newton(model.programme, options);
  const double paper_seconds = seconds_since(begin);
  pose(ours.contact.report.status == Status::Solved && paper.report.status == Status::Solved,
       "price: condensed ", to_string(ours.contact.report.status), ", uncondensed ",
       to_string(paper.report.status));
  const double difference =
      (paper.solution.force - ours.contact.force).norm() / ours.contact.force.norm();
  std::cout << "\nhertz, " << model.unknowns.number.rows() << " nodes: condensed " << std::fixed
            << std::setprecision(2) << seconds << " s, " << ours.contact.report.iterations
            << " steps; uncondensed " << paper_seconds << " s, " << paper.report.iterations
            << " factors; ratio " << paper_seconds / seconds << ", forces differ by "
            << std::scientific << std::setprecision(0) << difference << '\n';
  std::ostringstream line;
  line << "nodes,condensed_s,condensed_steps,uncondensed_s,uncondensed_steps,ratio,difference\n"
       << model.unknowns.number.rows() << ',' << seconds << ',' << ours.contact.report.iterations
       << ',' << paper_seconds << ',' << paper.report.iterations << ',' << paper_seconds / seconds
       << ',' << difference << '\n';
  return line.str();
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    std::cout << "contact: ordering, factor, condensation, solver, refinement, certificate; plain: "
                 "ordering, factor, "
                 "one solve\nmedians of runs in turn; fill in millions of entries, work in 1e9 "
                 "operations\n\n"
              << "scene       unknowns pairs   plain s contact s   ratio   fill 1   fill c   work "
                 "1   work c  certif.\n";
    std::string csv =
        "scene,unknowns,pairs,plain_s,contact_s,ratio,fill_plain,fill_contact,work_plain,work_"
        "contact\n";
    for (const auto& [cells, runs] : {std::pair{99, 15}, {199, 7}, {299, 5}})
      csv += price_line("block", pressed_block(cells, cells), runs);
    for (const auto& [cells, runs] : {std::pair{31, 15}, {63, 7}, {94, 5}})
      csv += price_line("cantilever", cantilever(cells), runs);
    csv += price_line("hertz", hertz(46, 34, 43), 15);
    csv += price_line("hertz", hertz(92, 68, 87), 7);
    csv += price_line("hertz", hertz(138, 102, 131), 5);
    write_file(options.out / "price.csv", csv);
    write_file(options.out / "saddle_point.csv", saddle_point_line(hertz(64, 48, 60)));
    return Status::Solved;
  };
  return run_program("price", "What contact costs over one plain linear solve", SIGNORINI_BENCH_OUT,
                     argc, argv, body);
}
