// What others need for the same: Hertz's contact by whole programs, random programmes of known solution, contact of a body.
// Run:  make peers     Reads: nothing     Writes: hertz.md, hertz.csv, linear.md, peers.md, peers.csv, contact.md
// Without --full small problems, and of the solvers of programmes only ours: a test of this program, not a measurement.
#include <iostream>
#include <map>

#include "addons/frontal/frontal_factor.hpp"
#include "addons/programme/dense_programme.hpp"
#include "bench/measure.hpp"
#include "bench/peers/hertz_comparison.hpp"
#include "bench/peers/linear_comparison.hpp"
#include "bench/peers/peer.hpp"
#include "bench/peers/turns.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;
using Eigen::Index;

/// Programmes of one size.
struct Size {
  Index n;
  Index m;
  int seeds;   // programmes
  int rounds;  // in which every solver has its turn
  /// What dense elimination costs, to foresee the next size from the last.
  [[nodiscard]] double work() const {
    return static_cast<double>(n) * static_cast<double>(m) * static_cast<double>(n + m);
  }
};

std::vector<Size> sizes(bool full) {
  if (!full) return {{10, 5, 3, 1}, {10, 10, 3, 1}, {20, 10, 3, 1}};
  std::vector<Size> all;
  for (const Index n : {10, 20, 50})  // table 1 of the paper
    for (const Index m : {n / 2, n, 2 * n, 4 * n}) all.push_back({n, m, 10, 15});
  all.insert(all.end(), {{200, 200, 3, 5}, {200, 800, 3, 5}, {500, 500, 1, 3}, {1000, 4000, 1, 3}});
  return all;
}

/// What a solver did with all programmes of one size.
struct Tally {
  std::vector<double> seconds;  // one per programme, the median of its rounds
  std::vector<double> condensation;
  std::vector<double> share;  // our seconds over these
  std::vector<double> iterations;
  double certificate = 0;  // the worst of those it calls solved
  int failures = 0;
};

/// A first solve, which is certified, and how often to repeat it for times that a clock can measure.
int first_solve(const Peer& peer, const DenseProgramme& programme, Tally& tally, Run& run) {
  run = peer.solve(programme, 1);
  tally.iterations.push_back(static_cast<double>(run.iterations));
  if (run.failure.empty())
    tally.certificate = std::max(tally.certificate, certify(programme, run.solution).worst());
  else if (++tally.failures == 1)
    std::cout << peer.name << " at (" << programme.load.size() << ", "
              << programme.initial_gap.size() << "): " << run.failure << std::endl;
  return std::max(1, static_cast<int>(std::min(500.0, 1e-3 / (run.seconds + 1e-9))));
}

void measure(const std::vector<Peer>& peers, const DenseProgramme& programme, int rounds,
             std::vector<Tally>& tallies) {
  std::vector<int> calls(peers.size());
  const auto ask = [&](std::size_t i, bool first, bool&) {
    Run run;
    if (first)
      calls[i] = first_solve(peers[i], programme, tallies[i], run);
    else
      run = peers[i].solve(programme, calls[i]);
    return Turn{run.seconds, run.condensation};
  };
  const std::vector<Turn> turns = in_turn(peers.size(), rounds, ask);
  for (std::size_t i = 0; i < peers.size(); ++i) {
    tallies[i].seconds.push_back(turns[i].seconds);
    tallies[i].condensation.push_back(turns[i].also);
    tallies[i].share.push_back(turns[0].seconds / turns[i].seconds);
  }
}

/// What our solvers call solved must be certified; what others return is only shown.
bool compare(const std::vector<Peer>& all, std::size_t ours, bool full, Table& table) {
  std::map<std::string, double> speed;  // seconds per unit of work at the last size
  bool certified = true;
  for (const Size& size : sizes(full)) {
    std::vector<Peer> peers;
    for (const Peer& peer : all) {
      if (speed[peer.name] * size.work() <= longest_turn)
        peers.push_back(peer);
      else
        std::cout << peer.name << ": left out at (" << size.n << ", " << size.m
                  << "), where it would take about "
                  << number(speed[peer.name] * size.work(), "%.0f") << " s\n";
    }
    std::vector<Tally> tallies(peers.size());
    for (int seed = 1; seed <= size.seeds; ++seed)
      measure(peers, rosen_suzuki(size.n, size.m, static_cast<std::uint64_t>(seed)).programme,
              size.rounds, tallies);
    for (std::size_t i = 0; i < peers.size(); ++i) {
      const Tally& tally = tallies[i];
      speed[peers[i].name] = median(tally.seconds) / size.work();
      if (i < ours) certified = certified && tally.certificate <= 1e-12;
      table.row({text(size.n), text(size.m), peers[i].name,
                 number(1e3 * median(tally.seconds), "%.4g"),
                 number(1e3 * median(tally.condensation), "%.4g"),
                 number(median(tally.share), "%.3f"), number(median(tally.iterations), "%.0f"),
                 tally.failures == size.seeds ? "-" : number(tally.certificate, "%.0e"),
                 text(tally.failures, " of ", size.seeds)});
    }
  }
  return certified;
}

/// Contact of bodies: the small problem against the factorisation of K, which a plain solve needs too.
bool contact(Table& table) {
  bool certified = true;
  for (const Index cells_y : {99, 249}) {
    Ledger ledger;
    const Model model = build(pressed_block(999, cells_y), ledger);
    const Eigen::SparseMatrix<double>& K = model.programme.stiffness;
    const SeparatorTree tree =
        separator_tree(K, unknown_positions(model.bodies[0].mesh, model.unknowns));
    const double factor = mean_seconds(1, [&] { const FrontalFactor alone(K, tree, ledger); });
    const Condensed condensed = condense(model, ledger);
    const Solver& solver = find_solver("quasi_active_set");
    std::vector<double> seconds;
    for (int round = 0; round < 5; ++round)
      seconds.push_back(mean_seconds(1, [&] { (void)solver.solve(condensed.problem, {}); }));
    const Solution solution = solve(model, condensed, solver, ledger);
    certified = certified && solution.contact.report.status == SolveStatus::Solved;
    table.row({text(model.unknowns.count), text(model.programme.A.rows()),
               text(solution.contact.active().size()), number(factor, "%.3f"),
               number(median(seconds), "%.4f"), number(100 * median(seconds) / factor, "%.2f"),
               text(solution.contact.report.iterations),
               number(solution.certificate.worst(), "%.0e")});
  }
  return certified;
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    // First, while this program is small: a child's memory counts from there.
    bool certified =
        compare_hertz(hertz_programs(SIGNORINI_PROGRAM, SIGNORINI_GETFEM_SCRIPT),
                      options.full ? std::vector<HertzSize>{{1, 3}, {2, 3}, {4, 2}, {8, 1}}
                                   : std::vector<HertzSize>{{1, 1}},
                      options.out);
    certified = compare_linear(options.full, options.out) && certified;
    std::vector<Peer> peers = own_solvers();
    const std::size_t ours = peers.size();
    if (options.full) {
      std::vector<Peer> others = {quadprog()};
      for (Peer& peer : siconos()) others.push_back(std::move(peer));
      for (Peer& peer : python_packages(SIGNORINI_PEERS_SCRIPT)) others.push_back(std::move(peer));
      for (Peer& peer : others) {
        if (peer.missing.empty())
          peers.push_back(std::move(peer));
        else
          std::cout << peer.name << ": " << peer.missing << std::endl;
      }
    }
    Table table({"n", "m", "solver", "ms", "condensation ms", "quasi_active_set / it", "iterations",
                 "certificate", "not solved"});
    certified = compare(peers, ours, options.full, table) && certified;
    std::cout << "\nWhole solves from K, p, A, g: medians of processor time. Certificates are the "
                 "worst of "
                 "what is called\nsolved, recomputed here from the same K, p, A, g.\n\n"
              << table.markdown();
    write_file(options.out / "peers.md", table.markdown());
    write_file(options.out / "peers.csv", table.csv());
    if (options.full) {
      Table scenes({"unknowns", "pairs", "closed", "factor s", "contact s", "percent", "iterations",
                    "certificate"});
      certified = contact(scenes) && certified;
      std::cout << "\nA pressed block: quasi_active_set against the factorisation of K.\n\n"
                << scenes.markdown();
      write_file(options.out / "contact.md", scenes.markdown());
    }
    return certified ? SolveStatus::Solved : SolveStatus::Breakdown;
  };
  return run_program("peers", "The same programmes by others' solvers; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}
