#include "bench/peers/hertz_comparison.hpp"

#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>

#include "bench/peers/child.hpp"
#include "bench/peers/turns.hpp"
#include "closed_form/hertz_fit.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/readings.hpp"
#include "support/folder.hpp"

namespace signorini::bench {
namespace {

/// What one program did on one mesh.
struct Answer {
  Turn turn;  // seconds, and memory [MB]
  RimForces rim;
  double sum = 0, q0 = 0, b = 0, b_fit = 0;  // errors [%]
  std::string failure;
  bool left_out = false;

  /// Of both readings of b the better one: CalculiX spreads its pressures to nodes beyond the contact, which only the
  /// second moment sees.
  [[nodiscard]] double error() const {
    return std::max(std::abs(q0), std::min(std::abs(b), std::abs(b_fit)));
  }
};

HertzCase hertz_case(Eigen::Index part, const std::filesystem::path& folder) {
  HertzCase now;
  now.problem.mesh = finer_hertz_mesh(part);
  now.scene = signorini_test::scene_of(now.problem);
  now.folder = folder;
  return now;
}

/// Errors against the closed form, each in percent of its value.
void judge(const HertzCase& now, Answer& answer) {
  const LineContact theory = now.problem.theory();
  const RimForces& rim = answer.rim;
  const Eigen::VectorXd weight = rim_of(now).weight;
  require_input(static_cast<Eigen::Index>(rim.x.size()) == weight.size(), "it has forces at ",
                rim.x.size(), " nodes, the rim has ", weight.size());
  std::vector<double> pressure(rim.x.size());
  for (std::size_t k = 0; k < pressure.size(); ++k)
    pressure[k] = rim.force[k] / weight(static_cast<Eigen::Index>(k));
  const double sum = std::accumulate(rim.force.begin(), rim.force.end(), 0.0);
  answer.sum = 100 * (2 * sum / theory.force - 1);
  const HertzFit fit = fit_hertz(rim.x, pressure);
  answer.q0 = 100 * (fit.peak_pressure / hertz_peak_pressure(theory) - 1);
  answer.b_fit = 100 * (fit.half_width / hertz_half_width(theory) - 1);
  answer.b = 100 * (half_width_of_forces(rim.x, rim.force) / hertz_half_width(theory) - 1);
}

/// One run of a program, and at the first one what it found.
Turn run(const Program& program, const HertzCase& now, bool first, Answer& answer) {
  const ChildRun child =
      run_child(program.command(now), now.folder, program.key + ".log", longest_turn);
  if (first) answer.failure = child.failure;
  if (first && child.failure.empty()) try {
      answer.rim = program.read(now);
      judge(now, answer);
    } catch (const std::exception& error) {
      answer.failure = error.what();
    }
  return {child.seconds, child.megabytes};
}

/// \return why a program is not asked, or nothing. \param before  on a mesh with fewer nodes by the factor `growth`
std::string reason_to_leave_out(const Program& program, const Answer& before, double growth) {
  if (!program.missing.empty()) return program.missing;
  if (!before.failure.empty()) return "left out";
  const double seconds = before.turn.seconds * std::pow(growth, 1.25);  // as the peers grow
  return seconds > longest_turn ? text("left out: about ", number(seconds, "%.0f"), " s") : "";
}

/// The largest difference of the forces of our program from those found here, over the largest force.
double difference_from_library(const HertzCase& now, const RimForces& rim) {
  const SolvedScene here = signorini::solved(now.scene, "Hertz's contact");
  const BoundaryForces side = boundary_forces(here, now.scene.contacts[0].source);
  double worst = 0;
  for (Eigen::Index k = 0; k < side.weight.size(); ++k) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < rim.x.size(); ++i)
      if (std::abs(rim.x[i] - side.position(k, 0)) < std::abs(rim.x[nearest] - side.position(k, 0)))
        nearest = i;
    worst = std::max(worst, std::abs(rim.force[nearest] - side.force(k, 1)));
  }
  return worst / side.force.col(1).maxCoeff();
}

std::string over(double ours, double theirs) { return number(ours / theirs, "%.3f"); }

void add_rows(const std::vector<Program>& programs, const std::vector<Answer>& answers,
              Eigen::Index nodes, Table& table) {
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const Answer& answer = answers[i];
    if (!programs[i].missing.empty()) continue;
    std::vector<std::string> row = {text(nodes), programs[i].name};
    if (answer.left_out)
      row.insert(row.end(), {"-", "-", "-", "-"});
    else
      row.insert(row.end(), {number(answer.turn.seconds, "%.3g"), number(answer.turn.also, "%.0f"),
                             over(answers[0].turn.seconds, answer.turn.seconds),
                             over(answers[0].turn.also, answer.turn.also)});
    if (answer.failure.empty())
      row.insert(row.end(), {text(answer.rim.iterations), number(answer.sum, "%+.1e"),
                             number(answer.q0, "%+.4f"), number(answer.b, "%+.4f"),
                             number(answer.b_fit, "%+.4f"), ""});
    else
      row.insert(row.end(), {"-", "-", "-", "-", "-", answer.failure});
    table.row(std::move(row));
  }
}

void add_curves(const std::vector<Answer>& answers, Eigen::Index nodes, Table& curves) {
  std::vector<double> row = {static_cast<double>(nodes)};
  for (const Answer& answer : answers) {
    const double there = answer.failure.empty() ? 1 : std::numeric_limits<double>::quiet_NaN();
    row.insert(row.end(),
               {there * answer.turn.seconds, there * answer.turn.also, there * answer.error()});
  }
  curves.row(row);
}

/// Who is best without us, each in its own figure.
void print_verdict(const std::vector<Program>& programs, const std::vector<Answer>& answers,
                   Eigen::Index nodes) {
  const auto best = [&](auto&& figure) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < answers.size(); ++i)
      if (answers[i].failure.empty() && (least == 0 || figure(answers[i]) < figure(answers[least])))
        least = i;
    return least;
  };
  const std::size_t fast = best([](const Answer& a) { return a.turn.seconds; });
  if (fast == 0) return;
  const std::size_t small = best([](const Answer& a) { return a.turn.also; });
  const std::size_t exact = best([](const Answer& a) { return a.error(); });
  const Answer& own = answers[0];
  std::cout << nodes << " nodes: " << over(own.turn.seconds, answers[fast].turn.seconds)
            << " of the seconds of " << programs[fast].name << ", "
            << over(own.turn.also, answers[small].turn.also) << " of the memory of "
            << programs[small].name << ", the larger error " << number(own.error(), "%.4f")
            << " % against " << number(answers[exact].error(), "%.4f") << " % of "
            << programs[exact].name << std::endl;
}

Table curves_of(const std::vector<Program>& programs) {
  std::vector<std::string> names = {"nodes"};
  for (const Program& program : programs)
    for (const char* figure : {"_seconds", "_MB", "_error"}) names.push_back(program.key + figure);
  return Table(names);
}

}  // namespace

bool compare_hertz(const std::vector<Program>& programs, const std::vector<HertzSize>& sizes,
                   const std::filesystem::path& out) {
  Table table({"nodes", "program", "s", "MB", "ours / it, s", "ours / it, MB", "iterations",
               "force [%]", "q0 [%]", "b [%]", "b, fit [%]", "failure"});
  Table curves = curves_of(programs);
  for (const Program& program : programs)
    if (!program.missing.empty()) std::cout << program.name << ": " << program.missing << std::endl;
  const signorini_test::Folder folder;
  bool good = true;
  std::vector<Answer> before(programs.size());
  double last_nodes = std::numeric_limits<double>::infinity();
  for (const HertzSize& size : sizes) {
    const HertzCase now = hertz_case(size.part, folder.path());
    const auto nodes = static_cast<double>(now.n_nodes());
    write_gmsh_file(now);
    std::vector<Answer> answers(programs.size());
    for (std::size_t i = 0; i < programs.size(); ++i) {
      answers[i].failure = reason_to_leave_out(programs[i], before[i], nodes / last_nodes);
      answers[i].left_out = !answers[i].failure.empty();
      if (!answers[i].left_out) programs[i].prepare(now);
    }
    const std::vector<Turn> turns =
        in_turn(programs.size(), size.rounds, [&](std::size_t i, bool first, bool& failed) {
          const Turn turn = answers[i].left_out ? Turn{} : run(programs[i], now, first, answers[i]);
          failed = !answers[i].failure.empty();
          return turn;
        });
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i].turn = turns[i];
    const bool solved = answers[0].failure.empty();
    if (!solved) std::cout << programs[0].name << ": " << answers[0].failure << std::endl;
    good = good && solved &&
           (std::isfinite(last_nodes) || difference_from_library(now, answers[0].rim) <= 1e-9);
    add_rows(programs, answers, now.n_nodes(), table);
    add_curves(answers, now.n_nodes(), curves);
    print_verdict(programs, answers, now.n_nodes());
    before = std::move(answers);
    last_nodes = nodes;
  }
  std::cout << "\nHertz's contact by whole programs: medians of processor time, largest memory; "
               "errors of the contact force\nand of q0 and b as chapter 11 reads them, from the "
               "forces that each program wrote.\n\n"
            << table.markdown() << std::endl;
  write_file(out / "hertz.md", table.markdown());
  write_file(out / "hertz.csv", curves.csv("none"));
  return good;
}

}  // namespace signorini::bench
