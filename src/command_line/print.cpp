#include "command_line/print.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <ostream>

#include "addons/frontal/backend.hpp"
#include "command_line/ambiguity.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index, Eigen::VectorXd;

std::string as_text(double value) { return std::isfinite(value) ? shortest(value) : "-"; }

/// One line for each solver. \param with_objective  also its objective
void print_table(std::ostream& out, const std::vector<Outcome>& outcomes, bool with_objective) {
  std::size_t width = std::strlen("solver");
  for (const Outcome& outcome : outcomes)
    width = std::max(width, std::strlen(outcome.solver->name));
  const int name = static_cast<int>(width);
  out << std::left << std::setw(name) << "solver"
      << "  " << std::setw(21) << "status" << std::right << std::setw(10) << "iterations"
      << std::setw(13) << "certificate" << std::setw(10) << "seconds"
      << (with_objective ? "  objective" : "") << '\n';
  for (const Outcome& outcome : outcomes) {
    out << std::left << std::setw(name) << outcome.solver->name << "  " << std::setw(21)
        << outcome.word << std::right;
    if (!outcome.ran) {
      out << "  " << outcome.why << '\n';
      continue;
    }
    const double worst = outcome.certificate.worst();
    out << std::setw(10) << outcome.iterations << std::setw(13)
        << (std::isfinite(worst) ? number(worst, "%.1e") : "none") << std::setw(10)
        << number(outcome.seconds, "%.1e");
    if (with_objective && outcome.accepted) out << "  " << as_text(outcome.objective);
    if (outcome.status == SolveStatus::Solved && !outcome.accepted) out << "  NOT CONFIRMED";
    out << '\n';
  }
}

/// What it means, or what to try, when there is no solution. \param family  all that could have been asked
void print_hint(std::ostream& out, const std::vector<Outcome>& outcomes,
                const std::vector<Solver>& family) {
  const auto refuted = std::find_if(outcomes.begin(), outcomes.end(), [](const Outcome& outcome) {
    return outcome.ran && outcome.status == SolveStatus::Infeasible;
  });
  if (refuted != outcomes.end()) {
    out << "\nnot solved: " << refuted->solver->name
        << " has proved that the conditions contradict each other\n";
    return;
  }
  out << "\nnot solved";
  const auto nearest =
      std::min_element(outcomes.begin(), outcomes.end(), [](const Outcome& a, const Outcome& b) {
        return a.certificate.worst() < b.certificate.worst();
      });
  if (!nearest->why.empty() && nearest->ran) out << "; " << nearest->why;
  if (outcomes.size() < family.size()) out << "; --solver all tries the whole family";
  out << '\n';
}

void print_columns(std::ostream& out, const char* first, const VectorXd& a, const char* second,
                   const VectorXd& b) {
  out << '\n' << std::setw(6) << "" << std::setw(25) << first << std::setw(25) << second << '\n';
  for (Index i = 0; i < std::max(a.size(), b.size()); ++i) {
    out << std::setw(6) << i + 1 << std::setw(25) << (i < a.size() ? as_text(a(i)) : "");
    if (i < b.size()) out << std::setw(25) << as_text(b(i));
    out << '\n';
  }
}

void print_friction(std::ostream& out, const Outcome& solution) {
  out << '\n' << std::setw(6) << "";
  for (const char* const title : {"force", "gap", "friction force", "slip"})
    out << std::setw(25) << title;
  out << "  does\n";
  for (Index i = 0; i < solution.force.size(); ++i) {
    out << std::setw(6) << i + 1;
    for (const VectorXd* column :
         {&solution.force, &solution.gap, &solution.friction, &solution.slip})
      out << std::setw(25) << as_text((*column)(i));
    out << "  " << signorini::to_string(solution.contact_status[static_cast<std::size_t>(i)])
        << '\n';
  }
}

/// How many pairs do what.
void print_motions(std::ostream& out, const std::vector<ContactStatus>& statuses) {
  out << '\n';
  for (const ContactStatus contact_status :
       {ContactStatus::Open, ContactStatus::Stick, ContactStatus::SlipForward,
        ContactStatus::SlipBackward})
    out << signorini::to_string(contact_status) << ' '
        << std::count(statuses.begin(), statuses.end(), contact_status)
        << (contact_status == ContactStatus::SlipBackward ? "\n" : ", ");
}

/// What speaks for other solutions.
void print_uniqueness_warning(std::ostream& out, const Outcome& outcome) {
  out << "there are other solutions: the determinant of ";
  if (const auto pair = outcome.uniqueness_warning.pair)
    out << "pair " << *pair + 1;  // as the table counts
  else
    out << "the pairs that slide";
  out << ", 1 without friction, is " << number(outcome.uniqueness_warning.determinant, "%.6g")
      << '\n';
}

/// Whether there are other solutions, and what speaks for them: the pair counts from 1 as in the table, 0 being all
/// pairs that slide.
void write_uniqueness(Json& json, const Outcome& outcome) {
  const bool doubtful = outcome.uniqueness == Uniqueness::Doubtful;
  json.key("uniqueness")
      .value(doubtful                                   ? "doubtful"
             : outcome.uniqueness == Uniqueness::Proved ? "proved"
                                                        : "unknown");
  if (!doubtful) return;
  const UniquenessWarning& warning = outcome.uniqueness_warning;
  json.key("uniqueness_warning").object().key("pair").value(warning.pair ? *warning.pair + 1 : 0);
  json.key("determinant").value(warning.determinant).end();
}

/// The solvers and the verdict. \param solution  adds what an accepted solution consists of
template <typename Solution>
void write_outcomes(Json& json, const std::vector<Outcome>& outcomes, bool solved,
                    Solution&& solution) {
  json.key("solved").value(solved).key("solvers").array();
  for (const Outcome& outcome : outcomes) {
    json.object().key("name").value(outcome.solver->name).key("status").value(outcome.word);
    json.key("accepted").value(outcome.accepted);
    if (outcome.ran) {
      json.key("iterations").value(outcome.iterations).key("seconds").value(outcome.seconds);
      json.key("certificate");
      write(json, outcome.certificate);
    }
    if (!outcome.accepted && !outcome.why.empty()) json.key("why").value(outcome.why);
    if (outcome.accepted) solution(outcome);
    json.end();
  }
  json.end();
}

/// Of the documents. It grows by 1 when a member goes, or means something else; not when one is added.
constexpr Index format_version = 2;

}  // namespace

void begin_document(Json& json, const char* kind) {
  json.object().key("format").value("signorini").key("version").value(format_version);
  json.key("program").value(SIGNORINI_VERSION).key("kind").value(kind);
}

void write(Json& json, const Certificate& certificate) {
  json.object();
  json.key("penetration").value(certificate.penetration);
  json.key("tension").value(certificate.tension);
  json.key("complementarity").value(certificate.complementarity);
  json.key("equilibrium").value(certificate.equilibrium);
  json.key("duality_gap").value(certificate.duality_gap);
  if (certificate.cone > 0 || certificate.sliding > 0)
    json.key("cone").value(certificate.cone).key("sliding").value(certificate.sliding);
  json.key("balance").value(certificate.balance);
  json.key("worst").value(certificate.worst());
  json.end();
}

void print_family(std::ostream& out) {
  for (const Solver& solver : all_solvers()) {
    out << solver.name << "\n    " << solver.summary << '\n';
    if (solver.largest > 0) out << "    at most " << solver.largest << " pairs\n";
    if (solver.friction != Takes::No)
      out << (solver.friction == Takes::Only ? "    only problems with friction\n"
                                             : "    also problems with friction\n");
    std::string traits;
    for (const Trait trait : solver.may_fail)
      traits += (traits.empty() ? "" : ", ") + std::string(signorini::to_string(trait));
    out << "    may fail on problems that are: " << (traits.empty() ? "-" : traits) << '\n';
  }
  out << "\nback ends, for --backend:\n";
  for (const Backend& backend : backends())
    out << backend.name << "\n    " << backend.summary << '\n';
  for (const MissingBackend& missing : missing_backends())
    out << missing.name << "\n    not built; it needs " << missing.needed << '\n';
}

void print(std::ostream& out, const std::string& title, const FiledProblem& filed, Matrix kind,
           const std::vector<Outcome>& outcomes) {
  const Index n = filed.problem.free_gap.size();
  out << title << ": " << (filed.has_friction() ? "friction" : "complementarity") << " problem, "
      << n << " pairs, matrix " << to_string(kind) << "\n\n";
  print_table(out, outcomes, false);
  const Outcome* const solution = best(outcomes);
  if (solution == nullptr)
    return print_hint(out, outcomes, filed.has_friction() ? friction_solvers() : solvers());
  if (filed.has_friction()) {
    if (n <= largest_printed) print_friction(out, *solution);
    print_motions(out, solution->contact_status);
    if (solution->uniqueness == Uniqueness::Doubtful) print_uniqueness_warning(out, *solution);
  } else if (n <= largest_printed) {
    print_columns(out, "force z", solution->force, "gap w", solution->gap);
  }
  print_undetermined(out, *solution, n, "force of pair");
  print_agreement(out, outcomes, largest(free_movement(filed.problem)));
  if (filed.has_friction()) return;
  if (filed.known_force.size() == n)
    out << "largest difference from the z of the file: "
        << number((solution->force - filed.known_force).cwiseAbs().maxCoeff(), "%.1e") << '\n';
}

void print(std::ostream& out, const std::string& title, const TwoSidedProgramme& programme,
           const std::vector<Outcome>& outcomes) {
  const Index equations = (programme.lower.array() == programme.upper.array()).count();
  out << title << ": quadratic programme, " << programme.q.size() << " unknowns, "
      << programme.lower.size() << " rows, " << equations << " of them equations\n";
  if (programme.published_optimum)
    out << "published optimum " << as_text(*programme.published_optimum) << '\n';
  out << '\n';
  print_table(out, outcomes, true);
  const Outcome* const solution = best(outcomes);
  if (solution == nullptr) return print_hint(out, outcomes, solvers());
  if (std::max(programme.q.size(), programme.lower.size()) <= largest_printed)
    print_columns(out, "x", solution->unknowns, "multiplier", solution->force);
  print_undetermined(out, *solution, programme.lower.size(), "multiplier of row");
  print_agreement(out, outcomes, 0);
}

void write(Json& json, const FiledProblem& filed, Matrix kind, const std::vector<Outcome>& outcomes,
           bool solved) {
  json.object().key("line").value(static_cast<Index>(filed.line));
  json.key("pairs").value(filed.problem.free_gap.size()).key("matrix").value(to_string(kind));
  write_outcomes(json, outcomes, solved, [&](const Outcome& outcome) {
    json.key("force").value(outcome.force).key("gap").value(outcome.gap);
    write_undetermined(json, outcome, filed.problem.free_gap.size());
    if (!filed.has_friction()) return;
    json.key("friction").value(outcome.friction).key("slip").value(outcome.slip);
    json.key("motion").array();
    for (const ContactStatus contact_status : outcome.contact_status)
      json.value(signorini::to_string(contact_status));
    json.end();
    write_uniqueness(json, outcome);
  });
  write_agreement(json, outcomes, largest(free_movement(filed.problem)));
  json.end();
}

void write(Json& json, const TwoSidedProgramme& programme, const std::vector<Outcome>& outcomes,
           bool solved) {
  json.object().key("unknowns").value(programme.q.size());
  json.key("rows").value(programme.lower.size());
  if (programme.published_optimum)
    json.key("published_optimum").value(*programme.published_optimum);
  write_outcomes(json, outcomes, solved, [&](const Outcome& outcome) {
    json.key("objective").value(outcome.objective).key("x").value(outcome.unknowns);
    json.key("multipliers").value(outcome.force);
    write_undetermined(json, outcome, programme.lower.size());
  });
  write_agreement(json, outcomes, 0);
  json.end();
}

}  // namespace command_line
